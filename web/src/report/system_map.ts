// The maps of a system: winners by class, as in the papers' figures, U-matrix and hits.

import type { Table } from "../parts/csv";
import type { GridData } from "../parts/data";
import { element } from "../parts/dom";
import { columnOf, neuronCount, rowOf } from "../parts/grid";
import { hitsPicture } from "../parts/map_hits";
import { labelsPicture, type LabelsOptions } from "../parts/map_labels";
import { valuesPicture } from "../parts/map_picture";
import { fitting } from "./fitting";
import { classesOf, numbered, predictionsOf, valuesOf } from "./labels";
import { liveFigure, nothing, type Drawn } from "./live_figure";
import { shownBySelection, shownOfSaved } from "./origin";
import { savedNotice } from "./saved_notice";
import type { Selection } from "./selection";
import type { ProtocolData, RunData, SystemReport, TrainedData } from "./unpacked";
import { hasOneMap, systemName } from "./words";

export interface MapSizes {
  large: number;
  small: number;
}

const kSizes: MapSizes = { large: 520, small: 300 };

/** Names of files begin with `prefix`, so that the same map may be on the page twice. */
export function mapFigures(selection: Selection, sizes = kSizes, prefix = ""): HTMLElement[] {
  const { grid, trained } = selection.system;
  const name = `${prefix}${systemName(selection.system)}`;
  const figures = [winnersFigure(selection, name, fitting(sizes.large))];
  if (grid && (trained?.u_matrix.length ?? 0) > 0) figures.push(uMatrixFigure(selection, name, grid, fitting(sizes.small)));
  if (grid) figures.push(hitsFigure(selection, name, grid, fitting(sizes.small)));
  return figures;
}

function winnersFigure(selection: Selection, name: string, size: number): HTMLElement {
  const { grid } = selection.system;
  const torus = grid?.topology === "torus" ? " Opposite dotted borders are connected." : "";
  const options = {
    title: "Winners",
    file: `${name}-winners`,
    note: `Each marker is a sample at its winner; an area contains the neurons nearest to the winners of a class.${torus}`,
  };
  return liveFigure(options, selection, () => drawWinners(selection, size));
}

/** The winners of a run by class, for a picture; null if the label is unknown. */
export function winnersOf(
  system: SystemReport,
  protocol: ProtocolData,
  run: RunData,
  label: string,
): Omit<LabelsOptions, "label"> | null {
  const values = valuesOf(system, protocol, run, label);
  if (!values) return null;
  const names = classesOf(system, label);
  return { names, winners: run.winners, classes: numbered(values, names), areas: hasOneMap(protocol) };
}

function drawWinners(selection: Selection, size: number): Drawn {
  const { protocol, run, label, system } = selection;
  if (!system.grid) return nothing("The map cannot be drawn because its shape is unknown.");
  if (!protocol || !run) return nothing("This protocol has no runs.");
  const winners = winnersOf(system, protocol, run, label);
  if (!winners) return nothing(`The label ${label} is unknown for the samples of this run.`);
  const { words } = shownBySelection(selection);
  const picture = labelsPicture(system.grid, {
    ...winners,
    label: `Winners: ${words}`,
    size,
    onChoose: (neuron) => selection.setNeuron(neuron),
  });
  const folds = winners.areas ? null : element("p", { class: "small muted" }, [kManyMaps]);
  const values = winners.classes.map((number) => winners.names[number] ?? "");
  return {
    body: [element("p", { class: "small what" }, [words]), picture.element, folds],
    svg: picture.svg,
    table: winnersTable(system.grid, run.winners, values, predictionsOf(protocol, run, label)),
    map: picture,
  };
}

const kManyMaps =
  "Each sample was tested on a separate map trained without it: positions on different maps are not comparable, and no areas are drawn.";

function winnersTable(grid: GridData, winners: number[], values: string[], named: string[] | null): Table {
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

function uMatrixFigure(selection: Selection, name: string, grid: GridData, size: number): HTMLElement {
  const options = {
    title: "U-matrix",
    file: `${name}-u-matrix`,
    note: "The mean distance between a neuron's weights and those of its neighbours: light ridges separate different samples. A marker is the class of most samples that a neuron wins.",
    about: () => (selection.isOfSavedMap ? shownBySelection(selection) : shownOfSaved(selection.system)),
  };
  return liveFigure(options, selection, () => drawUMatrix(selection, grid, size));
}

/** Markers are only drawn for winners on the same map. */
function drawUMatrix(selection: Selection, grid: GridData, size: number): Drawn {
  const { system, isOfSavedMap } = selection;
  const distances = (system.trained as TrainedData).u_matrix;
  const onChoose = (neuron: number) => (isOfSavedMap ? selection.setNeuron(neuron) : undefined);
  const picture = valuesPicture(grid, { label: "U-matrix", unit: "distance", size, onChoose });
  picture.setValues(distances);
  const marks = marksOf(selection, grid);
  if (marks) picture.setMarks(marks.classes, marks.names);
  const table = neuronTable(grid, ["distance", "class"], (i) => [
    distances[i] ?? null,
    marks?.names[marks.classes[i] ?? -1] ?? null,
  ]);
  return {
    body: [savedNotice(selection), picture.element],
    svg: picture.svg,
    table,
    ...(isOfSavedMap ? { map: picture } : {}),
  };
}

/** The class of most samples that each neuron wins, of equals the first. */
function marksOf(selection: Selection, grid: GridData): { classes: (number | null)[]; names: readonly string[] } | null {
  const { system, protocol, run, label, isOfSavedMap } = selection;
  const won = isOfSavedMap && protocol && run ? winnersOf(system, protocol, run, label) : null;
  if (!won) return null;
  const counts = Array.from({ length: neuronCount(grid) }, () => new Map<number, number>());
  won.winners.forEach((winner, i) => {
    const number = won.classes[i] ?? 0;
    counts[winner]?.set(number, (counts[winner]?.get(number) ?? 0) + 1);
  });
  const most = (of: Map<number, number>) => [...of].sort((one, other) => other[1] - one[1] || one[0] - other[0])[0];
  return { classes: counts.map((of) => most(of)?.[0] ?? null), names: won.names };
}

function hitsFigure(selection: Selection, name: string, grid: GridData, size: number): HTMLElement {
  const options = { title: "Hits", file: `${name}-hits`, note: "Number of samples won by each neuron." };
  return liveFigure(options, selection, () => drawHits(selection, grid, size));
}

function drawHits(selection: Selection, grid: GridData, size: number): Drawn {
  const { protocol, run } = selection;
  if (!protocol || !run) return nothing("This protocol has no runs.");
  if (!hasOneMap(protocol)) return nothing("The samples were tested on different maps, whose neurons are not comparable.");
  const hits = new Array<number>(neuronCount(grid)).fill(0);
  for (const winner of run.winners) hits[winner] = (hits[winner] ?? 0) + 1;
  const onChoose = (neuron: number) => selection.setNeuron(neuron);
  const picture = hitsPicture(grid, hits, { label: "Hits", size, onChoose });
  return {
    body: [picture.element],
    svg: picture.svg,
    table: neuronTable(grid, ["samples"], (i) => [hits[i] ?? null]),
    map: picture,
  };
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
