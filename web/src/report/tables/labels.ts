// The classes of a system's samples, by each known label.

import type { ProtocolData, RunData, SystemReport } from "../page/unpacked";

/** The labels for display: that of the study, then those of the explorations. */
export function labelNames(system: SystemReport, protocol: ProtocolData): string[] {
  const others = samplesOf(system, protocol).flatMap((sample) => Object.keys(sample));
  return [...new Set([protocol.label, ...others])];
}

/** The value of `label` for each sample of a run; null if it is unknown. */
export function valuesOf(
  system: SystemReport,
  protocol: ProtocolData,
  run: RunData,
  label: string,
): string[] | null {
  if (label === protocol.label) return run.labels;
  const samples = samplesOf(system, protocol);
  if (samples.length === 0 || samples.length !== run.winners.length) return null;
  return samples.map((sample) => sample[label] ?? "(none)");
}

/** The labels are those of the training recording, not of a separate test recording. */
function samplesOf(system: SystemReport, protocol: ProtocolData): Record<string, string>[] {
  return protocol.protocol === "test_data" ? [] : (system.samples ?? []);
}

/** The prediction for each sample of a run. */
export function predictionsOf(protocol: ProtocolData, run: RunData, label: string): string[] | null {
  if (label === protocol.label) return run.predictions;
  return run.other_predictions?.[label] ?? null;
}

/** Classes in order of appearance, which is the same for every run, so that colours are stable. */
export function classesOf(system: SystemReport, label: string): string[] {
  const found = new Set<string>();
  for (const protocol of system.protocols) {
    for (const run of protocol.runs) {
      for (const value of valuesOf(system, protocol, run, label) ?? []) found.add(value);
    }
  }
  return [...found];
}

export function numbered(values: readonly string[], classes: readonly string[]): number[] {
  const numbers = new Map(classes.map((name, i) => [name, i]));
  return values.map((value) => numbers.get(value) ?? 0);
}
