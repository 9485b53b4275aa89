// The graph of the system's modules; a click selects the module that the panel "Code" shows.

import { element, fill } from "../../parts/dom";
import { graphPicture, type GraphPicture } from "../../parts/graph_picture";
import type { State } from "../data";
import type { Model } from "../session/model";

export class ModuleGraph {
  readonly root = element("div", {
    class: "graph-place",
    tabindex: 0,
    role: "group",
    "aria-label": "Modules",
  });
  private picture: GraphPicture | null = null;
  private built = "";

  constructor(private readonly model: Model) {
    model.shownState.watch((state) => this.take(state));
    model.module.watch((name) => this.picture?.select(name));
  }

  /** The selected module, where the graph is wider than the page. */
  reveal(): void {
    const box = this.root.querySelector(".module.chosen")?.getBoundingClientRect();
    const place = this.root.getBoundingClientRect();
    if (box !== undefined) this.root.scrollLeft += box.left + box.width / 2 - place.left - place.width / 2;
  }

  private take(state: State | null): void {
    const graph = state?.graph ?? null;
    const text = JSON.stringify(graph);
    if (text === this.built) return;
    this.built = text;
    this.picture = graph && graphPicture(graph, ({ name }) => this.model.module.set(name));
    fill(this.root, [this.picture?.svg ?? null]);
    this.picture?.select(this.model.module.value);
  }
}
