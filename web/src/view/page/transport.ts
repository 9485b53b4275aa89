// Play, pause, step, speed, scrub, and the choice of the exploration.

import { element, fill } from "../../parts/dom";
import { seconds } from "../../parts/numbers";
import type { Frame, State } from "../data";
import { icon } from "./icons";
import { describe } from "./labels";
import type { Model } from "../session/model";
import { Seeker } from "./seeker";

export const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 4, 8, 16];

export class Transport {
  readonly root: HTMLElement;
  private readonly play = iconButton("play", "Play", "Play or pause (space)");
  private readonly speed = element("select", { "aria-label": "Speed", title: "Speed (up, down)" });
  private readonly scrub = element("input", {
    type: "range",
    min: 0,
    max: 0,
    step: 1,
    "aria-label": "Frame",
  });
  private readonly time = element("output", { class: "time", "aria-label": "Time" }, ["–"]);
  private readonly choice = element("select", { "aria-label": "Exploration", class: "exploration" });
  private readonly seeker: Seeker;
  private readonly before = this.moveButton(-1);
  private readonly after = this.moveButton(1);
  private listed = "";
  private farthest = 0; // frame that was seen of what a body still explores

  constructor(private readonly model: Model) {
    this.seeker = new Seeker(model);
    this.root = element("footer", { class: "transport", role: "group", "aria-label": "Playing" }, [
      element("div", { class: "transport-buttons" }, [this.stepButton(-1), this.play, this.stepButton(1)]),
      this.scrub,
      this.time,
      labelled("Speed", this.speed),
      element("div", { class: "transport-exploration" }, [this.before, this.choice, this.after]),
    ]);
    this.watchControls();
    model.shownState.watch((state) => state && this.showState(state));
    model.frame.watch((frame) => frame && this.showFrame(frame));
  }

  togglePlaying(): void {
    const playing = this.model.shownState.value?.playing ?? false;
    void this.model.send({ command: playing ? "pause" : "play" });
  }

  step(frames: number): void {
    void this.model.send({ command: "step", frames });
  }

  /** To the first (0) or last (1) frame. */
  end(share: 0 | 1): void {
    this.seek(share * Number(this.scrub.max));
  }

  faster(steps: number): void {
    const now = this.model.shownState.value?.speed ?? 1;
    const nearest = kSpeeds.reduce(
      (best, speed, i) =>
        Math.abs(Math.log(speed / now)) < Math.abs(Math.log((kSpeeds[best] ?? 1) / now)) ? i : best,
      0,
    );
    const speed = kSpeeds[Math.min(kSpeeds.length - 1, Math.max(0, nearest + steps))] ?? 1;
    void this.model.send({ command: "speed", speed });
  }

  move(explorations: number): void {
    const state = this.model.shownState.value;
    if (state === null) return;
    const next = state.explorations[placeOf(state) + explorations];
    if (next !== undefined) this.seek(0, next.index);
  }

  private seek(frame: number, exploration = this.exploration()): void {
    if (exploration !== null) this.seeker.seek(exploration, frame);
  }

  /** The selected exploration: its first frame may arrive before the state. */
  private exploration(): number | null {
    if (this.choice.value !== "") return Number(this.choice.value);
    const state = this.model.shownState.value;
    return state?.live ? state.exploration : null;
  }

  private watchControls(): void {
    this.play.addEventListener("click", () => this.togglePlaying());
    this.scrub.addEventListener("input", () => this.seek(Number(this.scrub.value)));
    this.choice.addEventListener(
      "change",
      () => this.choice.value !== "" && this.seek(0, Number(this.choice.value)),
    );
    this.speed.addEventListener(
      "change",
      () => void this.model.send({ command: "speed", speed: Number(this.speed.value) }),
    );
  }

  private showState(state: State): void {
    fill(this.play, [icon(state.playing ? "pause" : "play")]);
    this.play.setAttribute("aria-label", state.playing ? "Pause" : "Play");
    showSpeed(this.speed, state.speed);
    this.showExplorations(state);
    if (!state.live) this.farthest = 0;
    this.showLength(state.frames);
  }

