// The component planes of all elements of a channel at once: a small map for each, at its place on
// the hand where the names tell of one.

import { between, kSequence, sequenceColour } from "../parts/colour_maps";
import type { ChannelPlanes, GridData } from "../parts/data";
import { element, type Child } from "../parts/dom";
import { figure } from "../parts/figure";
import { columnOf, isHexagonal, rowOf } from "../parts/grid";
import { gridLayout, handLayout, type HandLayout } from "../parts/hand_layout";
import { colourBar } from "../parts/legend";
import { rounded, shape, shortened, svg, text } from "../parts/svg";
import { neuronTable } from "./system_map";

const kMost = 120; // more are too small to see
const kPitch = 60;
const kNamedPitch = 104; // where there is room, for the names below
const kGap = 7;
const kName = 13;

export function allPlanesFigure(
  grid: GridData,
  planes: ChannelPlanes,
  range: [number, number],
  file: string,
  onChoose: (element: number) => void,
): Child {
  const { channel } = planes;
  if (channel.elements.length < 2 || channel.elements.length > kMost) return null;
  const hand = handLayout(channel.elements);
  const layout = hand ?? gridLayout(channel.elements.length, channel.shape);
  const picture = draw(grid, planes, range, layout, hand === null);
  picture.addEventListener("click", (event) => {
    const number = event.target instanceof Element ? event.target.getAttribute("data-element") : null;
    if (number !== null) onChoose(Number(number));
  });
  return figure({
    title: hand
      ? `The map by every element of ${channel.name}, each at its place on the hand`
      : `The map by every element of ${channel.name}`,
    file: `${file}-planes`,
    body: element("div", { class: "all-planes" }, [picture]),
    picture: () => picture,
    numbers: () => neuronTable(grid, channel.elements, (i) => planes.values[i] ?? []),
    note: "All in the same colours. A click chooses the element for the figures above.",
    wide: true,
  });
}

function draw(
  grid: GridData,
  planes: ChannelPlanes,
  range: [number, number],
  layout: HandLayout,
  isNamed: boolean,
): SVGSVGElement {
  const { channel, unit } = planes;
  const pitch = pitchFor(layout, isNamed);
  const tall = pitch + (isNamed ? kName : 0);
  const [width, height] = [layout.width * pitch, layout.height * tall];
  const bones = layout.segments.map((one) =>
    shape("rect", {
      x: rounded(one.x * pitch),
      y: rounded(one.y * tall),
      width: rounded(one.width * pitch),
      height: rounded(one.height * tall),
      rx: 14,
      class: "bone",
    }),
  );
  const maps = layout.dots.map(({ x, y }, i) =>
    planeAt(grid, planes, range, i, { x: (x - 0.5) * pitch, y: (y - 0.5) * tall, pitch }),
  );
  const words = isNamed
    ? layout.dots.map(({ x, y }, i) =>
        nameAt(channel.elements[i] ?? "", x * pitch, (y + 0.5) * tall - 5, pitch),
      )
    : [];
  const fingers = layout.fingers.map(({ name, x, y }) =>
    text(x * pitch, y * tall + 16, name, { class: "middle muted" }),
  );
  const below = height + (layout.fingers.length > 0 ? 30 : 8);
  const bar = colourBar(Math.min(320, Math.max(180, width)), unit, sequenceColour);
  bar.setRange(range[0], range[1]);
  bar.group.setAttribute("transform", `translate(0 ${rounded(below)})`);
  const label = `Component planes of all ${channel.elements.length} elements of ${channel.name}`;
  return svg(Math.max(width, 190), below + 30, label, [...bones, ...maps, ...words, ...fingers, bar.group]);
}

const kWide = 880;

/** As large as fits beside each other. */
function pitchFor(layout: HandLayout, isNamed: boolean): number {
  return isNamed ? Math.max(kPitch, Math.min(kNamedPitch, kWide / layout.width)) : kPitch;
}

function nameAt(name: string, x: number, y: number, pitch: number): SVGTextElement {
  return text(x, y, shortened(name, pitch - 4, 11), { class: "middle muted note" });
}

function planeAt(
  grid: GridData,
  planes: ChannelPlanes,
  range: [number, number],
  which: number,
  { x, y, pitch }: { x: number; y: number; pitch: number },
): SVGElement {
  const href = pixels(
    grid,
    planes.values.map((values) => values[which] ?? null),
    range,
  );
  const side = pitch - kGap;
  const image = shape("image", {
    x: rounded(x + kGap / 2),
    y: rounded(y + kGap / 2),
    width: side,
    height: side,
    href,
    preserveAspectRatio: "none",
    "data-element": which,
    style: "image-rendering:pixelated",
  });
  image.append(shape("title", {}, [planes.channel.elements[which] ?? ""]));
  return image;
}

/** Two pixels a neuron side by side, so that odd rows of a hexagonal map can be shifted by one. */
function pixels(grid: GridData, values: (number | null)[], [low, high]: [number, number]): string {
  const shift = isHexagonal(grid) && grid.rows > 1 ? 1 : 0;
  const canvas = element("canvas", { width: 2 * grid.columns + shift, height: grid.rows });
  const context = canvas.getContext("2d");
  if (!context) return "";
  const image = context.createImageData(canvas.width, canvas.height);
  values.forEach((value, neuron) => {
    if (value === null || !Number.isFinite(value)) return;
    const colour = between(kSequence, high > low ? (value - low) / (high - low) : 0);
    const row = rowOf(grid, neuron);
    const at = 4 * (row * canvas.width + 2 * columnOf(grid, neuron) + (row % 2) * shift);
    image.data.set([...colour, 255, ...colour, 255], at);
  });
  context.putImageData(image, 0, 0);
  return canvas.toDataURL("image/png");
}
