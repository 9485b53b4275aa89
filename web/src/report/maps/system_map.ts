// The maps of a system: winners by class, as in the papers' figures, U-matrix and hits.

import type { Table } from "../../parts/csv";
import type { GridData } from "../../parts/data";
import { element } from "../../parts/dom";
import type { Shown } from "../../parts/figure";
import { columnOf, neuronCount, rowOf } from "../../parts/maps/grid";
import { hitsPicture } from "../../parts/maps/map_hits";
import { labelsPicture } from "../../parts/maps/map_labels";
import { valuesPicture } from "../../parts/maps/map_picture";
import { graphOf } from "../../parts/maps/neuron_graph";
import { rangeOf } from "../../parts/numbers";
import { fitting } from "../page/fitting";
import { liveFigure, nothing, type Drawn } from "./live_figure";
import { shownBySelection, shownOfMap, shownOfSaved } from "../page/origin";
import { savedNotice } from "../page/saved_notice";
import type { Selection } from "../page/selection";
import { systemName } from "../page/words";
import { grows, predictionsOn, shownMap, winnersOn, type ShownMap } from "./shown_map";

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

function winnersFigure(selection: Selection, name: string, size: number): HTMLElement {
  const torus = selection.grid?.topology === "torus" ? " Opposite dotted borders are connected." : "";
  const options = {
    title: "Winners",
    file: `${name}-winners`,
    about: () => aboutMap(selection),
    note: `Each marker is a sample at its winner; an area contains the neurons nearest to the winners of a class.${torus}`,
  };
  return liveFigure(options, selection, () => drawWinners(selection, size));
}

function aboutMap(selection: Selection): Shown {
  const shown = shownMap(selection);
  return shown ? shownOfMap(shown, selection) : shownBySelection(selection);
}

function drawWinners(selection: Selection, size: number): Drawn {
  const { protocol, run, label, grid } = selection;
  if (!grid) return nothing("The map cannot be drawn because its shape is unknown.");
  if (!protocol || !run) return nothing("This protocol has no runs.");
  const shown = shownMap(selection);
  if (!shown) return nothing(grows(selection.system) ? kGrownApart : kManyMaps);
  const winners = winnersOn(shown, selection);
  if (!winners) return nothing(`The label ${label} is unknown for the samples of this run.`);
  const { words } = shownOfMap(shown, selection);
  const picture = labelsPicture(shown.grid, {
    ...winners,
    label: `Winners: ${words}`,
    size,
    onChoose: (neuron) => selection.setNeuron(neuron),
  });
  const others = shown.kind === "run" ? null : element("p", { class: "small muted" }, [kOthers[shown.kind]]);
  const values = winners.classes.map((number) => winners.names[number] ?? "");
  return {
    body: [element("p", { class: "small what" }, [words]), picture.element, others],
    svg: picture.svg,
    table: winnersTable(shown, values, predictionsOn(shown, selection)),
    map: picture,
  };
}

const kOthers = {
  fold: "Only the samples that this map was tested with are shown. The other samples were tested on other maps, whose positions are not comparable.",
  saved: "For the accuracy each sample was tested on another map, which was trained without it. This map was trained on all samples.",
};

const kManyMaps =
  "Each sample was tested on a separate map trained without it. Positions on different maps are not comparable, so that the winners cannot be drawn together.";

const kGrownApart =
  "Each sample was tested on a separate map trained without it. Maps that grow differ in their neurons, so that the winners cannot be drawn together.";

function winnersTable({ grid, winners, samples }: ShownMap, values: string[], named: string[] | null): Table {
  const columns = ["sample", "winner", ...placeColumns(grid), "class", "named"];
  const rows = winners.map((winner, i) => [
    (samples[i] ?? 0) + 1,
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
    about: () => (isOfWinners(selection) ? aboutMap(selection) : shownOfSaved(selection.system)),
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
  const words = element("p", { class: "small what" }, [aboutMap(selection).words]);
  return {
    body: [isOwn ? words : savedNotice(selection), picture.element],
    svg: picture.svg,
    table,
    ...(isOwn ? { map: picture } : {}),
  };
}

/** The class of most samples that each neuron wins, of equals the first. */
function marksOf(selection: Selection, grid: GridData): { classes: (number | null)[]; names: readonly string[] } | null {
  const shown = shownMap(selection);
  const won = shown && winnersOn(shown, selection);
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
  const note = "Number of samples won by each neuron.";
  const options = { title: "Hits", file: `${name}-hits`, note, about: () => aboutMap(selection) };
  return liveFigure(options, selection, () => drawHits(selection, size));
}

function drawHits(selection: Selection, size: number): Drawn {
  const { protocol, run } = selection;
  if (!protocol || !run) return nothing("This protocol has no runs.");
  const shown = shownMap(selection);
  if (!shown) return nothing("The samples were tested on different maps, whose neurons are not comparable.");
  const { grid, winners } = shown;
  const hits = new Array<number>(neuronCount(grid)).fill(0);
  for (const winner of winners) hits[winner] = (hits[winner] ?? 0) + 1;
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
