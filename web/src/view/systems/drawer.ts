// Details of the last click: the weights of a neuron, the component plane of a touch sensor, or the
// graph of the system's modules. The drawer lies over the strips, as high as its content needs, and
// scrolls if that is more than the page.

import { element, fill } from "../../parts/dom";
import type { State } from "../data";
import type { Model, Question } from "../session/model";
import { ModuleGraph } from "./module_graph";
import { neuronAnswer } from "./neuron_answer";
import { taxelAnswer, taxelChoice } from "../scene/taxel_answer";

export class Drawer {
  readonly root: HTMLElement;
  private readonly place = element("div", { class: "closer", "aria-live": "polite" });
  private readonly graph: ModuleGraph;
  private readonly close = element("button", { type: "button", class: "drawer-close" }, ["Close"]);
  private opener: Element | null = null;

  constructor(private readonly model: Model) {
    this.graph = new ModuleGraph(model);
    const tools = element("div", { class: "drawer-tools" }, [taxelChoice(model), this.close]);
    const label = { class: "drawer", "aria-label": "Details", hidden: true };
    this.root = element("section", label, [tools, this.place, this.graph.root]);
    this.close.addEventListener("click", () => this.hide());
    this.root.addEventListener("keydown", (event) => {
      if (event.key === "Escape") this.hide();
    });
    model.question.watch((question) => this.show(question));
    this.showGraph(false);
  }

  /** The graph of the modules. */
  openGraph(): void {
    this.opener = document.activeElement;
    this.model.question.set(null);
    this.showGraph(true);
    this.root.hidden = false;
    this.graph.reveal();
    this.close.focus();
  }

  private showGraph(shown: boolean): void {
    this.graph.root.hidden = !shown;
    this.place.hidden = shown;
    this.root.classList.toggle("wide", shown);
  }

  private hide(): void {
    this.root.hidden = true;
    this.model.question.set(null);
    if (this.opener instanceof HTMLElement) this.opener.focus();
    this.opener = null;
  }

  private show(question: Question | null): void {
    const state = this.model.shownState.value;
    if (question === null || state === null) {
      if (this.graph.root.hidden) this.root.hidden = true;
      return;
    }
    this.showGraph(false);
    fill(this.place, answerOf(question, state, this.model));
    this.root.hidden = false;
    this.root.scrollTop = 0;
  }
}

function answerOf(question: Question, state: State, model: Model): HTMLElement[] {
  if (question.answer === null) return [element("p", { class: "empty" }, ["Waiting for the answer …"])];
  if (question.about === "neuron") return neuronAnswer(question.answer, state, model);
  return taxelAnswer(question.answer, state, model);
}
