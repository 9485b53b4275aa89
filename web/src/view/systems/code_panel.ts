// The code: the output of a module of the system, at first of the one that the map receives.

import { element, fill } from "../../parts/dom";
import type { State } from "../data";
import type { Model } from "../session/model";
import { ModulePicture } from "./module_picture";
import { Panel } from "../page/panel";

export class CodePanel {
  readonly panel = new Panel(3, "code", "Code");
  private readonly choice = element("select", { "aria-label": "Module", class: "module-choice" });
  private readonly all: HTMLButtonElement;
  private readonly module: ModulePicture;
  private readonly nothing = element("p", { class: "empty" });
  private listed = "";

  constructor(
    private readonly model: Model,
    showAll: () => void,
  ) {
    this.module = new ModulePicture(model);
    this.all = element(
      "button",
      { type: "button", class: "modules-button", title: "The graph of all modules", onclick: showAll },
      ["Graph"],
    );
    this.choice.addEventListener("change", () => model.module.set(this.choice.value));
    this.panel.addTools(this.choice, this.all);
    this.panel.add(this.module.root, this.nothing);
    model.shownState.watch((state) => this.take(state));
    model.module.watch(() => this.draw());
    model.frame.watch(() => this.draw());
    model.theme.watch(() => this.draw());
    this.panel.whenOpen(() => this.draw());
  }

  private take(state: State | null): void {
    const modules = state?.graph?.modules ?? [];
    this.choice.hidden = this.all.hidden = this.module.root.hidden = modules.length === 0;
    this.nothing.hidden = modules.length > 0;
    this.nothing.textContent = state === null ? "Waiting for the program." : "No system is selected.";
    const names = modules.map(({ name }) => name);
    if (names.join("\n") !== this.listed)
      fill(
        this.choice,
        names.map((name) => element("option", { value: name }, [name])),
      );
    this.listed = names.join("\n");
    this.draw();
  }

  private draw(): void {
    this.choice.value = this.model.module.value ?? "";
    if (this.panel.isOpen.value) this.module.draw(this.model.frame.value);
  }
}
