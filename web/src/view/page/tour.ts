// A tour of the page in five steps: each panel in the order of the data, with a sentence.

import { element } from "../../parts/dom";
import type { Panel } from "./panel";

const kSteps: [string, string][] = [
  ["hand", "The body explores an object. Drag to look around it; touch sensors light up on contact."],
  ["skin", "The skin: every touch sensor of the hand. Grey ones feel nothing; bright ones are pressed."],
  ["code", "The code: the system combines joint angles and touch into one vector of numbers."],
  ["map", "The map: each cell is a neuron. The bright cells respond most to the present code."],
  ["name", "The name: the class of the neuron that responds most, and whether it is right. If the system asks for the name of an unknown object, it learns it."],
];

export class Tour {
  readonly root: HTMLElement;
  private readonly count = element("p", { class: "muted small" });
  private readonly words = element("p");
  private readonly back = element("button", { type: "button" }, ["Back"]);
  private readonly next = element("button", { type: "button", class: "primary" }, ["Next"]);
  private at = 0;
  private opener: Element | null = null;

  constructor(private readonly panels: readonly Panel[]) {
    const end = element("button", { type: "button", onclick: () => this.end() }, ["End tour"]);
    this.back.addEventListener("click", () => this.go(this.at - 1));
    this.next.addEventListener("click", () => this.go(this.at + 1));
    const buttons = element("div", { class: "tour-buttons" }, [end, this.back, this.next]);
    const text = element("div", { "aria-live": "polite" }, [this.count, this.words]);
    const label = { class: "tour", role: "dialog", "aria-label": "Tour of the page", hidden: true };
    this.root = element("div", label, [text, buttons]);
    this.root.addEventListener("keydown", (event) => {
      if (event.key === "Escape") this.end();
    });
  }

  begin(): void {
    this.opener = document.activeElement;
    this.root.hidden = false;
    this.go(0);
    this.next.focus();
  }

  private go(step: number): void {
    if (step >= kSteps.length) return this.end();
    this.at = Math.max(0, step);
    const [name, words] = kSteps[this.at]!;
    this.count.textContent = `Step ${this.at + 1} of ${kSteps.length}`;
    this.words.textContent = words;
    this.back.disabled = this.at === 0;
    this.next.textContent = this.at === kSteps.length - 1 ? "Done" : "Next";
    this.mark(name);
  }

  private end(): void {
    this.root.hidden = true;
    this.mark(null);
    if (this.opener instanceof HTMLElement) this.opener.focus();
  }

  /** The panel is outlined, and scrolled to. */
  private mark(name: string | null): void {
    for (const panel of this.panels) {
      panel.root.classList.toggle("toured", panel.name === name);
      if (panel.name === name) panel.root.scrollIntoView({ block: "nearest" });
    }
  }
}
