// The selection for a system: a protocol, a label and a run. Figures listen to its changes.

import { labelNames } from "./labels";
import type { ProtocolData, RunData, SystemReport } from "./data";

export class Selection {
  protocolIndex = 0;
  labelIndex = 0;
  runIndex = 0;
  private readonly listeners: (() => void)[] = [];

  constructor(readonly system: SystemReport) {}

  get protocol(): ProtocolData | undefined {
    return this.system.protocols[this.protocolIndex];
  }

  get labels(): string[] {
    return this.protocol ? labelNames(this.system, this.protocol) : [];
  }

  get label(): string {
    return this.labels[this.labelIndex] ?? "";
  }

  get run(): RunData | undefined {
    return this.protocol?.runs[this.runIndex];
  }

  /** The label and the run are kept if the new protocol has them. */
  setProtocol(index: number): void {
    const label = this.label;
    this.protocolIndex = index;
    this.labelIndex = Math.max(0, this.labels.indexOf(label));
    this.runIndex = Math.max(0, Math.min(this.runIndex, (this.protocol?.runs.length ?? 1) - 1));
    this.notify();
  }

  setLabel(index: number): void {
    this.labelIndex = index;
    this.notify();
  }

  setRun(index: number): void {
    this.runIndex = index;
    this.notify();
  }

  listen(listener: () => void): void {
    this.listeners.push(listener);
  }

  private notify(): void {
    this.listeners.forEach((listener) => listener());
  }
}
