// Common parts of all pictures of a map: cells, border, and layers for marks and rings.

import type { GridData } from "../data";
import { borders, centreOf, cornersOf, edgesPath, heightOf, neuronCount, stepFrom, widthOf } from "./grid";
import type { CursorOptions, CursorPlace } from "./map_cursor";
import { graphOf } from "./neuron_graph";
import { rounded, shape, svg } from "../svg";

export interface MapOptions extends CursorOptions {
  size?: number; // about how wide, in pixels; 420 unless said
}

export interface MapFrame extends CursorPlace {
  grid: GridData;
  cell: number; // pixels a cell
  width: number; // of the map, pixels
  height: number;
  edges: readonly SVGPathElement[]; // of a graph
  border: SVGPathElement;
  marks: SVGGElement;
  winner: SVGGElement;
  foot: SVGGElement; // below the map: legends
}

const kGap = 0.7; // pixels, between two cells
const kMargin = 3; // room for rings at the edge
const kFootGap = 12;
const kLargestCell = 90; // of a map of few neurons
const kLegendWidth = 300; // at least

/** Pixels per cell such that a map is about `size` wide and not taller. */
function cellSize(grid: GridData, size = 420): number {
  const fitting = Math.min(size / widthOf(grid), size / heightOf(grid));
  return Math.max(6, Math.min(kLargestCell, fitting));
}

export function mapFrame(grid: GridData, { label, size }: MapOptions, footHeight: number): MapFrame {
  const cell = cellSize(grid, size);
  const width = widthOf(grid) * cell;
  const height = heightOf(grid) * cell;
  const wide = Math.max(width, footHeight > 0 ? Math.min(kLegendWidth, size ?? kLegendWidth) : 0);
  const cells = Array.from({ length: neuronCount(grid) }, (_, neuron) => cellOf(grid, neuron, cell));
  const edges = (graphOf(grid)?.edges ?? []).map((edge) => edgeOf(grid, edge, cell));
  const border = borderOf(grid, cell);
  const [marks, winner, rings] = [layer("map-marks"), layer("map-winner"), layer("map-rings")];
  rings.setAttribute("data-transient", "");
  const foot = shape("g", { transform: `translate(0 ${rounded(height + kFootGap)})` });
  const all = [...(graphOf(grid) ? below(edges, cells) : []), shape("g", { class: "map-cells" }, cells), border, marks, winner, rings, foot];
  const inner = shape("g", { transform: `translate(${kMargin} ${kMargin})` }, all);
  const tall = height + (footHeight > 0 ? kFootGap + footHeight : 0);
  const picture = svg(wide + 2 * kMargin, tall + 2 * kMargin, label, [inner]);
  const step = (at: number, rows: number, columns: number) => stepFrom(grid, at, rows, columns);
  const cursor = { svg: picture, cells, rings, kind: "map", cellName: "neurons", step };
  return { ...cursor, grid, cell, width: wide, height, edges, border, marks, winner, foot };
}

/** Makes space for a footer of the given height. */
export function setFootHeight(frame: MapFrame, tall: number): void {
  const height = rounded(frame.height + (tall > 0 ? kFootGap + tall : 0) + 2 * kMargin);
  const width = rounded(frame.width + 2 * kMargin);
  frame.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  frame.svg.setAttribute("height", String(height));
}

function layer(name: string): SVGGElement {
  return shape("g", { class: name });
}

/** A little smaller than its place: a gap is drawn faster than an outline of each cell. */
function cellOf(grid: GridData, neuron: number, cell: number): SVGPathElement {
  const [left, top] = centreOf(grid, neuron);
  const scale = cell - kGap;
  const corners = cornersOf(grid, neuron).map(
    ([x, y]) => `${rounded(left * cell + (x - left) * scale)} ${rounded(top * cell + (y - top) * scale)}`,
  );
  return shape("path", { d: `M${corners.join("L")}Z`, fill: "none", "data-cell": neuron });
}

/** The connections of a graph. They do not shine through cells that are seen through. */
function below(edges: SVGPathElement[], cells: readonly SVGPathElement[]): SVGElement[] {
  const d = cells.map((cell) => cell.getAttribute("d")).join("");
  return [shape("g", { class: "map-edges" }, edges), shape("path", { d, class: "map-ground" })];
}

function edgeOf(grid: GridData, [one, other]: [number, number], cell: number): SVGPathElement {
  const [from, to] = [centreOf(grid, one), centreOf(grid, other)];
  return shape("path", { d: edgesPath([{ from, to }], cell) });
}

/** The discs of a graph have their own outlines. */
function borderOf(grid: GridData, cell: number): SVGPathElement {
  const outside = graphOf(grid) ? [] : borders(grid, []).outside;
  return shape("path", { d: edgesPath(outside, cell), class: `map-border ${grid.topology}` });
}
