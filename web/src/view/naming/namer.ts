// Gives names to explorations, one after the other, as soon as the program has confirmed the one
// before. Each is for the exploration that the page showed at the press: on a slow line, the next one
// may have begun when the program receives it.

import type { State } from "../data";
import type { Answer, Model } from "../session/model";
import { labelOf } from "./known_names";

export interface Outcome {
  kind: "done" | "undone" | "unsaved" | "refused";
  words: string;
}

interface Given {
  exploration: number;
  id: number; // that no other exploration has, also if this one is discarded
  label: string;
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
    const { exploration, id } = this;
    if (exploration === null || id === null) return this.refuse("There is no exploration to name.");
    const last = this.pending.at(-1);
    if (last?.id === id && last.value === value) return; // pressed twice
    const label = labelOf(this.state!);
    const given = { exploration, id, label, value };
    this.pending.push(given);
    this.afterOthers(async () => {
      const answer = await this.model.send({ command: "name", label, value, id });
      this.pending.shift();
      if (answer !== "refused") this.confirmed = given;
      this.tell(answer, "done", wordsOf(given));
    });
  }

  /** Takes back the name that was given last, on any page. */
  undo(): void {
    if (this.isUndoing) return;
    const last = this.pending.at(-1) ?? this.confirmed ?? lastOf(this.state);
    if (last === null) return this.refuse("There is no name to undo.");
    this.isUndoing = true;
    this.afterOthers(async () => {
      const { id, label, value } = last;
      const answer = await this.model.send({ command: "undo_name", id, label, value });
      this.isUndoing = false;
      this.confirmed = null;
      this.tell(answer, "undone", `Undone: ${wordsOf(last)}`);
    });
  }

  private get state(): State | null {
    return this.model.shownState.value;
  }

  private get exploration(): number | null {
    return this.state?.exploration ?? null;
  }

  private get id(): number | null {
    return this.state?.naming.id ?? null;
  }

  private givenName(): string | null {
    const own = [...this.pending, this.confirmed].filter((one) => one?.id === this.id);
    return own.at(-1)?.value ?? this.state?.naming.given ?? null;
  }

  private afterOthers(work: () => Promise<void>): void {
    this.waiting = this.waiting.then(work);
  }

  private tell(answer: Answer, kind: "done" | "undone", words: string): void {
    if (answer === "refused") return this.refuse(`Refused: ${words}`);
    if (answer === "unsaved") return this.notify({ kind: answer, words: `Not saved: ${words}` });
    this.notify({ kind, words });
  }

  private refuse(words: string): void {
    this.notify({ kind: "refused", words });
  }
}

function lastOf(state: State | null): Given | null {
  const last = state?.naming.last ?? null;
  return last && { exploration: last.exploration, id: last.id, label: last.label, value: last.name };
}

function wordsOf({ exploration, value }: Given): string {
  return `Exploration ${exploration + 1}: ${value}`;
}
