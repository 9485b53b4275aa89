// The name that the system gives, the truth, and how near each class is. The list of classes is the
// legend of the map beside it.

import { element, fill, write } from "../parts/dom";
import { digits } from "../parts/numbers";
import { Candidates } from "./candidates";
import type { Frame, Reading, State } from "./data";
import type { Model } from "./model";
import { Panel } from "./panel";
import { Speaker } from "./speaker";
import { truthOf } from "./truth";

export class NamePanel {
  readonly panel = new Panel(5, "name", "Name");
  private readonly question = element("p", { class: "reading-question" });
  private readonly answer = element("p", { class: "reading-answer" });
  private readonly verdict = element("p", { class: "verdict" });
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
    fill(this.shown, [this.question, this.answer, this.verdict, confidence]);
    this.panel.add(this.shown, this.nothing, this.candidates.root, this.speaker.root);
    model.shownState.watch((state) => state && this.showQuestion(state));
    model.map.watch(() => this.candidates.build());
    model.frame.watch((frame) => this.panel.isOpen.value && this.draw(frame));
    this.panel.whenOpen(() => this.draw(model.frame.value));
  }

  private showQuestion(state: State): void {
    this.question.textContent =
      state.label === null ? "Best guess so far" : `Best guess so far (${state.label})`;
    this.candidates.build();
    this.draw(this.model.frame.value);
  }

  private draw(frame: Frame | null): void {
    const reading = frame?.reading ?? null;
    this.shown.hidden = reading === null;
    this.nothing.hidden = reading !== null;
    this.candidates.show(reading);
    if (reading === null) write(this.nothing, whyNothing(this.model.shownState.value));
    else this.show(reading, frame!.exploration);
  }

  private show(reading: Reading, exploration: number): void {
    const confidence = Math.min(1, Math.max(0, reading.confidence ?? 0));
    write(this.answer, reading.answer);
    write(this.confidence, digits(reading.confidence));
    this.meter.setAttribute("aria-valuenow", confidence.toFixed(2));
    this.bar.style.width = `${confidence * 100}%`;
    this.judge(reading.answer, exploration);
    this.speaker.say(reading.answer, `${reading.answer}, confidence ${digits(reading.confidence)}`);
  }

  private judge(answer: string, exploration: number): void {
    const state = this.model.shownState.value;
    const truth = state === null ? null : truthOf(state, exploration);
    const isRight = truth === answer;
    this.verdict.hidden = truth === null;
    this.verdict.classList.toggle("right", isRight);
    write(this.verdict, isRight ? "✓ Right" : `✗ Wrong: it is ${truth ?? ""}`);
  }
}

function whyNothing(state: State | null): string {
  if (state === null) return "Waiting for the program.";
  if (state.system_problem !== null)
    return state.training ? "The system is being trained. The name appears afterwards." : state.system_problem;
  if (state.systems.length === 0)
    return "No system is available. Record at least two labelled objects to train one here, or start with --model FILE.";
  if (state.system === null) return "No system is selected. Select one above to see its reading.";
  return state.playing ? "Not enough data for a name yet." : "No name yet: play, or step to a frame.";
}
