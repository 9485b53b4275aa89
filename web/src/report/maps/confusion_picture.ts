// A picture of a confusion matrix: darker cells have a larger share of their row.

import { cellPicture, type CellPicture, type CursorPlace } from "../../parts/maps/map_cursor";
import { percent } from "../../parts/numbers";
import { rounded, shape, shortened, svg, text, textWidth } from "../../parts/svg";

export interface Counts {
  classes: string[];
  counts: number[][]; // counts[true][named]
}

interface Sizes {
  cell: number;
  left: number; // room for the names of rows
  top: number; // and of columns
}

const kLongest = 130;
const kDarkest = 0.5; // numbers stay readable on it

export function confusionPicture(of: Counts, label: string): CellPicture {
  const sizes = sizesFor(of.classes);
  const totals = of.counts.map((row) => row.reduce((sum, count) => sum + count, 0));
  const cells = cellsOf(of, totals, sizes);
  const rings = shape("g", { "data-transient": "" });
  const side = of.classes.length * sizes.cell;
  const drawn = [
    shape("g", { class: "map-cells" }, cells),
    ...numbersOf(of, sizes),
    ...namesOf(of.classes, sizes),
    rings,
  ];
  const picture = svg(sizes.left * 1.6 + side, sizes.top + side + 4, label, drawn);
  const step = (at: number, rows: number, columns: number) => stepped(of.classes.length, at, rows, columns);
  const place: CursorPlace = { svg: picture, cells, rings, kind: "table", cellName: "cells", step };
  return cellPicture(place, null, (cell) => tellOf(of, totals, cell), { label });
}

function sizesFor(classes: string[]): Sizes {
  const cell = Math.max(14, Math.min(44, 420 / classes.length));
  const left = Math.min(kLongest, Math.max(...classes.map((name) => textWidth(name, 12)))) + 10;
  return { cell, left, top: left * 0.75 + 8 };
}

function cellsOf({ counts }: Counts, totals: number[], { cell, left, top }: Sizes): SVGPathElement[] {
  const side = rounded(cell);
  return counts.flatMap((row, i) =>
    row.map((count, j) => {
      const d = `M${rounded(left + j * cell)} ${rounded(top + i * cell)}h${side}v${side}h${-side}Z`;
      const opacity = rounded(0.08 + kDarkest * (count / (totals[i] || 1)));
      const fill = count === 0 ? { fill: "none" } : { fill: "var(--class-0)", "fill-opacity": opacity };
      return shape("path", { d, ...fill, "data-cell": i * row.length + j });
    }),
  );
}

function numbersOf({ counts }: Counts, { cell, left, top }: Sizes): SVGElement[] {
  if (cell < 22) return [];
  return counts.flatMap((row, i) =>
    row.flatMap((count, j) => {
      const kind = count >= 1000 ? "middle note" : "middle";
      const [x, y] = [left + (j + 0.5) * cell, top + (i + 0.5) * cell + 4];
      return count === 0 ? [] : [text(x, y, String(count), { class: kind })];
    }),
  );
}

function namesOf(classes: string[], { cell, left, top }: Sizes): SVGElement[] {
  return classes.flatMap((name, i) => {
    const words = shortened(name, left - 10, 12);
    const middle = (i + 0.5) * cell;
    const turned = `translate(${rounded(left + middle + 3)} ${rounded(top - 6)}) rotate(-50)`;
    return [
      text(left - 8, top + middle + 4, words, { class: "end" }),
      text(0, 0, words, { transform: turned }),
    ];
  });
}

function tellOf({ classes, counts }: Counts, totals: number[], cell: number): string {
  const [i, j] = [Math.floor(cell / classes.length), cell % classes.length];
  const count = counts[i]?.[j] ?? 0;
  const share = percent(count / (totals[i] || 1));
  return `${classes[i] ?? ""} named ${classes[j] ?? ""}: ${count} of ${totals[i] ?? 0} (${share})`;
}

function stepped(size: number, at: number, rows: number, columns: number): number {
  const clamp = (to: number) => Math.min(size - 1, Math.max(0, to));
  return clamp(Math.floor(at / size) + rows) * size + clamp((at % size) + columns);
}
