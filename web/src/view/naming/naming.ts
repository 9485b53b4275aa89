// The name of what is touched. A click changes it: the label of the current exploration.

import { element, fill, write } from "../../parts/dom";
import type { State } from "../data";
import { KnownNames, labelOf } from "./known_names";
import type { Model } from "../session/model";
import type { Namer } from "./namer";
import type { NamingNote } from "./naming_note";
import { kUnknown } from "./truth";

export class Naming {
  readonly root = element("div", { class: "naming" });
  private readonly name = element("button", { type: "button", class: "naming-name" });
  private readonly undo = element("button", { type: "button", class: "naming-undo", title: "Take back the last name (u)" });
  private readonly known = new KnownNames();
  private readonly input = element("input", {
    type: "text",
    required: true,
    maxlength: 80,
    list: this.known.root.id,
    "aria-label": "Name of what is touched",
  });
  private readonly form: HTMLFormElement;

  constructor(
    private readonly model: Model,
    private readonly namer: Namer,
    note: NamingNote,
  ) {
    const cancel = element("button", { type: "button", onclick: () => this.edit(false) }, ["Cancel"]);
    this.form = element("form", { hidden: true }, [
      this.input,
      element("button", { type: "submit", class: "primary" }, ["Set name"]),
      cancel,
      this.known.root,
    ]);
    fill(this.root, [this.name, this.form, this.undo, note.root]);
    this.undo.addEventListener("click", () => this.namer.undo());
    this.name.addEventListener("click", () => this.edit(true));
    this.form.addEventListener("submit", (event) => this.submit(event));
    this.form.addEventListener("keydown", (event) => event.key === "Escape" && this.edit(false));
    model.shownState.watch((state) => state && this.show(state));
  }

  private show(state: State): void {
    const label = labelOf(state);
    const value = state.labels[label] === kUnknown ? undefined : state.labels[label];
    this.root.hidden = state.exploration === null;
    fill(this.name, [
      element("span", { class: "muted" }, [`${label} `]),
      element("strong", {}, [value ?? "not named"]),
    ]);
    this.name.title = `Change the name of what is touched in this exploration${state.teaches ? "; the system learns it" : ""}`;
    this.known.show(state);
    const last = state.naming.last;
    this.undo.hidden = last === null;
    write(this.undo, last === null ? "" : `Undo “${last.name}” of exploration ${last.exploration + 1}`);
  }

  edit(edits: boolean): void {
    const state = this.model.shownState.value;
    if (edits && (state?.exploration ?? null) === null) return;
    this.form.hidden = !edits;
    this.name.hidden = edits;
    if (!edits || state === null) return this.name.focus();
    this.input.value = state.labels[labelOf(state)] ?? "";
    this.input.focus();
    this.input.select();
  }

  private submit(event: Event): void {
    event.preventDefault();
    const value = this.input.value.trim();
    if (value === "") return;
    this.namer.give(value);
    this.edit(false);
  }
}
