// The true class of the explored object, by the label that the system predicts.

import type { State } from "../data";

/** A reading that is too far from all classes, and the label of explorations that have no name. */
export const kUnknown = "unknown";

/** The value of the label for an exploration; null if it is unknown. */
export function truthOf(state: State, exploration: number): string | null {
  if (state.label === null) return null;
  const labels = state.explorations.find(({ index }) => index === exploration)?.labels;
  const given = labels?.[state.label] ?? null;
  if (labels !== undefined) return given === kUnknown ? null : given;
  return state.live ? ofThing(state, state.label) : null;
}

/** While a body explores, its labels are those of the selected thing. */
function ofThing(state: State, label: string): string | null {
  const thing = state.things.find(({ name }) => name === state.thing);
  if (thing === undefined) return null;
  if (label === "object") return thing.name;
  const known: Record<string, string | null> = {
    material: thing.material,
    shape: thing.shape,
    hardness: thing.hardness,
  };
  return known[label] ?? null;
}
