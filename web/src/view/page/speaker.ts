// Announces changes to screen readers at a limited rate.

import { element } from "../../parts/dom";

const kPause = 2500; // ms

export class Speaker {
  readonly root: HTMLElement;
  private said = ""; // the subject of the last announcement
  private waiting: { about: string; words: string } | null = null;
  private resting = false;

  constructor(name: string) {
    this.root = element("p", { class: `hidden-text ${name}`, "aria-live": "polite" });
  }

  /** Announces `words` unless their subject was announced last. */
  say(about: string, words: string): void {
    this.waiting = { about, words };
    if (!this.resting) this.next();
  }

  private next(): void {
    const next = this.waiting;
    this.waiting = null;
    this.resting = false;
    if (next === null || next.about === this.said) return;
    this.said = next.about;
    this.root.textContent = next.words;
    this.resting = true;
    window.setTimeout(() => this.next(), kPause);
  }
}
