// The samples of a system whose sensor readings are on the page, and which of them is shown.

import type { Labels } from "../../parts/data";
import type { MomentData, SystemReport } from "../page/unpacked";

export class Samples {
  index = 0; // in `names`
  plays = false; // whether the exploration begins to play when it is shown
  readonly names: string[];
  private readonly samples: number[]; // the samples that have readings
  private readonly listeners: (() => void)[] = [];

  constructor(private readonly system: SystemReport) {
    this.samples = system.moments.flatMap((moment, sample) => (moment === null ? [] : [sample]));
    this.names = this.samples.map((sample) => nameOf(system, sample));
  }

  get moment(): MomentData | null {
    return this.system.moments[this.samples[this.index] ?? -1] ?? null;
  }

  get name(): string {
    return this.names[this.index] ?? "";
  }

  /** The place of a sample among those with readings; null without readings. */
  placeOf(sample: number): number | null {
    const index = this.samples.indexOf(sample);
    return index < 0 ? null : index;
  }

  choose(index: number, plays = false): void {
    this.index = index;
    this.plays = plays;
    this.listeners.forEach((listener) => listener());
  }

  listen(listener: () => void): void {
    this.listeners.push(listener);
  }
}

/** "boccia, trial 3": the studied label and what distinguishes explorations with the same one. */
export function nameOf(system: SystemReport, sample: number): string {
  const labels: Labels = system.moments[sample]?.labels ?? system.samples?.[sample] ?? {};
  const own = labels[system.protocols[0]?.label ?? ""] ?? Object.values(labels)[0] ?? `exploration ${sample + 1}`;
  return labels["trial"] === undefined ? own : `${own}, trial ${labels["trial"]}`;
}
