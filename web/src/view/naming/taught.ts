// The explorations that were taught to the system in this view, in words.

import { neuronWords } from "../../parts/maps/grid";
import type { Frame, MapData, State, Taught } from "../data";

/** The entry of an exploration; null if it was not taught. */
export function taughtFrom(state: State, exploration: number): Taught | null {
  return state.taught.find((one) => one.exploration === exploration) ?? null;
}

export function taughtWords({ name, before, neuron, problem }: Taught, state: State): string {
  if (problem !== null) return problem;
  if (neuron === null) return `Counted as “${name}”; no neuron changed.`;
  const grid = answeringMap(state)?.grid;
  const where = grid === undefined ? "a neuron" : `the ${neuronWords(grid, neuron)}`;
  return `Learned as “${name}” (read as ${before} before): ${where} represents it. No other neuron changed.`;
}

/** A remark if the name that is read was learned in this view from other explorations, otherwise null. */
export function originWords(frame: Frame, state: State): string | null {
  const name = frame.reading?.answer;
  const learned = state.taught.filter((one) => one.name === name && one.neuron !== null);
  if (learned.length === 0 || learned.some(({ exploration }) => exploration === frame.exploration)) return null;
  const neurons = learned.map(({ neuron }) => neuron);
  const map = answeringMap(state);
  const winner = frame.maps[map?.module ?? ""]?.winner;
  if (!neurons.includes(winner ?? null) && !neuronsOf(map, name!).every((neuron) => neurons.includes(neuron)))
    return null; // a neuron that had this name before may have answered
  return `Learned in this session, from ${listed(learned.map(({ exploration }) => exploration + 1))}.`;
}

/** The map that answers; null if it cannot be drawn. */
export function answeringMap(state: State): MapData | null {
  return state.maps.find(({ module }) => module === state.graph?.map) ?? null;
}

function neuronsOf(map: MapData | null, name: string): number[] {
  const number = map?.classes.indexOf(name) ?? -1;
  return map?.neuron_classes.flatMap((one, neuron) => (one === number ? [neuron] : [])) ?? [];
}

/** "exploration 7", "explorations 7, 8 and 9". */
function listed(numbers: number[]): string {
  if (numbers.length === 1) return `exploration ${numbers[0]}`;
  return `explorations ${numbers.slice(0, -1).join(", ")} and ${numbers.at(-1)}`;
}
