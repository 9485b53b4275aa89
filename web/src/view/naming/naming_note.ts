// States, shows and sounds what has become of a name that was given.

import { element, write } from "../../parts/dom";
import { Speaker } from "../page/speaker";
import type { Tones } from "../page/tones";
import type { Outcome } from "./namer";

const kMarks: Record<Outcome["kind"], string> = { done: "✓", undone: "✓", unsaved: "!", refused: "✗" };

export class NamingNote {
  readonly root = element("span", { class: "naming-note" });
  private readonly words = element("span");
  private readonly speaker = new Speaker("naming-spoken");
  private count = 0;

  constructor(private readonly tones: Tones) {
    this.root.append(this.words, this.speaker.root);
  }

  show({ kind, words }: Outcome): void {
    this.count += 1;
    const isGood = kind === "done" || kind === "undone";
    this.root.classList.toggle("refused", !isGood);
    write(this.words, `${kMarks[kind]} ${words}`);
    this.speaker.say(String(this.count), words);
    this.tones.play(isGood ? kind : "refused");
  }
}
