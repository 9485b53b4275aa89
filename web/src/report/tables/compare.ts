// Two systems or runs side by side. A neuron that is selected on one side is marked on the other: the
// same neuron of the same map, or of another map the neurons that win the same samples.

import { choice } from "../../parts/controls";
import { element, fill } from "../../parts/dom";
import { registerSection, showInAddress } from "../page/address";
import { lazy } from "../page/lazy";
import { bestSystem, originals } from "./main_results";
import { Selection } from "../page/selection";
import { planeFigures } from "../maps/planes";
import { restored, stateOf } from "../page/selection_state";
import { shownMap } from "../maps/shown_map";
import { mapFigures } from "../maps/system_map";
import { block, type Part } from "../page/system_part";
import { toolbar } from "../page/toolbar";
import type { ReportData, SystemReport } from "../page/unpacked";
import { systemName } from "../page/words";

const kId = "compare";

export function compareSection(data: ReportData): HTMLElement {
  const section = element("section", { id: kId, "aria-labelledby": "compare-title" }, [
    element("h2", { id: "compare-title" }, ["Side by side"]),
    element("p", { class: "muted lead no-print" }, [
      "Select a neuron on one side: the neurons that win the same samples are marked on the other side.",
    ]),
  ]);
  const systems = data.systems.filter(({ grid, protocols }) => grid !== null && protocols.length > 0);
  const sides = new Sides(systems, startOf(systems, data));
  registerSection(kId, sides);
  section.append(lazy(800, () => [sides.element]));
  return section;
}

/** Whether there is anything to compare. */
export function canCompare({ systems }: ReportData): boolean {
  const shown = systems.filter(({ grid }) => grid !== null);
  return shown.length > 1 || shown.some(({ protocols }) => protocols.some(({ runs }) => runs.length > 1));
}

/** The best system beside the next one, or two of its runs. */
function startOf(systems: SystemReport[], data: ReportData): [number, number] {
  const best = Math.max(0, systems.indexOf(bestSystem(originals(data)) ?? systems[0]!));
  return [best, systems.length > 1 ? (best + 1) % systems.length : best];
}

class Sides {
  readonly element = element("div", { class: "sides" });
  private readonly sides: Side[];

  constructor(systems: SystemReport[], [left, right]: [number, number]) {
    const changed = (from: number) => {
      this.link(from);
      showInAddress(kId);
    };
    const runs = [0, left === right ? 1 : 0]; // a system beside itself shows two runs
    this.sides = [left, right].map((index, i) => new Side(systems, index, runs[i]!, i, () => changed(i)));
    fill(this.element, this.sides.map((side) => side.element));
  }

  state(): Record<string, string> {
    return Object.fromEntries(this.sides.flatMap((side, i) => side.state().map(([name, value]) => [`${name}${i + 1}`, value])));
  }

  restore(state: URLSearchParams): void {
    this.sides.forEach((side, i) => {
      const own = [...state].filter(([name]) => name.endsWith(String(i + 1)));
      side.restore(new URLSearchParams(own.map(([name, value]) => [name.slice(0, -1), value])));
    });
  }

  /** Marks on the other side what is selected on the side that changed. */
  private link(from: number): void {
    const [source, target] = [this.sides[from], this.sides[1 - from]];
    if (source && target) target.mark(counterparts(source.selection, target.selection));
  }
}

/** The neurons that win on one map the samples that the selected neuron wins on another one. */
export function counterparts(from: Selection, to: Selection): number[] {
  const { neuron, run } = from;
  const other = to.run;
  if (neuron === null || !run || !other) return [];
  if (run === other && from.fold === to.fold) return [neuron];
  // The samples of different recordings or studies do not correspond.
  const isSame = from.system.data_hash === to.system.data_hash && run.recording === other.recording;
  if (!isSame || run.labels.length !== other.labels.length) return [];
  const [own, theirs] = [shownMap(from), shownMap(to)];
  if (!own || !theirs) return [];
  const won = new Set(own.samples.filter((_, i) => own.winners[i] === neuron));
  return [...new Set(theirs.winners.filter((_, i) => won.has(theirs.samples[i] ?? -1)))];
}

class Side {
  readonly element = element("div", { class: "side-of-two" });
  selection!: Selection;
  private index = -1;
  private readonly place = element("div");
  private readonly systems;

  constructor(
    private readonly all: SystemReport[],
    index: number,
    run: number,
    private readonly number: number,
    private readonly onChange: () => void,
  ) {
    this.systems = choice("System", all.map((system) => systemName(system)), index, (chosen) => {
      this.show(chosen, 0);
      this.onChange();
    });
    this.show(index, run);
    fill(this.element, [element("div", { class: "controls" }, [this.systems.element]), this.place]);
  }

  state(): [string, string][] {
    return [["system", String(this.index + 1)], ...Object.entries(stateOf(this.selection))];
  }

  restore(state: URLSearchParams): void {
    this.show(Math.min(this.all.length, Math.max(1, Number(state.get("system") ?? 1))) - 1, 0);
    restored(this.selection, state);
  }

  mark(neurons: number[]): void {
    this.selection.setMarks(neurons);
  }

  private weights(): Part {
    const { selection, number } = this;
    return { title: "Weights of the neurons", height: 560, make: () => planeFigures(selection, `${kId}-${number + 1}-`) };
  }

  private show(index: number, run: number): void {
    const system = this.all[index];
    if (!system || index === this.index) return;
    this.index = index;
    this.systems.set(index);
    this.selection = new Selection(system);
    this.selection.setRun(run);
    const figures = mapFigures(this.selection, { large: 420, small: 260 }, `${kId}-${this.number + 1}-`);
    const hasPlanes = (system.trained?.planes.length ?? 0) > 0;
    const weights = hasPlanes ? block(this.weights(), false) : null;
    this.selection.listen(this.onChange);
    this.selection.listenToNeuron(this.onChange);
    fill(this.place, [toolbar(this.selection), element("div", { class: "maps-of-side" }, figures), weights]);
  }
}
