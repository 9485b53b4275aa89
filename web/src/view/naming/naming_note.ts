// States, shows and sounds what has become of a name that was given.

import { element, write } from "../../parts/dom";
import { Speaker } from "../page/speaker";
import type { Tones } from "../page/tones";
import type { Outcome } from "./namer";

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
    this.root.classList.toggle("refused", kind === "refused");
    write(this.words, `${kind === "refused" ? "✗" : "✓"} ${words}`);
    this.speaker.say(String(this.count), words);
    this.tones.play(kind);
  }
}
