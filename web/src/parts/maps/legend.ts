// Legends, as parts of a picture: a bar of colours with its ends, and markers with names.

import { uniqueId, write } from "../dom";
import { marker } from "./markers";
import { readable } from "../numbers";
import { rounded, shape, shortened, svg, text, textWidth } from "../svg";

export interface ColourBar {
  group: SVGGElement;
  setRange(low: number, high: number): void;
}

const kStops = 16;

/** 44 pixels tall at most. */
export function colourBar(width: number, unit: string, colour: (share: number) => string): ColourBar {
  const id = uniqueId("colours");
  const stops = Array.from({ length: kStops + 1 }, (_, i) =>
    shape("stop", { offset: rounded(i / kStops), "stop-color": colour(i / kStops) }),
  );
  const gradient = shape("linearGradient", { id }, stops);
  const bar = shape("rect", { x: 0, y: 0, width: rounded(width), height: 9, fill: `url(#${id})` });
  const low = text(0, 25, "");
  const high = text(width, 25, "", { class: "end" });
  const middle = text(width / 2, 25, unit, { class: "middle muted" });
  const group = shape("g", { class: "colour-bar" }, [shape("defs", {}, [gradient]), bar, low, middle, high]);
  const setRange = (from: number, to: number) => {
    write(low, readable(from));
    write(high, readable(to));
  };
  return { group, setRange };
}

const kRow = 20;
const kTall = 5; // rows: of more names long ones are shortened, so that they stand in two columns

/** Markers of the classes in columns, with `counts` beside the names unless `hasCounts` is false; classes with a count of 0 are left out. */
export function markerLegend(
  width: number,
  names: readonly string[],
  counts: readonly number[] = [],
  hasCounts = true,
): { group: SVGGElement; height: number } {
  const words = names.flatMap((name, number) => {
    const count = counts[number];
    if (count === 0) return [];
    return [{ number, name, label: count === undefined || !hasCounts ? name : `${name} (${count})` }];
  });
  const room = words.length > kTall ? width / 2 : width;
  const widest = Math.min(room, 34 + Math.max(24, ...words.map(({ label }) => textWidth(label, 12))));
  const columns = Math.max(1, Math.floor(width / widest));
  const rows = Math.ceil(words.length / columns);
  const group = shape("g", { class: "marker-legend" });
  words.forEach(({ number, name, label: whole }, i) => {
    const x = Math.floor(i / rows) * widest;
    const y = (i % rows) * kRow + 8;
    const label = text(x + 20, y + 4, shortened(whole, widest - 22, 12));
    label.append(shape("title", {}, [name]));
    group.append(marker(number, x + 8, y, 5), label);
  });
  return { group, height: rows * kRow };
}

/** A picture of the markers of the classes. */
export function classLegend(names: readonly string[]): SVGSVGElement {
  const { group, height } = markerLegend(380, names);
  return svg(380, height, `Classes: ${names.join(", ")}`, [group]);
}
