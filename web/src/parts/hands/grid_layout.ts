// Elements in a grid without holes: by the shape of their channel, by the rows and columns of their
// names ("t00", "taxel_0_3", "r1c2"), or as square as possible. The pictures of the program have the
// same grid (src/views/skins/grid_layout.cc).

import type { HandLayout } from "./hand_layout";

const kLongestRow = 32; // of elements without a shape

type Cell = readonly [row: number, column: number];

export function gridLayout(elements: readonly string[], shape: readonly number[]): HandLayout {
  const named = columnsOfShape(shape) === 0 ? namedCells(elements) : null;
  const columns = Math.max(1, Math.min(elements.length, columnsOfShape(shape) || squarest(elements.length)));
  const cells = named ?? elements.map((_, i): Cell => [Math.floor(i / columns), i % columns]);
  const extent = (axis: 0 | 1) => Math.max(0, ...cells.map((cell) => cell[axis] + 1));
  const dots = cells.map(([row, column]) => ({ x: column + 0.5, y: row + 0.5 }));
  return { kind: "grid", width: Math.max(1, extent(1)), height: extent(0), dots, segments: [], fingers: [] };
}

/** Whether shape or names give rows and columns. */
export function hasGrid(elements: readonly string[], shape: readonly number[]): boolean {
  return columnsOfShape(shape) > 0 || namedCells(elements) !== null;
}

/** The last axis, if two are longer than 1; else 0. */
function columnsOfShape(shape: readonly number[]): number {
  const axes = shape.filter((length) => length > 1);
  return axes.length > 1 ? axes.at(-1)! : 0;
}

/** With the most rows that have no hole; many elements without such rows have a shorter last row. */
function squarest(count: number): number {
  let rows = Math.floor(Math.sqrt(count));
  while (rows > 1 && count % rows !== 0) rows -= 1;
  const columns = count / Math.max(rows, 1);
  return columns <= kLongestRow || columns <= 4 * rows ? columns : Math.ceil(Math.sqrt(count * 2));
}

function namedCells(elements: readonly string[]): Cell[] | null {
  return fullGrid(elements.map(numbersOf)) ?? fullGrid(elements.map(digitsOf));
}

/** Null unless the names fill all cells between their first and last row and column, each once. */
function fullGrid(found: readonly (Indices | null)[]): Cell[] | null {
  const first = found[0];
  if (!first || found.some((one) => one?.around !== first.around)) return null;
  const cells = found.map((one) => one!.cell);
  const [rows, row] = extentOf(cells.map(([one]) => one));
  const [columns, column] = extentOf(cells.map(([, one]) => one));
  const distinct = new Set(cells.map(String)).size;
  if (rows < 2 || columns < 2 || distinct !== cells.length || rows * columns !== cells.length) return null;
  return cells.map((cell): Cell => [cell[0] - row, cell[1] - column]);
}

function extentOf(numbers: readonly number[]): [count: number, least: number] {
  const least = numbers.reduce((one, other) => Math.min(one, other));
  return [numbers.reduce((one, other) => Math.max(one, other)) - least + 1, least];
}

interface Indices {
  around: string; // the rest of the name
  cell: Cell;
}

/** Two numbers with something between them, at the end of a name. */
function numbersOf(name: string): Indices | null {
  const match = /^(|.*?\D)(\d+)(\D+)(\d+)$/su.exec(name);
  return match && { around: JSON.stringify([match[1], match[3]]), cell: [Number(match[2]), Number(match[4])] };
}

/** Two digits at the end of a name. */
function digitsOf(name: string): Indices | null {
  const match = /^(|.*\D)(\d)(\d)$/su.exec(name);
  return match && { around: match[1]!, cell: [Number(match[2]), Number(match[3])] };
}
