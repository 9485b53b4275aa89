// The names of protocols and metrics in words; ../metrics.ts has those of each metric.

import { capital } from "../../parts/numbers";
import { kMetrics, type MetricInfo, type MetricRange } from "../metrics";
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

/** The entry of a metric without its label, whose name may end in "_chance" or "_after_N". */
function infoOf(own: string): MetricInfo | undefined {
  return kMetrics.get(own.replace(/^(?:[^.\s]+\.)+/, "").replace(/_chance$/, "").replace(/_after_.*$/, ""));
}

function wordsOf(own: string): string {
  return kMetrics.get(own)?.words ?? capital(own);
}

export function metricName(metric: string): string {
  const [, own] = splitMetric(metric);
  const mapped = /^mapped_with (.+) (\S+)$/.exec(own);
  if (mapped) return `Samples of ${mapped[1]} among ${mapped[2]}`;
  // The number of names follows metrics of the classes left out whose name is given, and of the known ones.
  const named = /^((?:baseline_)?(?:taught|known)_.+)_after_(\d+)$/.exec(own);
  if (named) return `${wordsOf(named[1] ?? "")} after ${named[2]} ${named[2] === "1" ? "name" : "names"}`;
  return own === "accuracy_chance" ? `${wordsOf("accuracy")} by chance` : wordsOf(own);
}

/** Whether the range of a metric is 0 to 1, whatever the numbers of samples and classes are. */
export function isShare(metric: string): boolean {
  return infoOf(splitMetric(metric)[1])?.range === "share";
}

const kRanges: Record<MetricRange, (samples: number, classes: number) => [number, number] | null> = {
  share: () => [0, 1],
  signed: () => [-1, 1],
  samples: (samples) => [0, Math.max(1, samples)],
  classes: (_, classes) => [0, Math.max(1, classes)],
  from_zero: () => null,
};

/** The range of a metric, if known. */
export function metricRange(metric: string, samples: number, classes: number): [number, number] | null {
  const info = infoOf(splitMetric(metric)[1]);
  return info ? kRanges[info.range](samples, classes) : null;
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
