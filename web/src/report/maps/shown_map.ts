// The map on which the winners of a selection are drawn. A picture shows one map: that of the only
// training, that of one of several trainings with the samples that it tested, or that of the saved
// system with all samples.

import type { GridData } from "../../parts/data";
import type { LabelsOptions } from "../../parts/maps/map_labels";
import type { Selection } from "../page/selection";
import type { ProtocolData, RunData, SystemReport } from "../page/unpacked";
import { hasOneMap } from "../page/words";
import { classesOf, numbered, predictionsOf, valuesOf } from "../tables/labels";

export interface ShownMap {
  kind: "run" | "fold" | "saved";
  grid: GridData;
  samples: number[]; // their numbers
  winners: number[]; // the neuron that wins each of them
}

/** The number of trainings by which the samples of a protocol were tested; 0 if unknown. */
export function foldCount({ folds }: ProtocolData): number {
  return folds ? Math.max(...folds) + 1 : 0;
}

/** The accuracy of each training of a run. */
export function foldAccuracies(protocol: ProtocolData, run: RunData): number[] {
  const counts = Array.from({ length: foldCount(protocol) }, () => ({ right: 0, all: 0 }));
  protocol.folds?.forEach((fold, sample) => {
    const count = counts[fold]!;
    count.all += 1;
    if (run.predictions[sample] === run.labels[sample]) count.right += 1;
  });
  return counts.map(({ right, all }) => right / Math.max(1, all));
}

/** The training whose accuracy is nearest the median; the first of equals. */
export function medianFold(protocol: ProtocolData, run: RunData): number {
  const accuracies = foldAccuracies(protocol, run);
  const sorted = [...accuracies].sort((one, other) => one - other);
  const middle = (sorted.length - 1) / 2;
  const median = ((sorted[Math.floor(middle)] ?? 0) + (sorted[Math.ceil(middle)] ?? 0)) / 2;
  const distances = accuracies.map((accuracy) => Math.abs(accuracy - median));
  return Math.max(0, distances.indexOf(Math.min(...distances)));
}

/** The map of the saved system with all samples; null without both. */
export function savedMap({ grid, trained, samples }: SystemReport): ShownMap | null {
  const winners = trained?.winners ?? [];
  if (!grid || winners.length === 0 || winners.length !== (samples ?? []).length) return null;
  return { kind: "saved", grid, samples: winners.map((_, i) => i), winners };
}

/** The map of a training of the selected run; null if it was not stored. */
export function foldMap({ protocol, run, grid, map, system }: Selection, fold: number): ShownMap | null {
  const folds = protocol?.folds;
  if (!folds || !run || !grid || (map === null && grows(system))) return null;
  const samples = folds.flatMap((one, sample) => (one === fold ? [sample] : []));
  return { kind: "fold", grid, samples, winners: samples.map((sample) => run.winners[sample] ?? 0) };
}

/** Whether the maps of several trainings differ in their neurons. */
export function grows({ graph }: SystemReport): boolean {
  const type = graph?.modules.find(({ name }) => name === graph.map)?.type ?? "";
  return type.startsWith("growing_");
}

/** The map of the selection; null if there is none that can be drawn. */
export function shownMap(selection: Selection): ShownMap | null {
  const { protocol, run, grid, map, system, fold } = selection;
  if (!protocol || !run || !grid) return null;
  if (hasOneMap(protocol) || map !== null) {
    if (map === null && grows(system)) return null;
    return { kind: "run", grid, samples: run.winners.map((_, i) => i), winners: run.winners };
  }
  if (fold === null) return selection.isOfSavedRun ? savedMap(system) : null;
  return foldMap(selection, fold);
}

/** The first map of a report: that of the saved system with all samples, or else that of the selection. */
export function firstMap(selection: Selection): ShownMap | null {
  const { protocol, system } = selection;
  return protocol && !hasOneMap(protocol) ? (savedMap(system) ?? shownMap(selection)) : shownMap(selection);
}

/** The values of the selected label for the samples of a map; null if they are unknown. */
export function valuesOn({ kind, samples }: ShownMap, { system, protocol, run, label }: Selection): string[] | null {
  if (kind === "saved") return (system.samples ?? []).map((sample) => sample[label] ?? "(none)");
  const values = protocol && run ? valuesOf(system, protocol, run, label) : null;
  return values && samples.map((sample) => values[sample] ?? "");
}

/** The classes that the selected run named for the samples of a map; null if they are unknown. */
export function predictionsOn({ kind, samples }: ShownMap, { protocol, run, label }: Selection): string[] | null {
  const named = kind !== "saved" && protocol && run ? predictionsOf(protocol, run, label) : null;
  return named && samples.map((sample) => named[sample] ?? "");
}

/** The winners of a map by class, for a picture; null if the label is unknown. */
export function winnersOn(shown: ShownMap, selection: Selection): Omit<LabelsOptions, "label"> | null {
  const values = valuesOn(shown, selection);
  if (!values) return null;
  const names = [...new Set([...classesOf(selection.system, selection.label), ...values])];
  return { names, winners: shown.winners, classes: numbered(values, names), areas: true };
}
