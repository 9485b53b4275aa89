// Gives names to explorations, one after the other, as soon as the program has confirmed the one
// before. Each is for the exploration that the page showed at the press: on a slow line, the next one
// may have begun when the program receives it.

import type { State } from "../data";
import type { Model } from "../session/model";
import { labelOf } from "./known_names";

export interface Outcome {
  kind: "done" | "undone" | "refused";
  words: string;
}

interface Given {
  exploration: number;
  value: string;
}

export class Namer {
  private waiting: Promise<void> = Promise.resolve();
  private readonly pending: Given[] = [];
  private confirmed: Given | null = null; // until the next state
  private isUndoing = false;

  constructor(
    private readonly model: Pick<Model, "send" | "shownState">,
    private readonly notify: (outcome: Outcome) => void,
  ) {
    model.shownState.watch(() => (this.confirmed = null));
  }

  /** The name with this key, from 1. */
  giveKnown(key: number): void {
    const name = this.state?.naming.names[key - 1]?.name;
    if (name === undefined) return this.refuse(`No name has the key ${key}.`);
    this.give(name);
  }

  /** The name that follows by the plan; an exploration that has a name keeps it. */
  accept(): void {
    const next = this.state?.naming.next ?? null;
    if (next === null) return this.refuse("No name is proposed.");
    const given = this.givenName();
    if (given === null) return this.give(next.name);
    this.refuse(`Exploration ${this.exploration! + 1} has the name “${given}”.`);
  }

  give(value: string): void {
    const exploration = this.exploration;
    if (exploration === null) return this.refuse("There is no exploration to name.");
    const last = this.pending.at(-1);
    if (last?.exploration === exploration && last.value === value) return; // pressed twice
    const given = { exploration, value };
    const label = labelOf(this.state!);
    this.pending.push(given);
    this.afterOthers(async () => {
      const isDone = await this.model.send({ command: "name", label, value, exploration });
      this.pending.shift();
      if (isDone) this.confirmed = given;
      this.tell(isDone, "done", wordsOf(given));
    });
  }

  /** Takes back the name that was given last, on any page. */
  undo(): void {
    if (this.isUndoing) return;
    const last = this.pending.at(-1) ?? this.confirmed ?? lastOf(this.state);
    if (last === null) return this.refuse("There is no name to undo.");
    this.isUndoing = true;
    this.afterOthers(async () => {
      const isDone = await this.model.send({ command: "undo_name", exploration: last.exploration });
      this.isUndoing = false;
      this.confirmed = null;
      this.tell(isDone, "undone", `Undone: ${wordsOf(last)}`);
    });
  }

  private get state(): State | null {
    return this.model.shownState.value;
  }

  private get exploration(): number | null {
    return this.state?.exploration ?? null;
  }

  private givenName(): string | null {
    const own = [...this.pending, this.confirmed].filter((one) => one?.exploration === this.exploration);
    return own.at(-1)?.value ?? this.state?.naming.given ?? null;
  }

  private afterOthers(work: () => Promise<void>): void {
    this.waiting = this.waiting.then(work);
  }

  private tell(isDone: boolean, kind: "done" | "undone", words: string): void {
    if (isDone) this.notify({ kind, words });
    else this.refuse(`Refused: ${words}`);
  }

  private refuse(words: string): void {
    this.notify({ kind: "refused", words });
  }
}

function lastOf(state: State | null): Given | null {
  const last = state?.naming.last ?? null;
  return last && { exploration: last.exploration, value: last.name };
}

export function wordsOf({ exploration, value }: Given): string {
  return `Exploration ${exploration + 1}: ${value}`;
}
