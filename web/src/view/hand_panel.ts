// The body, usually a hand: in three dimensions, or unfolded; its taxels are coloured by their
// readings.

import { segments } from "../parts/controls";
import { element } from "../parts/dom";
import { digits, withUnit } from "../parts/numbers";
import type { Frame, State } from "./data";
import { Exploring } from "./exploring";
import { ForceLegend } from "./force_legend";
import type { Model } from "./model";
import { Panel } from "./panel";
import { makeRenderer, SceneView } from "./scene_view";
import { themeColour } from "./theme_colours";
import { UnfoldedHand } from "./unfolded_hand";

const kLabel =
  "The body in three dimensions. Arrow keys rotate the view, with Shift they move it, plus and minus zoom, 0 resets it.";
const kNoWebGl = "This browser does not support WebGL, so the hand is shown unfolded.";

export class HandPanel {
  readonly panel = new Panel(1, "hand", "Body");
  readonly view: SceneView | null;
  private readonly place = element("div", {
    class: "scene",
    tabindex: 0,
    role: "application",
    "aria-roledescription": "three-dimensional picture",
    "aria-label": kLabel,
  });
  private readonly note = element("p", { class: "scene-note" });
  private readonly readout = element("output", { class: "scene-readout", "aria-live": "off" });
  private readonly unfolded: UnfoldedHand;
  private readonly legend: ForceLegend;
  private readonly choice: HTMLElement;
  private readonly reset = element(
    "button",
    { type: "button", class: "quiet", title: "Reset the view (0 in the picture)" },
    ["Reset view"],
  );
  private wantsUnfolded = false;
  private pointed: number | null = null;

  constructor(private readonly model: Model) {
    const renderer = makeRenderer();
    this.unfolded = new UnfoldedHand(model);
    this.legend = new ForceLegend(model);
    this.view =
      renderer &&
      new SceneView(this.place, renderer, {
        pointed: (taxel) => this.point(taxel),
        picked: (taxel) => void model.askTaxel(taxel),
      });
    this.choice = segments("show", ["3D", "unfolded"], 0, (index) => this.unfold(index === 1));
    this.reset.addEventListener("click", () => this.view?.orbit.reset());
    this.panel.addTools(this.reset, this.choice);
    const stage = element("div", { class: "stage" }, [
      this.note,
      this.place,
      this.unfolded.root,
      this.readout,
      this.legend.root,
    ]);
    this.panel.add(stage, new Exploring(model).root);
    this.watch();
  }

  private watch(): void {
    const { model, view } = this;
    model.shownScene.watch((scene) => {
      view?.show(scene, surroundings());
      this.arrange();
      this.draw(model.frame.value);
    });
    model.sceneKnown.watch(() => this.arrange());
    model.shownState.watch(() => this.arrange());
    model.frame.watch((frame) => this.draw(frame));
    model.theme.watch(() => {
      view?.dress(surroundings());
      view?.colourRing(themeColour("accent"));
    });
    model.question.watch((question) => view?.choose(question?.about === "taxel" ? question.element : null));
    this.panel.whenOpen(() => this.draw(model.frame.value));
  }

  private unfold(unfolded: boolean): void {
    this.wantsUnfolded = unfolded;
    this.arrange();
    this.draw(this.model.frame.value);
  }

  private get isFlat(): boolean {
    const unfolded = this.wantsUnfolded && hasTouch(this.model.shownState.value);
    return unfolded || this.view === null || this.model.shownScene.value === null;
  }

  private arrange(): void {
    const solid = this.view !== null && this.model.shownScene.value !== null;
    this.choice.hidden = !solid || !hasTouch(this.model.shownState.value);
    this.reset.hidden = this.isFlat;
    this.place.hidden = this.isFlat;
    this.unfolded.root.hidden = !this.isFlat;
    this.legend.root.hidden = this.isFlat || !hasTouch(this.model.shownState.value);
    this.note.textContent = this.words();
    this.note.hidden = this.note.textContent === "";
  }

  private words(): string {
    const state = this.model.shownState.value;
    if (state === null || !this.model.sceneKnown.value) return "Waiting for the body …";
    if (state.explorations.length === 0 && !state.live && this.model.frame.value === null)
      return nothingYet(state);
    if (this.model.shownScene.value === null)
      return hasTouch(state)
        ? "The body of this recording is unknown; its touch sensors are shown unfolded."
        : "The body of this recording is unknown, and it has no channel named touch; its channels are shown in the strips.";
    return this.view === null ? kNoWebGl : "";
  }

  private point(taxel: number | null): void {
    this.pointed = taxel;
    this.place.classList.toggle("at-taxel", taxel !== null);
    this.describe();
  }

  private describe(): void {
    const channel = this.model.shownState.value?.channels.find(({ name }) => name === "touch");
    const value =
      this.pointed === null ? undefined : this.model.frame.value?.channels["touch"]?.[this.pointed];
    const name = this.pointed === null ? undefined : channel?.elements[this.pointed];
    this.readout.textContent =
      name === undefined || value === undefined
        ? ""
        : `${name}: ${withUnit(digits(value), channel?.unit ?? "")}`;
  }

  private draw(frame: Frame | null): void {
    if (frame === null || !this.panel.isOpen.value) return;
    if (!this.note.hidden) this.arrange();
    const touch = frame.channels["touch"] ?? [];
    const { scale } = this.model;
    if (this.isFlat) this.unfolded.draw(touch);
    else this.view?.draw(frame.poses, (element) => scale.share(touch[element] ?? 0));
    this.legend.draw();
    if (this.pointed !== null) this.describe();
  }
}

function hasTouch(state: State | null): boolean {
  return state?.channels.some(({ name }) => name === "touch") ?? false;
}

function nothingYet(state: State): string {
  if (state.source === "recording") return "This recording has no explorations.";
  return "There is no exploration yet: select an object below and press Explore again.";
}

function surroundings(): { table: string; line: string } {
  return { table: themeColour("raised"), line: themeColour("line-strong") };
}
