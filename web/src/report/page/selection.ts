// The selection for a system: a protocol, a label, a run and a neuron. Figures listen to its changes.

import type { GridData } from "../../parts/data";
import { labelNames } from "../tables/labels";
import type { ProtocolData, RunData, RunMap, SystemReport } from "./unpacked";
import { foldCount, medianFold, savedMap, shownMap } from "../maps/shown_map";
import { hasOneMap } from "./words";

export class Selection {
  protocolIndex = 0;
  labelIndex = 0;
  runIndex = 0;
  chosenFold: number | null | undefined = undefined; // null: the saved system; undefined: the default
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

  /** The number of trainings by which the samples of the protocol were tested; 0 if there is one, or if it is unknown. */
  get folds(): number {
    return this.protocol ? foldCount(this.protocol) : 0;
  }

  /** The training whose map is shown; null: that of the saved system. By default the latter, if it is of this run. */
  get fold(): number | null {
    const { protocol, run, chosenFold, folds } = this;
    if (!protocol || !run || folds === 0) return null;
    const isSaved = this.canShowSaved && (chosenFold === null || chosenFold === undefined);
    if (isSaved) return null;
    return typeof chosenFold === "number" && chosenFold < folds ? chosenFold : medianFold(protocol, run);
  }

  /** Whether the saved system has the seed of the selected run, and its samples are known. */
  get canShowSaved(): boolean {
    return this.isOfSavedRun && savedMap(this.system) !== null;
  }

  get isOfSavedRun(): boolean {
    const { run, system } = this;
    return run !== undefined && system.trained !== null && run.seed === system.trained.seed && run.recording === 0;
  }

  /** Whether the selected winners are neurons of the trained system that was saved. */
  get isOfSavedMap(): boolean {
    const { protocol } = this;
    if (!protocol || !this.isOfSavedRun) return false;
    return hasOneMap(protocol) || shownMap(this)?.kind === "saved";
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
    this.chosenFold = undefined;
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

  /** null: the saved system. */
  setFold(fold: number | null): void {
    this.chosenFold = fold;
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
