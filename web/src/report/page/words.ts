// The names of protocols and metrics in words. docs/reference/results.md defines every metric.

import { capital } from "../../parts/numbers";
import type { ProtocolData, SystemReport } from "./unpacked";
import type { Placed } from "./same_names";

export function systemName(system: Placed<SystemReport>): string {
  const name = system.name || system.file || "A system without a name";
  const whole = system.variation === "" ? name : `${name}, ${system.variation}`;
  return system.place === undefined ? whole : `${whole} (${system.place})`;
}

const kProtocols: Record<string, string> = {
  train_is_test: "Train = test",
  leave_one_out: "Leave one out",
  test_data: "New recording",
  object_after_object: "Object after object",
};

export function protocolName(protocol: ProtocolData): string {
  if (protocol.protocol === "leave_group_out") return `Leave out each ${protocol.group ?? "group"}`;
  if (protocol.protocol === "k_folds") return "Folds";
  return kProtocols[protocol.protocol] ?? protocol.protocol.replaceAll("_", " ");
}

/** Whether all winners of one run belong to one map, so that areas are meaningful. */
export function hasOneMap(protocol: ProtocolData): boolean {
  return protocol.protocol === "train_is_test" || protocol.protocol === "test_data";
}

/** Metrics of the classes left out whose name is given, and of the known ones; the number of names follows. */
const kNamed: Record<string, string> = {
  taught_accuracy: "New class answered",
  taught_accuracy_of_nearest: "New class most similar",
  baseline_taught_accuracy: "New class, nearest neighbour,",
  known_accuracy: "Known classes answered",
  known_accuracy_of_nearest: "Known classes most similar",
  baseline_known_accuracy: "Known classes, nearest neighbour,",
  known_changed: "Known classes, other answer",
};

const kMetrics: Record<string, string> = {
  accuracy: "Accuracy",
  baseline_accuracy: "Nearest-neighbour accuracy",
  baseline_accuracy_raw: "Nearest neighbour, raw",
  baseline_accuracy_standardized: "Nearest neighbour, standardized",
  unknown_auroc: "Unknown separated from known (AUROC)",
  unknown_auroc_of_distance: "The same by distance only",
  unknown_noticed: "Unknown noticed",
  unknown_noticed_at_rate: "Unknown noticed at the false-alarm rate",
  unknown_noticed_at_rate_of_distance: "The same by distance only, at the rate",
  unknown_false_alarms: "Known read as unknown",
  baseline_unknown_auroc: "Unknown separated by the nearest neighbour (AUROC)",
  baseline_unknown_noticed_at_rate: "Unknown noticed by the nearest neighbour",
  individuals_apart: "No neuron wins two classes",
  areas_connected: "One connected area per class",
  classes_separated: "Classes separated",
  samples_ambiguous: "Ambiguous samples",
  neighbours_same_class: "Samples with neighbours of the same class",
  winner_shared_within_class: "Samples that share a winner with their class",
  on_border: "Winners on the border",
  neurons: "Neurons",
  connected_parts: "Connected parts of the map",
  order_around: "Order around the map",
  order_within: "Order within a group",
  order_along: "Order along a line",
  right_size_wrong_group: "Right size, wrong group",
  placed_with_most_similar: "Placed near the most similar",
  quantization_error: "Quantization error",
  topographic_error: "Topographic error",
  accuracy_chance: "Accuracy by chance",
  prediction_error: "Prediction error",
  strongest_right: "Strongest element predicted",
  strongest_distance: "Distance of the strongest neurons",
  steps_right: "Frames predicted before an error",
  forgetting: "Forgetting",
  values_kept: "Values kept",
  baseline_forgetting: "Forgetting, nearest neighbour",
  baseline_values_kept: "Values kept, nearest neighbour",
  plain_som_accuracy: "Accuracy, plain SOM",
  plain_som_forgetting: "Forgetting, plain SOM",
  plain_som_values_kept: "Values kept, plain SOM",
  same_memory_accuracy: "Accuracy, nearest neighbour with the memory of the map",
  same_memory_forgetting: "Forgetting, nearest neighbour with the memory of the map",
  same_memory_values_kept: "Values kept, nearest neighbour with the memory of the map",
};

/**
 * "shape.neighbours_same_class" is ["shape", "neighbours_same_class"]; the label of the study itself has no name there.
 * "altered.first_half.shape.accuracy" is ["shape, first_half", "accuracy"].
 */
export function splitMetric(metric: string): [string, string] {
  const altered = /^altered\.([^.]+)\.(.+)$/s.exec(metric);
  if (altered) {
    const [label, own] = splitMetric(altered[2] ?? "");
    return [`${label ? `${label}, ` : ""}${altered[1]}`, own];
  }
  const match = /^([^.\s]+)\.(.+)$/s.exec(metric);
  return match ? [match[1] ?? "", match[2] ?? ""] : ["", metric];
}

export function metricName(metric: string): string {
  const [, own] = splitMetric(metric);
  const mapped = /^mapped_with (.+) (\S+)$/.exec(own);
  if (mapped) return `Samples of ${mapped[1]} among ${mapped[2]}`;
  const named = /^((?:baseline_)?(?:taught|known)_.+)_after_(\d+)$/.exec(own);
  if (named) return `${kNamed[named[1] ?? ""] ?? capital(named[1] ?? "")} after ${named[2]} ${named[2] === "1" ? "name" : "names"}`;
  return kMetrics[own] ?? capital(own);
}

const kShares = /(^|_)(accuracy|forgetting|apart|connected|border|error|around|within|along|similar|strongest_right|unknown|changed|refused)/;
const kCountsOfSamples =
  /^(samples_ambiguous|neighbours_same_class|winner_shared_within_class|right_size_wrong_group)/;

/** Whether the range of a metric is 0 to 1, whatever the numbers of samples and classes are. */
export function isShare(metric: string): boolean {
  const [, own] = splitMetric(metric);
  const counts = kCountsOfSamples.test(own) || /^(classes_separated|mapped_with|quantization_error|prediction_error)/.test(own);
  return !counts && kShares.test(own);
}

/** The range of a metric, if known. */
export function metricRange(metric: string, samples: number, classes: number): [number, number] | null {
  const [, own] = splitMetric(metric);
  if (own.startsWith("classes_separated")) return [0, Math.max(1, classes)];
  if (kCountsOfSamples.test(own)) return [0, Math.max(1, samples)];
  return isShare(metric) ? [0, 1] : null;
}

export type VerdictKind = "good" | "neutral" | "middling" | "bad";

/** The verdicts of docs/reference/reproduction.md, each with its colour. */
export const kVerdicts: [verdict: string, kind: VerdictKind][] = [
  ["holds", "good"],
  ["holds, but so does chance", "neutral"],
  ["mostly", "middling"],
  ["fails", "bad"],
  ["cannot be decided here", "neutral"],
];

export function kindOf(verdict: string): VerdictKind {
  return kVerdicts.find(([name]) => name === verdict)?.[1] ?? "neutral";
}
