// The selection for a system: a protocol, a label, a run and a neuron. Figures listen to its changes.

import type { GridData } from "../../parts/data";
import { labelNames } from "../tables/labels";
import type { ProtocolData, RunData, RunMap, SystemReport } from "./unpacked";
import { hasOneMap } from "./words";

export class Selection {
  protocolIndex = 0;
  labelIndex = 0;
  runIndex = 0;
  neuron: number | null = null;
  marks: readonly number[] = []; // neurons that correspond to a selection on another map
  private readonly listeners: (() => void)[] = [];
  private readonly neuronListeners: ((neuron: number | null) => void)[] = [];
  private readonly markListeners: (() => void)[] = [];

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

  /** The map of the selected winners; null if they are of several maps, or if it was not stored. */
  get map(): RunMap | null {
    return this.run?.map ?? null;
  }

  /** The grid of the selected winners. Without a stored map that of the saved system. */
  get grid(): GridData | null {
    return this.map?.grid ?? this.system.grid;
  }

  /** Whether the selected winners are neurons of the trained system that was saved. */
  get isOfSavedMap(): boolean {
    const { protocol, run, system } = this;
    if (!protocol || !run || !system.trained) return false;
    return hasOneMap(protocol) && run.seed === system.trained.seed && run.recording === 0;
  }

  /** The run of the saved system, if the protocol has it. */
  get savedRunIndex(): number {
    const seed = this.system.trained?.seed;
    return this.protocol?.runs.findIndex((run) => run.seed === seed && run.recording === 0) ?? -1;
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

  setNeuron(neuron: number | null): void {
    if (neuron === this.neuron) return;
    this.neuron = neuron;
    this.neuronListeners.forEach((listener) => listener(neuron));
  }

  setMarks(neurons: readonly number[]): void {
    this.marks = neurons;
    this.markListeners.forEach((listener) => listener());
  }

  /** Calls `listener` after each change of protocol, label and run. */
  listen(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** Calls `listener` after each change of the neuron. */
  listenToNeuron(listener: (neuron: number | null) => void): void {
    this.neuronListeners.push(listener);
  }

  listenToMarks(listener: () => void): void {
    this.markListeners.push(listener);
  }

  private notify(): void {
    this.listeners.forEach((listener) => listener());
  }
}
