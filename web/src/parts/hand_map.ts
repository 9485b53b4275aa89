// A picture of what the elements of a channel tell: on an unfolded hand where their names say where
// they are (hand_layout.ts), else in a grid.
//
//   const picture = handMap(channel, { label: "Touch", unit: "N", onChoose: show });
//   picture.setValues(values, [0, 5]);   // cheap: only elements that change are touched

import type { ChannelData } from "./data";
import { sequenceColour } from "./colour_maps";
import { element } from "./dom";
import { gridLayout, handLayout, type HandLayout } from "./hand_layout";
import { colourBar } from "./legend";
import { attachCursor, type CursorOptions, type CursorPlace } from "./map_cursor";
import { markerPath } from "./markers";
import { rangeOf, readable } from "./numbers";
import { painter } from "./painter";
import { rounded, shape, svg, text } from "./svg";

export interface HandOptions extends CursorOptions {
  unit?: string;
  size?: number; // about how wide, in pixels
  colour?: (share: number) => string;
}

export interface HandPicture {
  element: HTMLElement;
  svg: SVGSVGElement;
  isHand: boolean;
  setValues(values: readonly (number | null)[], range?: readonly [number, number]): void;
  select(element: number | null): void;
}

export function handMap(channel: ChannelData, options: HandOptions): HandPicture {
  const hand = handLayout(channel.elements);
  const layout = hand ?? gridLayout(channel.elements.length, channel.shape);
  const colour = options.colour ?? sequenceColour;
  const drawn = draw(layout, options, colour, hand !== null);
  const readout = element("output", { class: "readout", "aria-live": "polite" });
  let shown: readonly (number | null)[] = [];
  const tell = (i: number) => `${channel.elements[i] ?? ""}: ${readable(shown[i])} ${options.unit ?? ""}`.trim();
  const cursor = attachCursor(drawn.place, readout, tell, options);
  const paint = painter(drawn.place.cells, colour);
  return {
    element: element("div", { class: "hand-map" }, [drawn.place.svg, readout]),
    svg: drawn.place.svg,
    isHand: hand !== null,
    select: cursor.select,
    setValues: (values, range) => {
      const [low, high] = range ?? rangeOf(values) ?? [0, 1];
      shown = values;
      paint(values, low, high);
      drawn.setRange(low, high);
      cursor.refresh();
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

function draw(layout: HandLayout, options: HandOptions, colour: (share: number) => string, isHand: boolean): Drawn {
  const pitch = Math.max(7, Math.min(30, (options.size ?? 320) / layout.width));
  const cells = layout.dots.map((dot, i) => cellAt(dot.x * pitch, dot.y * pitch, pitch, i, isHand));
  const rings = shape("g", { class: "map-rings", "data-transient": "" });
  const width = Math.max(160, layout.width * pitch);
  const below = layout.height * pitch + (isHand ? kNames : 6) + 6;
  const bar = colourBar(width, options.unit ?? "", colour);
  bar.group.setAttribute("transform", `translate(0 ${rounded(below)})`);
  const bones = layout.segments.map((segment) => boneAt(segment, pitch));
  const names = layout.fingers.map(({ name, x, y }) => text(x * pitch, y * pitch + 15, name, { class: "middle muted" }));
  const layer = shape("g", { class: isHand ? "taxels" : "map-cells" }, cells);
  const inner = shape("g", { transform: `translate(${kMargin} ${kMargin})` }, [...bones, ...names, layer, rings, bar.group]);
  const picture = svg(width + 2 * kMargin, below + kBar - 14 + 2 * kMargin, options.label, [inner]);
  const step = (at: number, rows: number, columns: number) => nearestTowards(layout, at, columns, rows);
  const place = { svg: picture, cells, rings, kind: isHand ? "hand" : "grid", cellName: "elements", step };
  return { place, setRange: bar.setRange };
}

function cellAt(x: number, y: number, pitch: number, i: number, isHand: boolean): SVGPathElement {
  return shape("path", { d: markerPath(isHand ? 0 : 1, x, y, pitch * (isHand ? 0.42 : 0.56)), fill: "none", "data-cell": i });
}

function boneAt(box: { x: number; y: number; width: number; height: number }, pitch: number): SVGRectElement {
  const [x, y] = [rounded(box.x * pitch), rounded(box.y * pitch)];
  const [width, height] = [rounded(box.width * pitch), rounded(box.height * pitch)];
  return shape("rect", { x, y, width, height, rx: rounded(pitch * 0.5), class: "bone" });
}

/** The nearest element that lies more in this direction than beside it; else the same. */
export function nearestTowards(layout: HandLayout, from: number, dx: number, dy: number): number {
  const at = layout.dots[from];
  if (!at) return from;
  let best = from;
  let least = Number.POSITIVE_INFINITY;
  layout.dots.forEach((dot, i) => {
    const along = (dot.x - at.x) * dx + (dot.y - at.y) * dy;
    const beside = Math.abs((dot.x - at.x) * dy) + Math.abs((dot.y - at.y) * dx);
    if (along < 0.2 || beside > along + 0.3 || along + beside >= least) return;
    least = along + beside;
    best = i;
  });
  return best;
}
