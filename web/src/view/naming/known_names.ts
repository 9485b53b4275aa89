// The names that are suggested where a name is given: those of the objects, and those given before.

import { element, fill, uniqueId } from "../../parts/dom";
import type { State } from "../data";
import { kUnknown } from "./truth";

export class KnownNames {
  readonly root = element("datalist", { id: uniqueId("names") });
  private listed = "";

  show(state: State): void {
    const names = [...new Set([...state.things.map(({ name }) => name), ...given(state, labelOf(state))])];
    if (names.join("\n") === this.listed) return;
    this.listed = names.join("\n");
    fill(
      this.root,
      names.map((name) => element("option", { value: name })),
    );
  }
}

/** The label that the system predicts, so that it can be trained on the given names. */
export function labelOf(state: State): string {
  return state.label ?? "object";
}

function given(state: State, label: string): string[] {
  const names = state.explorations.flatMap(({ labels }) => labels[label] ?? []);
  return names.filter((name) => name !== kUnknown);
}
