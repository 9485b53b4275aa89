// Asks for the name of what was explored and not recognized, so that the system learns it. The
// question never takes the focus; playing pauses while a name is typed.

import { element } from "../../parts/dom";
import type { Frame, State } from "../data";
import { KnownNames, labelOf } from "./known_names";
import type { Model } from "../session/model";
import { Speaker } from "../page/speaker";
import { taughtFrom } from "./taught";
import { isUnknown } from "./verdict";

export class NamingQuestion {
  readonly root: HTMLElement;
  private readonly known = new KnownNames();
  private readonly input = element("input", {
    type: "text",
    required: true,
    maxlength: 80,
    autocomplete: "off",
    list: this.known.root.id,
  });
  private readonly teach = element("button", { type: "submit", class: "primary" }, ["Teach"]);
  private readonly form: HTMLFormElement;
  private readonly speaker = new Speaker("question-spoken");
  private readonly closed = new Set<number>(); // explorations
  private subject: number | null = null; // the exploration
  private hasPaused = false;

  /** `leave` moves the focus when the question is closed while it has the focus. */
  constructor(
    private readonly model: Model,
    private readonly leave: () => void,
  ) {
    const later = element("button", { type: "button", class: "quiet", onclick: () => this.close() }, ["Not now"]);
    const label = element("label", {}, [element("span", {}, ["What is it?"]), this.input]);
    const form = { class: "naming-question", "aria-label": "Name for the system to learn", hidden: true };
    this.form = element("form", form, [label, this.teach, later, this.known.root]);
    this.root = element("div", { class: "naming-place" }, [this.form, this.speaker.root]);
    this.form.addEventListener("submit", (event) => void this.submit(event));
    this.form.addEventListener("keydown", (event) => event.key === "Escape" && this.close());
    this.input.addEventListener("input", () => this.pause());
  }

  show(frame: Frame | null, state: State | null): void {
    const subject = frame !== null && state !== null && this.asks(frame, state) ? frame.exploration : null;
    if (subject === this.subject) return;
    this.subject = subject;
    this.form.hidden = subject === null;
    this.hasPaused = false;
    if (subject === null || state === null) return;
    this.input.value = "";
    this.known.show(state);
    this.speaker.say(String(subject), "What is it? Give its name in the panel Name, and the system learns it.");
  }

  private asks({ last, reading, exploration }: Frame, state: State): boolean {
    if (!last || reading === null || !isUnknown(reading) || !state.teaches) return false;
    return !this.closed.has(exploration) && taughtFrom(state, exploration) === null;
  }

  private async submit(event: Event): Promise<void> {
    event.preventDefault();
    const state = this.model.shownState.value;
    const value = this.input.value.trim();
    const id = state === null ? null : idOf(state, this.subject);
    if (state === null || id === null || value === "") return;
    const finish = this.finisher(); // the state in which it is taught may arrive before the answer
    this.teach.disabled = true;
    const answer = await this.model.send({ command: "name", label: labelOf(state), value, id });
    this.teach.disabled = false;
    if (answer !== "refused") finish();
  }

  private close(): void {
    this.finisher()();
  }

  /** Closes the question as it is now; it is not shown again for this exploration. */
  private finisher(): () => void {
    const { subject, hasPaused } = this;
    const hasFocus = this.form.contains(document.activeElement);
    return () => {
      if (subject !== null) this.closed.add(subject);
      if (subject === this.subject) this.show(null, null);
      if (hasFocus) this.leave();
      if (hasPaused) void this.model.send({ command: "play" });
    };
  }

  /** Only what is played: a question neither holds a body that explores nor lets it move on. */
  private pause(): void {
    const state = this.model.shownState.value;
    if (this.hasPaused || state?.playing !== true || state.live) return;
    this.hasPaused = true;
    void this.model.send({ command: "pause" });
  }
}

/** The identifier of an exploration that is kept; the next one may have begun. */
function idOf(state: State, exploration: number | null): number | null {
  return state.explorations.find(({ index }) => index === exploration)?.id ?? null;
}
