// The map of a system: its winners by class, as in the papers' figures, and what the saved one tells
// beside that.

import type { Table } from "../parts/csv";
import type { GridData } from "../parts/data";
import { element, type Child } from "../parts/dom";
import { figure } from "../parts/figure";
import { columnOf, neuronCount, rowOf } from "../parts/grid";
import { hitsPicture } from "../parts/map_hits";
import { labelsPicture, valuesPicture } from "../parts/map_picture";
import type { SystemReport, TrainedData } from "./data";
import { classesOf, numbered, predictionsOf, valuesOf } from "./labels";
import { liveFigure, nothing, type Drawn } from "./live_figure";
import type { Selection } from "./selection";
import { runWords } from "./toolbar";
import { hasOneMap, protocolName, systemName } from "./words";

export function mapFigure(system: SystemReport, selection: Selection): HTMLElement {
  const options = {
    title: "Winners",
    file: `${systemName(system)}-map`,
    note: "A marker is a sample, at the neuron that won it; an area is what lies nearest to the winners of a class. A dotted border touches the opposite one.",
  };
  return liveFigure(options, selection, () => drawMap(system, selection)).element;
}

function drawMap(system: SystemReport, selection: Selection): Drawn {
  const { grid } = system;
  const { protocol, run, label } = selection;
  if (!grid) return nothing("The shape of the map is not known, so it cannot be drawn.");
  if (!protocol || !run) return nothing("There is no run of this protocol.");
  const values = valuesOf(system, protocol, run, label);
  if (!values) return nothing(`The label ${label} is not known for the samples of this run.`);
  const names = classesOf(system, label);
  const classes = numbered(values, names);
  const isOneMap = hasOneMap(protocol);
  const words = `${protocolName(protocol)}, by ${label}, seed ${runWords(selection)}`;
  const shown = { label: `Winners: ${words}`, names, winners: run.winners, classes, areas: isOneMap, size: 520 };
  const picture = labelsPicture(grid, shown);
  const folds = isOneMap ? null : element("p", { class: "small muted" }, [kManyMaps]);
  const table = mapTable(grid, run.winners, values, predictionsOf(protocol, run, label));
  return { body: [element("p", { class: "small what" }, [words]), picture.element, folds], svg: picture.svg, table };
}

const kManyMaps =
  "Each sample was tested on a map of its own that had not learned from it: places on different maps are not to be compared, and no areas are drawn.";

function mapTable(grid: GridData, winners: number[], values: string[], named: string[] | null): Table {
  const columns = ["sample", "winner", "row", "column", "class", "named"];
  const rows = winners.map((winner, i) => [i + 1, winner + 1, rowOf(grid, winner) + 1, columnOf(grid, winner) + 1,
    values[i] ?? "", named?.[i] ?? null]);
  return { columns, rows };
}

/** U-matrix and hits of the system that is saved. */
export function savedMapFigures(system: SystemReport): Child[] {
  const { grid, trained } = system;
  if (!grid || !trained) return [];
  const seed = trained.seed === null ? "of the saved system" : `of the saved system, seed ${trained.seed}`;
  const figures: Child[] = [];
  if (trained.u_matrix.length > 0) figures.push(uMatrixFigure(system, grid, trained, seed));
  if (trained.hits.length > 0) figures.push(hitsFigure(system, grid, trained, seed));
  return figures;
}

function uMatrixFigure(system: SystemReport, grid: GridData, trained: TrainedData, seed: string): Child {
  const picture = valuesPicture(grid, { label: "U-matrix", unit: "distance", size: 300 });
  picture.setValues(trained.u_matrix);
  // The same marks as on the map of winners: classes numbered as there.
  const label = system.protocols[0]?.label ?? "";
  const names = [...new Set([...classesOf(system, label), ...trained.classes])];
  const classes = trained.neuron_classes.map((one) => (one === null ? null : names.indexOf(trained.classes[one] ?? "")));
  picture.setMarks(classes, names);
  return figure({
    title: "U-matrix",
    file: `${systemName(system)}-u-matrix`,
    note: `The mean distance of a neuron's weights from its neighbours', ${seed}: light ridges part what differs. A marker is the class that a neuron is labelled with.`,
    body: picture.element,
    picture: () => picture.svg,
    numbers: () => neuronTable(grid, ["distance", "class"], (i) => [trained.u_matrix[i] ?? null, className(trained, i)]),
  });
}

function className(trained: TrainedData, neuron: number): string | null {
  const number = trained.neuron_classes[neuron];
  return number === null || number === undefined ? null : (trained.classes[number] ?? null);
}

function hitsFigure(system: SystemReport, grid: GridData, trained: TrainedData, seed: string): Child {
  const picture = hitsPicture(grid, trained.hits, { label: "Hits", size: 300 });
  return figure({
    title: "Hits",
    file: `${systemName(system)}-hits`,
    note: `How many samples a neuron won, ${seed}.`,
    body: picture.element,
    picture: () => picture.svg,
    numbers: () => neuronTable(grid, ["samples"], (i) => [trained.hits[i] ?? null]),
  });
}

export function neuronTable(
  grid: GridData,
  columns: string[],
  cells: (neuron: number) => (string | number | null)[],
): Table {
  const rows = Array.from({ length: neuronCount(grid) }, (_, i) => [i + 1, rowOf(grid, i) + 1, columnOf(grid, i) + 1, ...cells(i)]);
  return { columns: ["neuron", "row", "column", ...columns], rows };
}
