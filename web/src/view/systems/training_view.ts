// The training of a map: its progress, its U-matrix, and the winners of the samples. Earlier moments
// are kept, so that one can go back through the training.

import { element, fill } from "../../parts/dom";
import { classLegend } from "../../parts/maps/legend";
import { type ValuesPicture, valuesPicture } from "../../parts/maps/map_picture";
import { digits, fixed } from "../../parts/numbers";
import type { State, Training } from "../data";
import { mostOften } from "./most_often";
import type { Model } from "../session/model";
import { TrainingPast } from "./training_past";

export class TrainingView {
  readonly root = element("div", { class: "training" });
  readonly button = element("button", { type: "button", class: "learn-button" }, ["Train"]);
  private readonly progress = element("progress", { max: 1, value: 0, "aria-label": "Training" });
  private readonly scrub = element("input", {
    type: "range",
    min: 0,
    max: 0,
    step: 1,
    class: "training-scrub",
    "aria-label": "Moment of the training",
  });
  private readonly words = element("p", { class: "training-words" });
  private readonly place = element("div", { class: "map-place" });
  private readonly legend = element("div", { class: "map-legend" });
  private readonly past = new TrainingPast();
  private picture: ValuesPicture | null = null;
  private names: string[] = [];
  private built = "";

  constructor(private readonly model: Model) {
    fill(this.root, [this.progress, this.scrub, this.words, this.place, this.legend]);
    this.button.addEventListener("click", () => this.press());
    this.scrub.addEventListener("input", () => this.goTo(Number(this.scrub.value)));
    model.shownState.watch((state) => this.showButton(state));
    model.training.watch((training) => this.take(training));
  }

  private press(): void {
    const running = this.model.shownState.value?.training ?? false;
    void this.model.send({ command: running ? "stop_training" : "train" });
  }

  private showButton(state: State | null): void {
    const running = state?.training ?? false;
    this.button.textContent = running ? "Stop training" : "Train";
    const system = state?.systems.find(({ name }) => name === state.system);
    this.button.disabled = system?.learns !== true;
    this.button.title = system?.learns === false ? "Loaded already trained (--model)" : "";
  }

  private take(training: Training | null): void {
    this.past.take(training);
    this.progress.hidden = training === null || training.done;
    this.scrub.max = String(Math.max(0, this.past.count - 1));
    this.scrub.hidden = this.past.count < 2;
    if (this.past.isFollowing) this.scrub.value = this.scrub.max;
    if (training !== null) {
      this.progress.max = Math.max(1, training.steps);
      this.progress.value = training.step;
    }
    this.draw(this.past.shown);
  }

  private goTo(look: number): void {
    this.past.goTo(look);
    this.draw(this.past.shown);
  }

  private draw(training: Training | null): void {
    this.words.textContent =
      training === null ? "No map has been trained yet: press Train." : wordsOf(training);
    this.scrub.setAttribute("aria-valuetext", this.words.textContent);
    if (training === null) return this.clear();
    this.build(training);
    this.picture?.setValues(training.u_matrix);
    this.mark(training);
  }

  private clear(): void {
    this.built = "";
    this.picture = null;
    fill(this.place, []);
    fill(this.legend, []);
  }

  private build(training: Training): void {
    const grid = this.model.shownState.value?.maps.find(({ module }) => module === training.module)?.grid;
    const text = JSON.stringify([training.system, training.module, grid]);
    if (grid === undefined || text === this.built) return;
    this.built = text;
    this.names = [];
    const label = `U-matrix of ${training.module} during the training`;
    this.picture = valuesPicture(grid, { label, legend: false });
    fill(this.place, [this.picture.element]);
  }

  private mark(training: Training): void {
    const names = [...new Set([...this.classes(training), ...training.winners.map((won) => won.class)])];
    if (names.join("\n") !== this.names.join("\n")) fill(this.legend, [classLegend(names)]);
    this.names = names;
    const neurons = training.u_matrix.length;
    this.picture?.setMarks(mostOften(training.winners, names, neurons), names);
  }

  private classes(training: Training): string[] {
    return this.model.shownState.value?.maps.find(({ module }) => module === training.module)?.classes ?? [];
  }
}

function wordsOf({ module, step, steps, radius, learning_rate, u_matrix, done }: Training): string {
  const head = `${module || "The system"}${done ? ", trained" : ""}: step ${step} of ${steps}`;
  if (u_matrix.length === 0) return head; // what comes before the map
  return `${head}, radius ${digits(radius)}, learning rate ${fixed(learning_rate, 3)}`;
}