  private showExplorations(state: State): void {
    const text = JSON.stringify([state.explorations, state.live, state.label]);
    const now = state.live ? [element("option", { value: "" }, ["exploring now"])] : [];
    if (text !== this.listed) fill(this.choice, [...optionsOf(state), ...now]);
    this.listed = text;
    this.choice.disabled = state.explorations.length === 0;
    this.choose(state.exploration);
    const place = placeOf(state);
    this.before.disabled = place <= 0;
    this.after.disabled = place + 1 >= state.explorations.length;
  }

  /** The current exploration of a body is not in the list yet. */
  private choose(exploration: number | null): void {
    this.choice.value = String(exploration ?? "");
    if (this.choice.selectedIndex < 0) this.choice.value = "";
  }

  private showFrame(frame: Frame): void {
    this.showLength(frame.frames);
    if (!this.seeker.busy) this.scrub.value = String(frame.frame);
    this.choose(frame.exploration);
    const duration = this.model.shownState.value?.duration ?? null;
    const of = duration === null ? "" : ` / ${seconds(duration)}`;
    this.time.textContent = `${seconds(frame.time)}${of}`;
    const last = frame.frames === null ? "" : ` of ${frame.frames}`;
    this.scrub.setAttribute("aria-valuetext", `frame ${frame.frame + 1}${last}, ${seconds(frame.time)}`);
  }

  private showLength(frames: number | null): void {
    if (frames === null) this.farthest = Math.max(this.farthest, this.model.frame.value?.frame ?? 0);
    const last = frames === null ? this.farthest : frames - 1;
    this.scrub.min = String(this.model.shownState.value?.first_frame ?? 0);
    this.scrub.max = String(Math.max(0, last));
    this.scrub.disabled = last <= 0;
  }

  private stepButton(frames: -1 | 1): HTMLButtonElement {
    const [name, words] =
      frames < 0 ? (["back", "Step back"] as const) : (["forward", "Step forward"] as const);
    const button = iconButton(name, words, `${words} (${frames < 0 ? "left" : "right"})`);
    button.addEventListener("click", () => this.step(frames));
    return button;
  }

  private moveButton(by: -1 | 1): HTMLButtonElement {
    const [name, words] =
      by < 0 ? (["previous", "Previous exploration"] as const) : (["next", "Next exploration"] as const);
    const button = iconButton(name, words, `${words} (${by < 0 ? "[" : "]"})`);
    button.addEventListener("click", () => this.move(by));
    return button;
  }
}

/** The index of the current exploration; -1: none. */
function placeOf(state: State): number {
  return state.explorations.findIndex(({ index }) => index === state.exploration);
}

function iconButton(name: Parameters<typeof icon>[0], words: string, title: string): HTMLButtonElement {
  return element("button", { type: "button", class: "icon-button", "aria-label": words, title }, [
    icon(name),
  ]);
}

export function labelled(words: string, control: HTMLElement): HTMLElement {
  return element("label", { class: "labelled" }, [element("span", {}, [words]), control]);
}

/** Grouped by their recording, if there are several. */
function optionsOf(state: State): HTMLElement[] {
  const groups = new Map<string, HTMLElement[]>();
  for (const one of state.explorations) {
    const own = groups.get(one.recording ?? "") ?? [];
    groups.set(one.recording ?? "", [...own, option(one, state.label)]);
  }
  return [...groups].flatMap(([name, options]) =>
    name === "" ? options : [element("optgroup", { label: name }, options)],
  );
}

function option({ index, labels }: State["explorations"][number], label: string | null): HTMLOptionElement {
  return element("option", { value: index }, [`${index + 1}  ${describe(labels, label)}`]);
}

function showSpeed(select: HTMLSelectElement, speed: number): void {
  const speeds = [...new Set([...kSpeeds, speed])].sort((a, b) => a - b);
  if (select.options.length !== speeds.length || select.value !== String(speed))
    fill(
      select,
      speeds.map((value) => element("option", { value }, [`${value} ×`])),
    );
  select.value = String(speed);
}
