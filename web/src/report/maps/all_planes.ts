// The component planes of all elements of a channel at once: a small map for each, at its place on
// the hand if the names identify it.

import { sequenceColour } from "../../parts/maps/colour_maps";
import type { ChannelPlanes, GridData } from "../../parts/data";
import { element, type Child } from "../../parts/dom";
import { figure, type Shown } from "../../parts/figure";
import { neuronAtPixel, pixelColumns, pixelRows } from "../../parts/maps/grid";
import type { HandLayout } from "../../parts/hands/hand_layout";
import { boneAt } from "../../parts/hands/hand_map";
import { skinLayout } from "../../parts/hands/skin_layout";
import { colourBar } from "../../parts/maps/legend";
import { pixelImage, pixelRamp, scaled } from "../../parts/maps/painter";
import { rounded, shape, shortened, svg, text } from "../../parts/svg";
import { neuronTable } from "./system_map";

const kArranged = { hand: ", arranged on the hand", placed: ", arranged on the skin", grid: "" };
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
  shown: Shown,
): Child {
  const { channel } = planes;
  if (channel.elements.length < 2 || channel.elements.length > kMost) return null;
  const layout = skinLayout(channel);
  const picture = draw(grid, planes, range, layout, layout.kind === "grid");
  picture.addEventListener("click", (event) => {
    const number = event.target instanceof Element ? event.target.getAttribute("data-element") : null;
    if (number !== null) onChoose(Number(number));
  });
  return figure({
    title: `Component planes of ${channel.name}${kArranged[layout.kind]}`,
    file: `${file}-planes`,
    body: element("div", { class: "all-planes" }, [picture]),
    picture: () => picture,
    numbers: () => neuronTable(grid, channel.elements, (i) => planes.values[i] ?? []),
    about: () => shown,
    note: "All panels share one colour scale.",
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
  const bones = layout.segments.map((one) => boneAt(one, pitch, tall, 14));
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

/** The largest size that fits side by side. */
function pitchFor(layout: HandLayout, isNamed: boolean): number {
  return isNamed ? Math.max(kPitch, Math.min(kNamedPitch, kWide / layout.width)) : kPitch;
}

function nameAt(name: string, x: number, y: number, pitch: number): SVGTextElement {
  return text(x, y, shortened(name, pitch - 4, 11), { class: "middle muted note" });
}

const planePixel = pixelRamp(sequenceColour);

function planeAt(
  grid: GridData,
  planes: ChannelPlanes,
  range: [number, number],
  which: number,
  { x, y, pitch }: { x: number; y: number; pitch: number },
): SVGElement {
  const side = pitch - kGap;
  const box = { x: rounded(x + kGap / 2), y: rounded(y + kGap / 2), width: side, height: side };
  const colour = scaled(planePixel, ...range);
  const at = (column: number, row: number) => {
    const neuron = neuronAtPixel(grid, column, row);
    return neuron === null ? null : colour(planes.values[neuron]?.[which]);
  };
  const image = pixelImage(box, pixelColumns(grid), pixelRows(grid), at);
  image.setAttribute("data-element", String(which));
  image.append(shape("title", {}, [planes.channel.elements[which] ?? ""]));
  return image;
}
