// The map as in the papers' figures: a marker for every sample at its winner, over the outlined
// areas of the classes.

import type { GridData } from "../data";
import { areasOf, wonBy } from "./areas";
import { classColour } from "./colour_maps";
import { borders, centreOf, edgesPath, isHexagonal, placeOf } from "./grid";
import { markerLegend } from "./legend";
import { mapFrame, setFootHeight, type MapFrame, type MapOptions } from "./map_cells";
import { cellPicture, type CellPicture } from "./map_cursor";
import { marker } from "./markers";
import { graphOf } from "./neuron_graph";
import { shape, text } from "../svg";

export interface LabelsOptions extends MapOptions {
  names: readonly string[]; // of the classes
  winners: readonly number[]; // winners[i] won a sample of class classes[i]
  classes: readonly number[];
  areas: boolean; // whether the winners are of one map, so that areas mean something
}

type Won = Map<number, Map<number, number>>;

export function labelsPicture(grid: GridData, options: LabelsOptions): CellPicture {
  const { frame, won } = draw(grid, options);
  const legend = markerLegend(frame.width, options.names, countsOf(options));
  frame.foot.append(legend.group);
  setFootHeight(frame, legend.height);
  return cellPicture(frame, "map-picture", (neuron) => describe(grid, neuron, won, options.names), options);
}

/** The same as a small picture without a legend, which is only looked at. */
export function labelsThumbnail(grid: GridData, options: LabelsOptions): SVGSVGElement {
  const { frame } = draw(grid, options);
  setFootHeight(frame, 0);
  joinCells(frame);
  return frame.svg;
}

/** One path for all cells of the same colour: a page may have many such pictures. */
function joinCells({ cells }: MapFrame): void {
  const outlines = new Map<string, string>();
  for (const cell of cells) {
    const key = `${cell.getAttribute("fill") ?? "none"} ${cell.getAttribute("fill-opacity") ?? ""}`;
    outlines.set(key, (outlines.get(key) ?? "") + (cell.getAttribute("d") ?? ""));
  }
  const joined = [...outlines].map(([key, d]) => {
    const [fill = "none", opacity = ""] = key.split(" ");
    return shape("path", { d, fill, ...(opacity === "" ? {} : { "fill-opacity": opacity }) });
  });
  cells[0]?.parentElement?.replaceChildren(...joined);
}

function draw(grid: GridData, options: LabelsOptions): { frame: MapFrame; won: Won } {
  const won = wonBy(options.winners, options.classes);
  const frame = mapFrame(grid, options, 1);
  if (options.areas && won.size > 0) drawAreas(frame, areasOf(grid, options.winners, options.classes), won);
  for (const [neuron, counts] of won) drawWon(frame, neuron, counts);
  return { frame, won };
}

function countsOf(options: LabelsOptions): number[] {
  return options.names.map((_, number) => options.classes.filter((one) => one === number).length);
}

function describe(grid: GridData, neuron: number, won: Won, names: readonly string[]): string {
  const counts = [...(won.get(neuron) ?? [])].sort(([one], [other]) => one - other);
  const words = counts.map(([number, samples]) => `${samples} × ${names[number] ?? "?"}`);
  return `${placeOf(grid, neuron)}: ${words.join(", ") || "no sample"}`;
}

const kWonOpacity = 0.5;
const kAreaOpacity = 0.2;

function drawAreas(frame: MapFrame, areas: (number | null)[], won: Won): void {
  frame.cells.forEach((cell, neuron) => {
    const area = areas[neuron];
    if (area === null || area === undefined) return;
    cell.setAttribute("fill", classColour(area));
    cell.setAttribute("fill-opacity", String(won.has(neuron) ? kWonOpacity : kAreaOpacity));
  });
  if (graphOf(frame.grid)) return;
  const { between } = borders(frame.grid, areas);
  frame.border.after(shape("path", { d: edgesPath(between, frame.cell), class: "map-border area-border" }));
}

const kLeastRadius = 2.2;
const kGreatestRadius = 7;

/** One marker per sample if there is space, otherwise one per class with a number. */
function drawWon(frame: MapFrame, neuron: number, counts: Map<number, number>): void {
  const each = [...counts].sort(([one], [other]) => one - other);
  const samples = each.flatMap(([number, count]) => Array.from({ length: count }, () => number));
  const spacing = spacingOf(frame, samples.length);
  if (samples.length === 1 || radiusFor(spacing) >= kLeastRadius)
    return drawMarkers(frame, neuron, samples, []);
  drawMarkers(
    frame,
    neuron,
    each.map(([number]) => number),
    each.map(([, count]) => count),
  );
}

function drawMarkers(frame: MapFrame, neuron: number, numbers: number[], counts: number[]): void {
  const spacing = spacingOf(frame, numbers.length);
  const isCounted = counts.length > 0 && spacing >= 16;
  const radius = radiusFor(isCounted ? spacing * 0.6 : spacing);
  const [x, y] = centreOf(frame.grid, neuron);
  numbers.forEach((number, i) => {
    const [dx, dy] = offsetOf(i, numbers.length, spacing);
    const [at, above] = [x * frame.cell + dx, y * frame.cell + dy];
    frame.marks.append(marker(number, at, isCounted ? above - spacing * 0.2 : above, radius));
    if (isCounted)
      frame.marks.append(text(at, above + spacing * 0.45, String(counts[i]), { class: "middle note" }));
  });
}

function spacingOf(frame: MapFrame, markers: number): number {
  const side = graphOf(frame.grid) ? 0.56 : isHexagonal(frame.grid) ? 2 / (1 + Math.sqrt(3)) : 1;
  return (0.96 * side * frame.cell) / Math.ceil(Math.sqrt(markers));
}

function radiusFor(spacing: number): number {
  return Math.min(0.36 * spacing, kGreatestRadius);
}

/** Markers are arranged in an upright square, row by row; short rows are centred. */
function offsetOf(index: number, markers: number, spacing: number): [number, number] {
  const columns = Math.ceil(Math.sqrt(markers));
  const row = Math.floor(index / columns);
  const rows = Math.ceil(markers / columns);
  const inRow = Math.min(columns, markers - row * columns);
  return [spacing * ((index % columns) - (inRow - 1) / 2), spacing * (row - (rows - 1) / 2)];
}
