// The values of an ordered channel, such as a spectrum, as a line; one element at a time is pointed
// at and selected, as on a hand.

import type { NumberOrNull } from "../../parts/data";
import type { HandOptions, HandPicture } from "../../parts/hands/hand_map";
import { cellPicture, type CursorPlace } from "../../parts/maps/map_cursor";
import { rangeOf, readable, withUnit } from "../../parts/numbers";
import { rounded, shape, svg, text } from "../../parts/svg";

/** The places of the elements along the horizontal axis. */
export interface Axis {
  name: string;
  unit: string;
  values: number[]; // of each element, increasing
}

const kHeight = 220;
const kLeft = 48;
const kTop = 10;
const kBelow = 38;

export function linePicture(axis: Axis, options: HandOptions): HandPicture {
  const width = options.size ?? 380;
  const last = axis.values.length - 1;
  const [from, to] = [axis.values[0] ?? 0, axis.values[last] ?? 1];
  const x = (i: number) => kLeft + ((axis.values[i]! - from) / (to - from || 1)) * width;
  const edge = (i: number) => (i < 0 ? kLeft : i >= last ? kLeft + width : (x(i) + x(i + 1)) / 2);
  const cells = axis.values.map((_, i) =>
    shape("path", {
      d: `M${rounded(edge(i - 1))} ${kTop}H${rounded(edge(i))}V${kTop + kHeight}H${rounded(edge(i - 1))}Z`,
      "data-cell": i,
    }),
  );
  const [line, zero] = [shape("path", { class: "plot-line" }), shape("path", { class: "rule" })];
  const [low, high] = [text(kLeft - 6, kTop + kHeight, "", { class: "end muted" }), text(kLeft - 6, kTop + 10, "", { class: "end muted" })];
  const rings = shape("g", { class: "map-rings", "data-transient": "" });
  const below = kTop + kHeight + 16;
  const ends = [
    text(kLeft, below, readable(from), { class: "muted" }),
    text(kLeft + width / 2, below, withUnit(axis.name, axis.unit === "" ? "" : `(${axis.unit})`), { class: "muted middle" }),
    text(kLeft + width, below, readable(to), { class: "muted end" }),
    text(kLeft + 6, kTop + 10, options.unit ?? "", { class: "muted" }),
  ];
  const frame = shape("rect", { x: kLeft, y: kTop, width, height: kHeight, class: "rule" });
  const hidden = shape("g", { class: "line-cells", "data-transient": "" }, cells);
  const picture = svg(kLeft + width + 8, kTop + kHeight + kBelow, options.label, [frame, zero, line, low, high, ...ends, rings, hidden]);
  const clamp = (i: number) => Math.min(last, Math.max(0, i));
  const step = (at: number, _rows: number, columns: number) => clamp(at + columns);
  const place: CursorPlace = { svg: picture, cells, rings, kind: "plot", cellName: "elements", step };
  let shown: readonly NumberOrNull[] = [];
  const describe = (i: number) =>
    `${withUnit(readable(axis.values[i]), axis.unit)}: ${withUnit(readable(shown[i]), options.unit ?? "")}`;
  const drawn = cellPicture(place, "line-picture", describe, options);
  return {
    ...drawn,
    isHand: false,
    setValues: (values, range) => {
      const [least, most] = range ?? rangeOf(values) ?? [0, 1];
      const y = (value: number) => kTop + kHeight * (1 - (value - least) / (most - least || 1));
      shown = values;
      line.setAttribute("d", pathOf(values, x, y));
      zero.setAttribute("d", least < 0 && most > 0 ? `M${kLeft} ${rounded(y(0))}h${width}` : "");
      low.textContent = readable(least);
      high.textContent = readable(most);
      drawn.refresh();
    },
  };
}

/** A line that is interrupted where a value is missing. */
function pathOf(values: readonly NumberOrNull[], x: (i: number) => number, y: (value: number) => number): string {
  let isDown = false;
  return values
    .map((value, i) => {
      if (value === null || !Number.isFinite(value)) {
        isDown = false;
        return "";
      }
      const command = isDown ? "L" : "M";
      isDown = true;
      return `${command}${rounded(x(i))} ${rounded(y(value))}`;
    })
    .join("");
}
