// Positions and neighbours of the neurons of a map. Lengths are in cell widths. On a
// hexagonal lattice odd rows are shifted right by a half; on a torus opposite edges are connected.
// The neurons of a graph are discs in the cells of a drawing.

import type { GridData } from "../data";
import { graphOf } from "./neuron_graph";
import { countOf } from "../numbers";
import { rounded } from "../svg";
import { nearestTowards } from "../hands/towards";

export type Point = readonly [number, number];

const kRowStep = Math.sqrt(3) / 2;
const kSide = 1 / Math.sqrt(3);
const kSquare: readonly Point[] = [
  [-0.5, -0.5],
  [0.5, -0.5],
  [0.5, 0.5],
  [-0.5, 0.5],
];
const kDisc: readonly Point[] = Array.from({ length: 32 }, (_, i) => {
  const angle = (i * Math.PI) / 16;
  return [0.36 * Math.cos(angle), 0.36 * Math.sin(angle)];
});
const kHexagon: readonly Point[] = [
  [0, -kSide],
  [0.5, -kSide / 2],
  [0.5, kSide / 2],
  [0, kSide],
  [-0.5, kSide / 2],
  [-0.5, -kSide / 2],
];

export const isHexagonal = (grid: GridData) => grid.lattice === "hexagonal";
export const neuronCount = (grid: GridData) => grid.rows * grid.columns;
export const rowOf = (grid: GridData, neuron: number) => Math.floor(neuron / grid.columns);
export const columnOf = (grid: GridData, neuron: number) => neuron % grid.columns;

export function widthOf(grid: GridData): number {
  const graph = graphOf(grid);
  if (graph) return graph.columns;
  return grid.columns + (isHexagonal(grid) && grid.rows > 1 ? 0.5 : 0);
}

export function heightOf(grid: GridData): number {
  const graph = graphOf(grid);
  if (graph) return graph.rows;
  return isHexagonal(grid) ? (grid.rows - 1) * kRowStep + 2 * kSide : grid.rows;
}

export function centreOf(grid: GridData, neuron: number): Point {
  const cell = graphOf(grid)?.cells[neuron];
  if (cell) return [cell[1] + 0.5, cell[0] + 0.5];
  const row = rowOf(grid, neuron);
  const column = columnOf(grid, neuron);
  if (!isHexagonal(grid)) return [column + 0.5, row + 0.5];
  return [column + 0.5 + (row % 2) / 2, row * kRowStep + kSide];
}

export function cornersOf(grid: GridData, neuron: number): Point[] {
  const [x, y] = centreOf(grid, neuron);
  const corners = graphOf(grid) ? kDisc : isHexagonal(grid) ? kHexagon : kSquare;
  return corners.map(([dx, dy]) => [x + dx, y + dy]);
}

/** "row 3, column 4", counted from 1 as in all texts for users; in a graph "neuron 5". */
export function placeOf(grid: GridData, neuron: number): string {
  if (graphOf(grid)) return `neuron ${neuron + 1}`;
  return `row ${rowOf(grid, neuron) + 1}, column ${columnOf(grid, neuron) + 1}`;
}

/** "neuron at row 3, column 4", or "neuron 5". */
export function neuronWords(grid: GridData, neuron: number): string {
  const place = placeOf(grid, neuron);
  return graphOf(grid) ? place : `neuron at ${place}`;
}

/** "5 × 6, rectangular, plane", or the size of a graph. */
export function gridWords(grid: GridData): string {
  const graph = graphOf(grid);
  if (graph) return `${countOf(neuronCount(grid), "neuron")} with ${countOf(graph.edges.length, "connection")}`;
  return `${grid.rows} × ${grid.columns}, ${grid.lattice}, ${grid.topology}`;
}

