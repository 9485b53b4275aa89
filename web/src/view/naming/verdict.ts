// Whether a reading is right.

import type { Reading, State } from "../data";
import { kUnknown, truthOf } from "./truth";

export interface Verdict {
  isRight: boolean;
  words: string;
}

/** Whether the exploration is too far from all that was learned. Without a threshold, `unknown` is the name of a class. */
export function isUnknown(reading: Reading): boolean {
  return reading.novelty !== null && reading.answer === kUnknown;
}

/** Null if the true name is not known. */
export function verdictOf(reading: Reading, state: State, exploration: number): Verdict | null {
  const truth = truthOf(state, exploration);
  if (truth === null) return null;
  if (!isUnknown(reading)) {
    const isRight = truth === reading.answer;
    return { isRight, words: isRight ? "✓ Right" : `✗ Wrong: it is ${truth}` };
  }
  const isRight = !learnedNames(state).includes(truth);
  return { isRight, words: isRight ? `✓ Right: ${truth} has not been learned` : `✗ Not recognized: it is ${truth}` };
}

/** Only the map that answers has classes. */
function learnedNames(state: State): string[] {
  return state.maps.flatMap(({ classes }) => classes);
}
