// The selection of a system as part of an address. Protocols and neurons are counted from 1.

import { neuronCount } from "../../parts/maps/grid";
import type { Selection } from "./selection";

/** Only what differs from the initial selection. */
export function stateOf({ protocolIndex, labelIndex, runIndex, chosenFold, neuron, run, label }: Selection): Record<string, string> {
  return {
    ...(protocolIndex > 0 ? { protocol: String(protocolIndex + 1) } : {}),
    ...(labelIndex > 0 ? { label } : {}),
    ...(runIndex > 0 && run ? { run: String(runIndex + 1) } : {}),
    ...(typeof chosenFold === "number" ? { fold: String(chosenFold + 1) } : {}),
    ...(neuron !== null ? { neuron: String(neuron + 1) } : {}),
  };
}

/** The names of what an address states and the selection does not have. */
export function refused(selection: Selection, state: URLSearchParams): string[] {
  const kept = { protocol: "1", label: selection.labels[0] ?? "", run: "1", ...stateOf(selection) };
  return [...state].filter(([name, value]) => (kept as Record<string, string>)[name] !== value).map(([name]) => name);
}

/** Selects what an address states; anything that the system does not have is left out. */
export function restored(selection: Selection, state: URLSearchParams): void {
  const { system } = selection;
  const number = (name: string) => Number(state.get(name) ?? 1) - 1;
  const isIn = (index: number, count: number) => Number.isInteger(index) && index >= 0 && index < count;
  if (isIn(number("protocol"), system.protocols.length)) selection.setProtocol(number("protocol"));
  const label = selection.labels.indexOf(state.get("label") ?? selection.labels[0] ?? "");
  if (label >= 0) selection.setLabel(label);
  if (isIn(number("run"), selection.protocol?.runs.length ?? 0)) selection.setRun(number("run"));
  if (state.has("fold") && isIn(number("fold"), selection.folds)) selection.setFold(number("fold"));
  const neurons = selection.grid ? neuronCount(selection.grid) : 0;
  const neuron = Number(state.get("neuron") ?? 0) - 1;
  selection.setNeuron(isIn(neuron, neurons) ? neuron : null);
}
