// The state of the system: the graph of its modules, and the values of the selected one.

import { element, fill } from "../parts/dom";
import { graphPicture, type GraphPicture } from "../parts/graph_picture";
import type { Frame, State } from "./data";
import type { Model } from "./model";
import { ModulePicture } from "./module_picture";
import { Panel } from "./panel";

export class SystemPanel {
  readonly panel = new Panel(6, "system", "Inside the system");
  private readonly graphPlace = element("div", {
    class: "graph-place",
    tabindex: 0,
    role: "group",
    "aria-label": "Modules",
  });
  private readonly module: ModulePicture;
  private readonly nothing = element("p", { class: "empty" });
  private picture: GraphPicture | null = null;
  private built = "";

  constructor(private readonly model: Model) {
    this.module = new ModulePicture(model);
    this.panel.add(this.graphPlace, this.module.root, this.nothing);
    model.shownState.watch((state) => this.take(state));
    model.module.watch((name) => this.choose(name));
    model.frame.watch((frame) => this.draw(frame));
    model.theme.watch(() => this.draw(model.frame.value));
    this.panel.whenOpen(() => this.draw(model.frame.value));
  }

  private take(state: State | null): void {
    const graph = state?.graph ?? null;
    this.graphPlace.hidden = this.module.root.hidden = graph === null;
    this.nothing.hidden = graph !== null;
    this.nothing.textContent = state === null ? "Waiting for the program." : "No system is selected.";
    const text = JSON.stringify(graph);
    if (text === this.built) return;
    this.built = text;
    this.picture = graph && graphPicture(graph, ({ name }) => this.model.module.set(name));
    fill(this.graphPlace, [this.picture?.svg ?? null]);
    this.choose(this.model.module.value);
  }

  private choose(name: string | null): void {
    this.picture?.select(name);
    this.reveal();
    this.draw(this.model.frame.value);
  }

  /** The graph is often wider than its element. */
  private reveal(): void {
    const box = this.graphPlace.querySelector(".module.chosen")?.getBoundingClientRect();
    const place = this.graphPlace.getBoundingClientRect();
    if (box === undefined || place.width === 0) return;
    this.graphPlace.scrollLeft += box.left + box.width / 2 - place.left - place.width / 2;
    this.graphPlace.scrollTop += box.top + box.height / 2 - place.top - place.height / 2;
  }

  private draw(frame: Frame | null): void {
    if (this.panel.isOpen.value) this.module.draw(frame);
  }
}
