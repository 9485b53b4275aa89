// The weights of the neuron, or the component plane of the touch sensor, that was clicked last.

import { element, fill } from "../parts/dom";
import type { State } from "./data";
import type { Model, Question } from "./model";
import { neuronAnswer } from "./neuron_answer";
import { Panel } from "./panel";
import { taxelAnswer, taxelChoice } from "./taxel_answer";

export class CloserPanel {
  readonly panel = new Panel(4, "closer", "Details");
  private readonly place = element("div", { class: "closer", "aria-live": "polite" });
  private readonly choice: HTMLElement;

  constructor(private readonly model: Model) {
    this.choice = taxelChoice(model);
    this.panel.addTools(this.choice);
    this.panel.add(this.place);
    model.question.watch((question) => this.show(question));
  }

  private show(question: Question | null): void {
    const state = this.model.shownState.value;
    fill(
      this.place,
      question === null || state === null ? [this.hint()] : answerOf(question, state, this.model),
    );
  }

  private hint(): HTMLElement {
    return element("p", { class: "empty" }, [
      "Click a neuron of the map to see its weights, or a touch sensor of the hand to see its weight in each neuron.",
    ]);
  }
}

function answerOf(question: Question, state: State, model: Model): HTMLElement[] {
  if (question.answer === null) return [element("p", { class: "empty" }, ["Asking …"])];
  if (question.about === "neuron") return neuronAnswer(question.answer, state, model);
  return taxelAnswer(question.answer, state, model);
}
