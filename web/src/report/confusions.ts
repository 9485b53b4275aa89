// What was named for what: rows are the true classes, columns what was said.

import type { Table } from "../parts/csv";
import { element } from "../parts/dom";
import { attachCursor, type CursorPlace } from "../parts/map_cursor";
import { percent } from "../parts/numbers";
import { rounded, shape, shortened, svg, text, textWidth } from "../parts/svg";
import type { RunData, SystemReport } from "./data";
import { classesOf, predictionsOf, valuesOf } from "./labels";
import { liveFigure, nothing, type Drawn } from "./live_figure";
import type { Selection } from "./selection";
import { runWords } from "./toolbar";
import { protocolName, systemName } from "./words";

/** Over all runs, and in the chosen one. */
export function confusionFigures(system: SystemReport, selection: Selection): HTMLElement[] {
  return [true, false].map((isAll) => {
    const options = {
      title: isAll ? "Confusions over all runs" : "Confusions of the chosen seed",
      file: `${systemName(system)}-confusions${isAll ? "" : "-of-seed"}`,
      note: isAll ? "A row is a true class, a column what was named; the colour is the share of its row." : "",
    };
    return liveFigure(options, selection, () => draw(system, selection, isAll)).element;
  });
}

function draw(system: SystemReport, selection: Selection, isAll: boolean): Drawn {
  const { protocol, run, label } = selection;
  if (!protocol || !run) return nothing("There is no run of this protocol.");
  const counts = countsOf(system, selection, isAll ? protocol.runs : [run]);
  if (!counts) return nothing(`What was named is not known for the label ${label} under this protocol.`);
  const runs = isAll ? `all ${protocol.runs.length} runs` : `seed ${runWords(selection)}`;
  const words = `${protocolName(protocol)}, by ${label}, ${runs}`;
  const picture = confusionPicture(counts, `Confusions: ${words}`);
  const what = element("p", { class: "small what" }, [words]);
  return { body: [what, picture.element], svg: picture.svg, table: tableOf(counts) };
}

interface Counts {
  classes: string[];
  counts: number[][]; // counts[true][named]
}

function countsOf(system: SystemReport, { protocol, label }: Selection, runs: RunData[]): Counts | null {
  if (!protocol) return null;
  const pairs: [string, string][] = [];
  for (const run of runs) {
    const [truth, named] = [valuesOf(system, protocol, run, label), predictionsOf(protocol, run, label)];
    if (truth && named) truth.forEach((value, i) => pairs.push([value, named[i] ?? ""]));
  }
  if (pairs.length === 0) return null;
  const classes = [...new Set([...classesOf(system, label), ...pairs.map(([, named]) => named)])];
  const number = new Map(classes.map((name, i) => [name, i]));
  const counts = classes.map(() => new Array<number>(classes.length).fill(0));
  for (const [truth, named] of pairs) {
    const row = counts[number.get(truth) ?? 0];
    const column = number.get(named) ?? 0;
    if (row) row[column] = (row[column] ?? 0) + 1;
  }
  return { classes, counts };
}

function tableOf({ classes, counts }: Counts): Table {
  return { columns: ["true class", ...classes], rows: classes.map((name, i) => [name, ...(counts[i] ?? [])]) };
}

const kLongest = 130;
const kDarkest = 0.5; // numbers stay readable on it

function confusionPicture({ classes, counts }: Counts, label: string) {
  const size = Math.max(14, Math.min(44, 420 / classes.length));
  const left = Math.min(kLongest, Math.max(...classes.map((name) => textWidth(name, 12)))) + 10;
  const top = left * 0.75 + 8;
  const rings = shape("g", { "data-transient": "" });
  const cells: SVGPathElement[] = [];
  const numbers: SVGElement[] = [];
  const totals = counts.map((row) => row.reduce((sum, count) => sum + count, 0));
  counts.forEach((row, i) =>
    row.forEach((count, j) => {
      const fill = count === 0 ? "none" : "var(--class-0)";
      const opacity = 0.08 + kDarkest * (count / (totals[i] || 1));
      const [x, y] = [left + j * size, top + i * size];
      cells.push(shape("path", { d: `M${rounded(x)} ${rounded(y)}h${rounded(size)}v${rounded(size)}h${rounded(-size)}Z`, fill, "fill-opacity": count === 0 ? 1 : rounded(opacity), "data-cell": cells.length }));
      if (count > 0 && size >= 22) numbers.push(numberAt(x + size / 2, y + size / 2 + 4, count));
    }),
  );
  const names = classes.flatMap((name, i) => {
    const words = shortened(name, left - 10, 12);
    const middle = (i + 0.5) * size;
    const column = text(0, 0, words, { transform: `translate(${rounded(left + middle + 3)} ${rounded(top - 6)}) rotate(-50)` });
    const row = text(left - 8, top + middle + 4, words, { class: "end" });
    return [row, column];
  });
  const side = classes.length * size;
  const picture = svg(left + side + left * 0.6, top + side + 4, label, [shape("g", { class: "map-cells" }, cells), ...numbers, ...names, rings]);
  const readout = element("output", { class: "readout", "aria-live": "polite" });
  const step = (at: number, rows: number, columns: number) => stepped(classes.length, at, rows, columns);
  const place: CursorPlace = { svg: picture, cells, rings, kind: "table", cellName: "cells", step };
  const tell = (cell: number) => tellOf(classes, counts, totals, cell);
  attachCursor(place, readout, tell, { label });
  return { svg: picture, element: element("div", {}, [picture, readout]) };
}

function numberAt(x: number, y: number, count: number): SVGTextElement {
  return text(x, y, String(count), { class: count >= 1000 ? "middle note" : "middle" });
}

function tellOf(classes: string[], counts: number[][], totals: number[], cell: number): string {
  const [i, j] = [Math.floor(cell / classes.length), cell % classes.length];
  const count = counts[i]?.[j] ?? 0;
  return `${classes[i] ?? ""} named ${classes[j] ?? ""}: ${count} of ${totals[i] ?? 0} (${percent(count / (totals[i] || 1))})`;
}

function stepped(size: number, at: number, rows: number, columns: number): number {
  const clamp = (to: number) => Math.min(size - 1, Math.max(0, to));
  return clamp(Math.floor(at / size) + rows) * size + clamp((at % size) + columns);
}
