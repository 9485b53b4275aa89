// The names with their keys and counts, and what follows by the plan. While this is open, the keys 1
// to 9 give names; the browser keeps whether it is open.

import { element, fill, write } from "../../parts/dom";
import { keep, kept } from "../../parts/kept";
import type { State } from "../data";
import type { Tones } from "../page/tones";
import type { Model } from "../session/model";
import type { Namer } from "./namer";

const kKey = "somato-name-keys";
const kKeyed = 9; // names

export class NameKeys {
  readonly root: HTMLDetailsElement;
  private readonly list = element("ul", { class: "name-key-list", "aria-label": "Names" });
  private readonly none = element("p", { class: "muted" }, ["No name yet: press n to type one."]);
  private readonly next = element("p", { class: "name-key-row" });
  private readonly nextWords = element("span");
  private readonly each = element("input", { type: "number", min: 0, max: 1000, placeholder: "–" });
  private listed = "";
  private isChosen = false; // open or not, by the user

  constructor(
    private readonly model: Model,
    private readonly namer: Namer,
    tones: Tones,
  ) {
    const accept = { type: "button", title: "Give this name (0 or Enter)", onclick: () => namer.accept() };
    fill(this.next, [this.nextWords, element("button", accept, ["Give it"])]);
    this.root = element("details", { class: "name-keys" }, [
      element("summary", { title: "While this is open, the keys 1 to 9 give names" }, ["Names by keys"]),
      this.list,
      this.none,
      this.next,
      element("div", { class: "name-key-row" }, [
        element("label", {}, ["Of each", this.each]),
        soundSwitch(tones),
      ]),
    ]);
    this.each.addEventListener("change", () => this.plan());
    this.root.querySelector("summary")!.addEventListener("click", () => this.choose(!this.root.open));
    model.shownState.watch((state) => state && this.show(state));
  }

  /** Whether the keys give names. */
  get isOn(): boolean {
    return this.root.open && this.root.closest("[hidden]") === null; // a collapsed panel hides it
  }

  private show(state: State): void {
    const { names, each, next } = state.naming;
    this.root.hidden = state.exploration === null && names.length === 0;
    if (!this.isChosen) this.root.open = isOpenAtFirst(state);
    this.showNames(state);
    this.none.hidden = names.length > 0;
    this.next.hidden = each === null;
    this.next.querySelector("button")!.hidden = next === null;
    write(this.nextWords, next === null ? "The plan is fulfilled." : `Next: ${next.name}, ${next.number} of ${each}`);
    if (document.activeElement !== this.each) this.each.value = String(each ?? "");
  }

  private showNames({ naming: { names, each, next, given } }: State): void {
    const text = JSON.stringify([names, each, next, given]);
    if (text === this.listed) return;
    this.listed = text;
    const focused = [...this.list.querySelectorAll("button")].indexOf(document.activeElement as HTMLButtonElement);
    fill(
      this.list,
      names.map(({ name, explorations }, i) => {
        const count = each === null ? `${explorations}` : `${explorations} of ${each}`;
        const key = i < kKeyed ? element("kbd", {}, [String(i + 1)]) : null;
        const parts = [key, element("span", {}, [name]), element("span", { class: "muted" }, [count])];
        const attributes = { type: "button", class: "name-key", "aria-pressed": String(name === given) };
        const one = element("button", { ...attributes, onclick: () => this.namer.give(name) }, parts);
        one.classList.toggle("next", name === next?.name);
        return element("li", {}, [one]);
      }),
    );
    this.list.querySelectorAll("button")[focused]?.focus();
  }

  private choose(open: boolean): void {
    this.isChosen = true;
    keep(kKey, open ? "on" : "off");
  }

  private plan(): void {
    if (this.each.validity.valid) void this.model.send({ command: "plan", each: Number(this.each.value) });
  }
}

/** For what a body explores, except in a demonstration, and for a plan, unless the user has chosen otherwise. */
function isOpenAtFirst({ source, naming, demonstrated }: State): boolean {
  const chosen = kept(kKey);
  if (chosen !== null) return chosen === "on";
  return (source === "body" && demonstrated === null) || naming.each !== null;
}

function soundSwitch(tones: Tones): HTMLElement {
  const box = element("input", { type: "checkbox" });
  box.addEventListener("change", () => tones.turn(box.checked));
  tones.isOn.watch((on) => (box.checked = on));
  return element("label", {}, [box, "Sound"]);
}
