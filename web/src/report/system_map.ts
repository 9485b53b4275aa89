// The map of a system: its winners by class, as in the papers' figures, and the data of the saved
// map.

import type { Table } from "../parts/csv";
import type { GridData } from "../parts/data";
import { element, type Child } from "../parts/dom";
import { figure } from "../parts/figure";
import { columnOf, neuronCount, rowOf } from "../parts/grid";
import { hitsPicture } from "../parts/map_hits";
import { labelsPicture } from "../parts/map_labels";
import { valuesPicture } from "../parts/map_picture";
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
    note: "Each marker is a sample at its winner; an area contains the neurons nearest to the winners of a class. Opposite dotted borders are connected.",
  };
  return liveFigure(options, selection, () => drawMap(system, selection)).element;
}

function drawMap(system: SystemReport, selection: Selection): Drawn {
  const { grid } = system;
  const { protocol, run, label } = selection;
  if (!grid) return nothing("The map cannot be drawn because its shape is unknown.");
  if (!protocol || !run) return nothing("This protocol has no runs.");
  const values = valuesOf(system, protocol, run, label);
  if (!values) return nothing(`The label ${label} is unknown for the samples of this run.`);
  const names = classesOf(system, label);
  const classes = numbered(values, names);
  const isOneMap = hasOneMap(protocol);
  const words = `${protocolName(protocol)}, by ${label}, seed ${runWords(selection)}`;
  const shown = {
    label: `Winners: ${words}`,
    names,
    winners: run.winners,
    classes,
    areas: isOneMap,
    size: 520,
  };
  const picture = labelsPicture(grid, shown);
  const folds = isOneMap ? null : element("p", { class: "small muted" }, [kManyMaps]);
  const table = mapTable(grid, run.winners, values, predictionsOf(protocol, run, label));
  return {
    body: [element("p", { class: "small what" }, [words]), picture.element, folds],
    svg: picture.svg,
    table,
  };
}

const kManyMaps =
  "Each sample was tested on a separate map trained without it: positions on different maps are not comparable, and no areas are drawn.";

function mapTable(grid: GridData, winners: number[], values: string[], named: string[] | null): Table {
  const columns = ["sample", "winner", "row", "column", "class", "named"];
  const rows = winners.map((winner, i) => [
    i + 1,
    winner + 1,
    rowOf(grid, winner) + 1,
    columnOf(grid, winner) + 1,
    values[i] ?? "",
    named?.[i] ?? null,
  ]);
  return { columns, rows };
}

/** U-matrix and hits of the saved system. */
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
  // Classes have the same marks as on the map of winners.
  const label = system.protocols[0]?.label ?? "";
  const names = [...new Set([...classesOf(system, label), ...trained.classes])];
  const classes = trained.neuron_classes.map((one) =>
    one === null ? null : names.indexOf(trained.classes[one] ?? ""),
  );
  picture.setMarks(classes, names);
  return figure({
    title: "U-matrix",
    file: `${systemName(system)}-u-matrix`,
    note: `The mean distance between a neuron's weights and those of its neighbours, ${seed}: light ridges separate different samples. A marker is the class of a neuron.`,
    body: picture.element,
    picture: () => picture.svg,
    numbers: () =>
      neuronTable(grid, ["distance", "class"], (i) => [trained.u_matrix[i] ?? null, className(trained, i)]),
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
    note: `Number of samples won by each neuron, ${seed}.`,
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
  const rows = Array.from({ length: neuronCount(grid) }, (_, i) => [
    i + 1,
    rowOf(grid, i) + 1,
    columnOf(grid, i) + 1,
    ...cells(i),
  ]);
  return { columns: ["neuron", "row", "column", ...columns], rows };
}
