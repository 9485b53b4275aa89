// The name that the system gives, the truth, and how near each class is. The list of classes is the
// legend of the map beside it.

import { element, fill, write } from "../../parts/dom";
import { digits } from "../../parts/numbers";
import { Candidates } from "../systems/candidates";
import type { Frame, Reading, State } from "../data";
import { Meter } from "../systems/meter";
import type { Model } from "../session/model";
import type { NameKeys } from "./name_keys";
import { NamingQuestion } from "./naming_question";
import { Panel } from "../page/panel";
import { Speaker } from "../page/speaker";
import { originWords, taughtFrom, taughtWords } from "./taught";
import { isUnknown, verdictOf } from "./verdict";

export class NamePanel {
  readonly panel = new Panel(5, "name", "Name");
  private readonly heading = element("p", { class: "reading-question" });
  private readonly answer = element("p", { class: "reading-answer", tabindex: -1 });
  private readonly similar = element("p", { class: "reading-similar" });
  private readonly verdict = element("p", { class: "verdict" });
  private readonly taught = element("p", { class: "taught" });
  private readonly origin = element("p", { class: "taught" });
  private readonly confidence = new Meter("Confidence", 1);
  private readonly novelty = new Meter("Novelty", 2, { at: 1, note: "above 1: unknown" });
  private readonly candidates: Candidates;
  private readonly question: NamingQuestion;
  private readonly shown = element("div", { class: "reading" });
  private readonly nothing = element("p", { class: "empty" });
  private readonly speaker = new Speaker("reading-spoken");

  constructor(
    private readonly model: Model,
    keys: NameKeys,
  ) {
    this.candidates = new Candidates(model);
    this.question = new NamingQuestion(model, () => this.answer.focus());
    fill(this.shown, [
      this.heading,
      this.answer,
      this.similar,
      this.verdict,
      this.question.root,
      this.taught,
      this.origin,
      this.confidence.root,
      this.novelty.root,
    ]);
    this.panel.add(keys.root, this.shown, this.nothing, this.candidates.root, this.speaker.root);
    model.shownState.watch((state) => state && this.showState(state));
    model.map.watch(() => this.candidates.build());
    model.frame.watch((frame) => this.panel.isOpen.value && this.draw(frame));
    this.panel.whenOpen(() => this.draw(model.frame.value));
  }

  private showState(state: State): void {
    this.heading.textContent =
      state.label === null ? "Best guess so far" : `Best guess so far (${state.label})`;
    this.candidates.build();
    this.draw(this.model.frame.value);
  }

  private draw(frame: Frame | null): void {
    const state = this.model.shownState.value;
    const reading = frame?.reading ?? null;
    this.shown.hidden = reading === null;
    this.nothing.hidden = reading !== null;
    this.candidates.show(reading);
    this.question.show(frame, state);
    if (reading === null) write(this.nothing, whyNothing(state));
    else this.show(reading);
    if (state !== null && frame !== null && reading !== null) this.judge(reading, frame, state);
  }

  private show(reading: Reading): void {
    const unknown = isUnknown(reading);
    const similar = `Most similar: ${reading.candidates[0]?.name ?? "none"}`;
    write(this.answer, reading.answer);
    this.answer.classList.toggle("unknown", unknown);
    write(this.similar, similar);
    this.similar.hidden = !unknown;
    this.confidence.show(unknown ? null : reading.confidence); // it compares the classes only
    this.novelty.show(reading.novelty);
    const more = unknown ? similar : `confidence ${digits(reading.confidence)}`;
    this.speaker.say(reading.answer, `${reading.answer}, ${more}`);
  }

  private judge(reading: Reading, frame: Frame, state: State): void {
    const verdict = verdictOf(reading, state, frame.exploration);
    const taught = taughtFrom(state, frame.exploration);
    writeOrHide(this.verdict, verdict?.words ?? null);
    this.verdict.classList.toggle("right", verdict?.isRight ?? false);
    writeOrHide(this.taught, taught && taughtWords(taught, state));
    this.taught.classList.toggle("failed", taught?.problem !== null);
    writeOrHide(this.origin, originWords(frame, state));
  }
}

function writeOrHide(line: HTMLElement, words: string | null): void {
  line.hidden = words === null;
  write(line, words ?? "");
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
