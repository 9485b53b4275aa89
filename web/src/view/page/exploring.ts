// The object that a body explores, and its placement.

import { element, fill } from "../../parts/dom";
import type { State } from "../data";
import type { Model } from "../session/model";
import { labelled } from "./transport";

const kParts = [
  { name: "x", words: "x", unit: "mm", most: 50 },
  { name: "y", words: "y", unit: "mm", most: 50 },
  { name: "turn", words: "turn", unit: "°", most: 360 },
] as const;

export class Exploring {
  readonly root: HTMLElement;
  private readonly thing = element("select", { "aria-label": "Object", class: "thing-choice" });
  private readonly numbers = kParts.map(({ most }) =>
    element("input", { type: "number", step: 1, min: -most, max: most, value: 0 }),
  );
  private readonly fields = kParts.map(({ words, unit }, i) => labelled(`${words} (${unit})`, this.numbers[i]!));
  private readonly again = element("button", { type: "button", class: "primary" }, ["Explore"]);
  private listed = "";

  constructor(private readonly model: Model) {
    const label = { class: "exploring", role: "group", "aria-label": "Object to explore" };
    this.root = element("div", label, [labelled("Object", this.thing), ...this.fields, this.again]);
    this.thing.addEventListener(
      "change",
      () => void model.send({ command: "thing", name: this.thing.value }),
    );
    this.again.addEventListener("click", () => void model.send({ command: "explore" }));
    for (const number of this.numbers) number.addEventListener("change", () => this.place());
    model.shownState.watch((state) => this.show(state));
  }

  private place(): void {
    const [x, y, turn] = this.numbers.map((number) => Number(number.value) || 0) as [number, number, number];
    void this.model.send({ command: "placement", x, y, turn });
  }

  private show(state: State | null): void {
    this.root.hidden = state === null || state.source !== "body";
    if (state === null) return;
    const names = state.things.map(({ name }) => name);
    if (names.join("\n") !== this.listed)
      fill(
        this.thing,
        names.map((name) => element("option", { value: name }, [name])),
      );
    this.listed = names.join("\n");
    this.thing.value = state.thing ?? "";
    this.again.textContent = state.awaits_start ? "Start" : state.live ? "Restart" : "Explore";
    this.numbers.forEach((number, i) => {
      const value = state.placement?.[kParts[i]!.name];
      this.fields[i]!.hidden = value === undefined; // a probe has its material below it
      if (document.activeElement !== number) number.value = String(value ?? 0);
    });
  }
}
