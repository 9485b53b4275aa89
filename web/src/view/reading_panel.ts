// The current reading of the system, and the distance to all other classes.

import { element, fill } from "../parts/dom";
import { digits } from "../parts/numbers";
import type { Frame, Reading, State } from "./data";
import { Candidates } from "./candidates";
import type { Model } from "./model";
import { Panel } from "./panel";
import { Speaker } from "./speaker";

export class ReadingPanel {
  readonly panel = new Panel(3, "reading", "Reading");
  private readonly question = element("p", { class: "reading-question" });
  private readonly answer = element("p", { class: "reading-answer" });
  private readonly confidence = element("span", { class: "number" });
  private readonly bar = element("span", { class: "bar-fill" });
  private readonly meter = element(
    "div",
    {
      role: "meter",
      "aria-label": "Confidence",
      "aria-valuemin": 0,
      "aria-valuemax": 1,
      class: "bar confidence-bar",
    },
    [this.bar],
  );
  private readonly candidates: Candidates;
  private readonly shown = element("div", { class: "reading" });
  private readonly nothing = element("p", { class: "empty" });
  private readonly speaker = new Speaker("reading-spoken");

  constructor(private readonly model: Model) {
    this.candidates = new Candidates(model);
    const confidence = element("div", { class: "confidence" }, [
      element("span", { class: "name" }, ["Confidence"]),
      this.meter,
      this.confidence,
    ]);
    fill(this.shown, [this.question, this.answer, confidence, this.candidates.root]);
    this.panel.add(this.shown, this.nothing, this.speaker.root);
    model.shownState.watch((state) => state && this.showQuestion(state));
    model.frame.watch((frame) => this.panel.isOpen.value && this.draw(frame));
    this.panel.whenOpen(() => this.draw(model.frame.value));
  }

  private showQuestion(state: State): void {
    this.question.textContent =
      state.label === null ? "Best guess so far" : `Best guess so far (${state.label})`;
    this.draw(this.model.frame.value);
  }

  private draw(frame: Frame | null): void {
    const reading = frame?.reading ?? null;
    this.shown.hidden = reading === null;
    this.nothing.hidden = reading !== null;
    if (reading === null) this.nothing.textContent = whyNothing(this.model.shownState.value);
    else this.show(reading);
  }

  private show(reading: Reading): void {
    const confidence = Math.min(1, Math.max(0, reading.confidence ?? 0));
    this.answer.textContent = reading.answer;
    this.confidence.textContent = digits(reading.confidence);
    this.meter.setAttribute("aria-valuenow", confidence.toFixed(2));
    this.bar.style.width = `${confidence * 100}%`;
    this.candidates.show(reading);
    this.speaker.say(reading.answer, `${reading.answer}, confidence ${digits(reading.confidence)}`);
  }
}

function whyNothing(state: State | null): string {
  if (state === null) return "Waiting for the program.";
  if (state.system_problem !== null) return state.system_problem;
  if (state.systems.length === 0)
    return "No system is available: training here requires labelled explorations of at least two classes; --model adds a trained system.";
  if (state.system === null)
    return "No system is selected. Select one above to see its reading.";
  return state.playing
    ? "Not enough data for a reading yet."
    : "No reading yet: play, or step to a frame.";
}
