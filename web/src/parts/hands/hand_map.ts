// A picture of the values of a channel, with each element at its place (skin_layout.ts).
//
//   const picture = handMap(channel, { label: "Touch", unit: "N", onChoose: show });
//   picture.setValues(values, [0, 5]);   // cheap: only changed elements are updated

import type { ChannelData } from "../data";
import { sequenceColour } from "../maps/colour_maps";
import type { HandLayout } from "./hand_layout";
import { groupsOf, skinLayout } from "./skin_layout";
import { colourBar } from "../maps/legend";
import { cellPicture, type CellPicture, type CursorOptions, type CursorPlace } from "../maps/map_cursor";
import { markerPath } from "../maps/markers";
import { rangeOf, readable, withUnit } from "../numbers";
import { painter } from "../maps/painter";
import { rounded, shape, svg, text, type Box } from "../svg";
import { nearestTowards } from "./towards";

export interface HandOptions extends CursorOptions {
  unit?: string;
  size?: number; // about how wide, in pixels
  mostPitch?: number; // between elements, in pixels; 30 unless given
  palm?: boolean; // whether a palm joins the fingers, with their names
  colour?: (share: number) => string;
}

export interface HandPicture extends CellPicture {
  isHand: boolean;
  setValues(values: readonly (number | null)[], range?: readonly [number, number]): void;
}

export function handMap(channel: ChannelData, options: HandOptions): HandPicture {
  const layout = skinLayout(channel);
  const colour = options.colour ?? sequenceColour;
  const drawn = draw(layout, options, colour);
  let shown: readonly (number | null)[] = [];
  const describe = (i: number) =>
    `${[...groupsOf(channel, i), channel.elements[i] ?? ""].join(", ")}: ${withUnit(readable(shown[i]), options.unit ?? "")}`;
  const picture = cellPicture(drawn.place, "hand-map", describe, options);
  const paint = painter(drawn.place.cells, colour);
  return {
    ...picture,
    isHand: layout.kind === "hand",
    setValues: (values, range) => {
      const [low, high] = range ?? rangeOf(values) ?? [0, 1];
      shown = values;
      paint(values, low, high);
      drawn.setRange(low, high);
      picture.refresh();
    },
  };
}

interface Drawn {
  place: CursorPlace;
  setRange(low: number, high: number): void;
}

const kMargin = 4;
const kNames = 22;
const kBar = 44;

function draw(
  layout: HandLayout,
  options: HandOptions,
  colour: (share: number) => string,
): Drawn {
  const isHand = layout.kind === "hand";
  const isGrid = layout.kind === "grid";
  const pitch = Math.max(7, Math.min(options.mostPitch ?? 30, (options.size ?? 320) / layout.width));
  const cells = layout.dots.map((dot, i) => cellAt(dot.x * pitch, dot.y * pitch, pitch, i, !isGrid));
  const rings = shape("g", { class: "map-rings", "data-transient": "" });
  const width = Math.max(160, layout.width * pitch);
  const below = layout.height * pitch + (layout.fingers.length > 0 ? kNames : 6) + 6;
  const bar = colourBar(width, options.unit ?? "", colour);
  bar.group.setAttribute("transform", `translate(0 ${rounded(below)})`);
  const bones = layout.segments.map((segment) => boneAt(segment, pitch, pitch, pitch / 2));
  if (layout.background !== undefined) for (const bone of bones) bone.classList.add("outlined");
  const names = layout.fingers.map(({ name, x, y }) =>
    text(x * pitch, y * pitch + 15, name, { class: isHand ? "middle muted" : "middle muted group-name" }),
  );
  const palm = options.palm && isHand ? palmBelow(layout.width * pitch, layout.height * pitch) : null;
  const layer = shape("g", { class: isGrid ? "map-cells" : "taxels" }, cells);
  const aside = rounded((width - layout.width * pitch) / 2); // in the middle above a wider colour bar
  const skin = [palm, backgroundOf(layout, pitch), ...bones, layer, ...names, rings];
  const inner = shape("g", { transform: `translate(${kMargin} ${kMargin})` }, [
    shape("g", { transform: `translate(${aside} 0)` }, skin),
    bar.group,
  ]);
  const picture = svg(width + 2 * kMargin, below + kBar - 14 + 2 * kMargin, options.label, [inner]);
  const step = (at: number, rows: number, columns: number) => nearestTowards(layout.dots, at, columns, rows);
  const place = { svg: picture, cells, rings, kind: layout.kind === "placed" ? "skin" : layout.kind, cellName: "elements", step };
  return { place, setRange: bar.setRange };
}

/** The fingers stand on it. */
function palmBelow(width: number, top: number): SVGPathElement {
  const [corner, below] = [12, kNames + 3];
  const d = `M0 ${rounded(top - 6)}H${rounded(width)}V${rounded(top + below - corner)}q0 ${corner} ${-corner} ${corner}H${corner}q${-corner} 0 ${-corner} ${-corner}Z`;
  return shape("path", { d, class: "palm" });
}

function backgroundOf({ background }: HandLayout, pitch: number): SVGImageElement | null {
  if (background === undefined) return null;
  const { image, x, y, width, height } = background;
  const box = { x: rounded(x * pitch), y: rounded(y * pitch), width: rounded(width * pitch), height: rounded(height * pitch) };
  return shape("image", { ...box, href: image, preserveAspectRatio: "none" });
}

function cellAt(x: number, y: number, pitch: number, i: number, isRound: boolean): SVGPathElement {
  return shape("path", {
    d: markerPath(isRound ? 0 : 1, x, y, pitch * (isRound ? 0.42 : 0.56)),
    fill: "none",
    "data-cell": i,
  });
}

/** A segment of a finger; `wide` and `tall` are pixels between elements, `corner` is a radius in pixels. */
export function boneAt(box: Box, wide: number, tall: number, corner: number): SVGRectElement {
  const [x, y] = [rounded(box.x * wide), rounded(box.y * tall)];
  const [width, height] = [rounded(box.width * wide), rounded(box.height * tall)];
  return shape("rect", { x, y, width, height, rx: rounded(corner), class: "bone" });
}