/** The squared distance between two neurons, on a torus the shortest one; in a graph the squared number of edges. */
export function squaredDistance(grid: GridData, one: number, other: number): number {
  const graph = graphOf(grid);
  if (graph) return graph.steps(one, other) ** 2;
  const [ax, ay] = centreOf(grid, one);
  const [bx, by] = centreOf(grid, other);
  if (grid.topology === "plane") return (ax - bx) ** 2 + (ay - by) ** 2;
  const tall = grid.rows * (isHexagonal(grid) ? kRowStep : 1);
  return around(ax - bx, grid.columns) ** 2 + around(ay - by, tall) ** 2;
}

function around(difference: number, length: number): number {
  const apart = Math.abs(difference) % length;
  return Math.min(apart, length - apart);
}

/** The neuron one step up, down, left or right, or itself at an edge; on a torus that of the
 * opposite edge; in a graph the nearest one in that direction. */
export function stepFrom(grid: GridData, neuron: number, rows: number, columns: number): number {
  const graph = graphOf(grid);
  if (graph) return nearestTowards(graph.cells.map(([y, x]) => ({ x, y })), neuron, columns, rows);
  const row = moved(rowOf(grid, neuron) + rows, grid.rows, grid.topology);
  const column = moved(columnOf(grid, neuron) + columns, grid.columns, grid.topology);
  return row * grid.columns + column;
}

function moved(to: number, size: number, topology: GridData["topology"]): number {
  if (topology === "torus") return (to + size) % size;
  return Math.min(size - 1, Math.max(0, to));
}

// A map as pixels has two for each neuron, side by side, so that odd rows of a hexagonal map can be
// shifted by one; that of a graph has one for each cell of its drawing.
const pixelShift = (grid: GridData) => (isHexagonal(grid) && grid.rows > 1 ? 1 : 0);
export const pixelColumns = (grid: GridData) => graphOf(grid)?.columns ?? 2 * grid.columns + pixelShift(grid);
export const pixelRows = (grid: GridData) => graphOf(grid)?.rows ?? grid.rows;

/** The neuron at pixel x of a row; null beside the map. */
export function neuronAtPixel(grid: GridData, x: number, row: number): number | null {
  const graph = graphOf(grid);
  if (graph) return graph.neuronIn(row, x);
  const column = Math.floor((x - (row % 2) * pixelShift(grid)) / 2);
  return column < 0 || column >= grid.columns ? null : row * grid.columns + column;
}

export interface Edge {
  from: Point;
  to: Point;
}

/** The edges between cells of different areas, and those around the map. */
export function borders(
  grid: GridData,
  areas: readonly (number | null)[],
): { between: Edge[]; outside: Edge[] } {
  const seen = new Map<string, { edge: Edge; area: number | null; paired: boolean; differs: boolean }>();
  for (let neuron = 0; neuron < neuronCount(grid); neuron += 1) {
    const corners = cornersOf(grid, neuron);
    const area = areas[neuron] ?? null;
    corners.forEach((from, i) => addEdge(seen, { from, to: corners[(i + 1) % corners.length]! }, area));
  }
  const all = [...seen.values()];
  return {
    between: all.filter((side) => side.paired && side.differs).map((side) => side.edge),
    outside: all.filter((side) => !side.paired).map((side) => side.edge),
  };
}

type Sides = Map<string, { edge: Edge; area: number | null; paired: boolean; differs: boolean }>;

function addEdge(seen: Sides, edge: Edge, area: number | null): void {
  const key = [edge.from, edge.to]
    .map(([x, y]) => `${Math.round(x * 1e4)} ${Math.round(y * 1e4)}`)
    .sort()
    .join();
  const other = seen.get(key);
  if (other === undefined) seen.set(key, { edge, area, paired: false, differs: false });
  else Object.assign(other, { paired: true, differs: other.area !== area });
}

/** Edges as one SVG path, `scale` pixels per cell. */
export function edgesPath(edges: readonly Edge[], scale: number): string {
  const at = ([x, y]: Point) => `${rounded(x * scale)} ${rounded(y * scale)}`;
  return edges.map(({ from, to }) => `M${at(from)}L${at(to)}`).join("");
}
