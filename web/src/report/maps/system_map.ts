// The maps of a system: winners by class, as in the papers' figures, U-matrix and hits.

import type { Table } from "../../parts/csv";
import type { GridData } from "../../parts/data";
import { element } from "../../parts/dom";
import { columnOf, neuronCount, rowOf } from "../../parts/maps/grid";
import { hitsPicture } from "../../parts/maps/map_hits";
import { labelsPicture, type LabelsOptions } from "../../parts/maps/map_labels";
import { valuesPicture } from "../../parts/maps/map_picture";
import { graphOf } from "../../parts/maps/neuron_graph";
import { rangeOf } from "../../parts/numbers";
import { fitting } from "../page/fitting";
import { classesOf, numbered, predictionsOf, valuesOf } from "../tables/labels";
import { liveFigure, nothing, type Drawn } from "./live_figure";
import { shownBySelection, shownOfSaved } from "../page/origin";
import { savedNotice } from "../page/saved_notice";
import type { Selection } from "../page/selection";
import type { ProtocolData, RunData, SystemReport } from "../page/unpacked";
import { hasOneMap, systemName } from "../page/words";

export interface MapSizes {
  large: number;
  small: number;
}

const kSizes: MapSizes = { large: 520, small: 300 };

/** Names of files begin with `prefix`, so that the same map may be on the page twice. */
export function mapFigures(selection: Selection, sizes = kSizes, prefix = ""): HTMLElement[] {
  const { system } = selection;
  const name = `${prefix}${systemName(system)}`;
  const figures = [winnersFigure(selection, name, fitting(sizes.large))];
  const stored = system.protocols.some(({ runs }) => runs.some(({ map }) => map !== undefined));
  if (stored || (system.grid && (system.trained?.u_matrix.length ?? 0) > 0)) {
    figures.push(uMatrixFigure(selection, name, fitting(sizes.small)));
  }
  if (stored || system.grid) figures.push(hitsFigure(selection, name, fitting(sizes.small)));
  return figures;
}

/** Maps that grow differ in their neurons, so that the winners on several have no common picture. */
export function canDraw({ grid, map, system }: Selection): boolean {
  const type = system.graph?.modules.find(({ name }) => name === system.graph?.map)?.type ?? "";
  return grid !== null && (map !== null || !type.startsWith("growing_"));
}

function winnersFigure(selection: Selection, name: string, size: number): HTMLElement {
  const torus = selection.grid?.topology === "torus" ? " Opposite dotted borders are connected." : "";
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
  const { protocol, run, label, system, grid } = selection;
  if (!grid) return nothing("The map cannot be drawn because its shape is unknown.");
  if (!protocol || !run) return nothing("This protocol has no runs.");
  if (!canDraw(selection)) return nothing(kGrownApart);
  const winners = winnersOf(system, protocol, run, label);
  if (!winners) return nothing(`The label ${label} is unknown for the samples of this run.`);
  const { words } = shownBySelection(selection);
  const picture = labelsPicture(grid, {
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
    table: winnersTable(grid, run.winners, values, predictionsOf(protocol, run, label)),
    map: picture,
  };
}

const kManyMaps =
  "Each sample was tested on a separate map trained without it: positions on different maps are not comparable, and no areas are drawn.";

const kGrownApart =
  "Each sample was tested on a separate map trained without it. Maps that grow differ in their neurons, so that the winners cannot be drawn together.";

function winnersTable(grid: GridData, winners: number[], values: string[], named: string[] | null): Table {
  const columns = ["sample", "winner", ...placeColumns(grid), "class", "named"];
  const rows = winners.map((winner, i) => [
    i + 1,
    winner + 1,
    ...placeIn(grid, winner),
    values[i] ?? "",
    named?.[i] ?? null,
  ]);
  return { columns, rows };
}

function uMatrixFigure(selection: Selection, name: string, size: number): HTMLElement {
  const options = {
    title: "U-matrix",
    file: `${name}-u-matrix`,
    note: "The mean distance between a neuron's weights and those of its neighbours: light ridges separate different samples. A marker is the class of most samples that a neuron wins.",
    about: () => (isOfWinners(selection) ? shownBySelection(selection) : shownOfSaved(selection.system)),
  };
  return liveFigure(options, selection, () => drawUMatrix(selection, size));
}

/** Whether the U-matrix is that of the selected winners; otherwise it is that of the saved system. */
function isOfWinners({ map, isOfSavedMap }: Selection): boolean {
  return map !== null || isOfSavedMap;
}

/** Markers are only drawn for winners on the same map. */
function drawUMatrix(selection: Selection, size: number): Drawn {
  const { system, map } = selection;
  const grid = map?.grid ?? system.grid;
  const distances = map?.u_matrix ?? system.trained?.u_matrix ?? [];
  if (!grid || distances.length === 0) return nothing("The samples were tested on different maps, and no trained system was saved.");
  const isOwn = isOfWinners(selection);
  const onChoose = (neuron: number) => (isOwn ? selection.setNeuron(neuron) : undefined);
  const picture = valuesPicture(grid, { label: "U-matrix", unit: "distance", size, onChoose });
  const edges = map?.edge_distances ?? [];
  const range = rangeOf([...distances, ...edges]) ?? [0, 1];
  picture.setValues(distances, range);
  picture.setEdges(edges, range);
  const marks = isOwn ? marksOf(selection, grid) : null;
  if (marks) picture.setMarks(marks.classes, marks.names);
  const table = neuronTable(grid, ["distance", "class"], (i) => [
    distances[i] ?? null,
    marks?.names[marks.classes[i] ?? -1] ?? null,
  ]);
  const words = element("p", { class: "small what" }, [shownBySelection(selection).words]);
  return {
    body: [isOwn ? words : savedNotice(selection), picture.element],
    svg: picture.svg,
    table,
    ...(isOwn ? { map: picture } : {}),
  };
}

/** The class of most samples that each neuron wins, of equals the first. */
function marksOf(selection: Selection, grid: GridData): { classes: (number | null)[]; names: readonly string[] } | null {
  const { system, protocol, run, label } = selection;
  const won = protocol && run ? winnersOf(system, protocol, run, label) : null;
  if (!won) return null;
  const counts = Array.from({ length: neuronCount(grid) }, () => new Map<number, number>());
  won.winners.forEach((winner, i) => {
    const number = won.classes[i] ?? 0;
    counts[winner]?.set(number, (counts[winner]?.get(number) ?? 0) + 1);
  });
  const most = (of: Map<number, number>) => [...of].sort((one, other) => other[1] - one[1] || one[0] - other[0])[0];
  return { classes: counts.map((of) => most(of)?.[0] ?? null), names: won.names };
}

function hitsFigure(selection: Selection, name: string, size: number): HTMLElement {
  const options = { title: "Hits", file: `${name}-hits`, note: "Number of samples won by each neuron." };
  return liveFigure(options, selection, () => drawHits(selection, size));
}

function drawHits(selection: Selection, size: number): Drawn {
  const { protocol, run, grid } = selection;
  if (!protocol || !run || !grid) return nothing("This protocol has no runs.");
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
    ...placeIn(grid, i),
    ...cells(i),
  ]);
  return { columns: ["neuron", ...placeColumns(grid), ...columns], rows };
}

const placeColumns = (grid: GridData) => (graphOf(grid) ? [] : ["row", "column"]);
const placeIn = (grid: GridData, neuron: number) =>
  graphOf(grid) ? [] : [rowOf(grid, neuron) + 1, columnOf(grid, neuron) + 1];
