// The body in three dimensions, where what it touches lights up; without one, the readings.

import { element } from "../../parts/dom";
import { digits, withUnit } from "../../parts/numbers";
import type { Frame, State } from "../data";
import { Exploring } from "../page/exploring";
import type { Model } from "../session/model";
import { Panel } from "../page/panel";
import { contributionsSwitch } from "./contributions";
import { holdScale, Readings, readingsAt } from "./readings";
import { makeRenderer, SceneView } from "./scene_view";
import { themeColour } from "../page/theme_colours";

const kLabel =
  "The body in three dimensions. Arrow keys rotate the view, with Shift they move it, plus and minus zoom, 0 resets it.";
const kNoWebGl = "This browser does not support WebGL, so the body is not drawn; its readings are shown beside.";

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
  private readonly tools: HTMLButtonElement[];
  private readonly readings: Readings;
  private readonly holding: HTMLElement;
  private readonly explaining: HTMLElement;
  private pointed: number | null = null;

  constructor(private readonly model: Model) {
    const renderer = makeRenderer();
    this.view =
      renderer &&
      new SceneView(this.place, renderer, model.budget, {
        pointed: (taxel) => this.point(taxel),
        picked: (taxel) => void model.askTaxel(taxel),
      });
    this.tools = this.makeTools();
    this.readings = new Readings(model);
    this.holding = holdScale(model);
    this.explaining = contributionsSwitch(model);
    this.panel.addTools(...this.tools, this.explaining, this.holding);
    const stage = element("div", { class: "stage" }, [this.note, this.place, this.readings.root, this.readout]);
    this.panel.add(stage, new Exploring(model).root);
    this.watch();
  }

  private makeTools(): HTMLButtonElement[] {
    const tool = (words: string, title: string, press: (button: HTMLButtonElement) => void) => {
      const button = element("button", { type: "button", class: "quiet", title }, [words]);
      button.addEventListener("click", () => press(button));
      return button;
    };
    const transparent = tool("See through", "Show the hand transparent", (button) => {
      const on = button.getAttribute("aria-pressed") !== "true";
      button.setAttribute("aria-pressed", String(on));
      this.view?.seeThrough(on);
    });
    transparent.setAttribute("aria-pressed", "false");
    return [
      transparent,
      tool("Pads", "Look from where most touch sensors are seen", () => this.view?.aim()),
      tool("Front", "Reset the view (0 in the picture)", () => this.view?.orbit.reset()),
    ];
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

  private get isSolid(): boolean {
    return this.view !== null && this.model.shownScene.value !== null;
  }

  private arrange(): void {
    const [transparent, pads, front] = this.tools;
    const hasTouch = this.isSolid && hasPads(this.model);
    transparent!.hidden = pads!.hidden = !hasTouch;
    front!.hidden = !this.isSolid;
    this.place.hidden = !this.isSolid;
    this.arrangeReadings();
    this.note.textContent = this.words();
    this.note.hidden = this.note.textContent === "";
  }

  private arrangeReadings(): void {
    const channels = this.model.shownState.value?.channels ?? [];
    const shown = readingsAt("stage", channels, this.model.hasBody);
    this.readings.take(shown);
    this.holding.hidden = this.explaining.hidden = shown.skins.length === 0;
    const isShown = shown.skins.length + shown.senses.length > 0;
    this.panel.rename(shown.skins.length > 0 ? "Skin" : isShown ? "Senses" : "Body");
  }

  private words(): string {
    const state = this.model.shownState.value;
    if (state === null || !this.model.sceneKnown.value) return "Waiting for the body …";
    if (state.explorations.length === 0 && !state.live && this.model.frame.value === null)
      return nothingYet(state);
    if (this.model.shownScene.value === null)
      return this.readings.root.hidden ? "No body is known, and nothing has been read yet." : "";
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
    if (this.isSolid) this.view?.draw(frame, (element) => scale.share(touch[element]));
    if (this.pointed !== null) this.describe();
    this.readings.show(frame);
  }
}

function hasPads(model: Model): boolean {
  return model.shownScene.value?.geoms.some(({ taxel }) => taxel !== null) ?? false;
}

function nothingYet(state: State): string {
  if (state.source === "recording") return "This recording has no explorations.";
  if (state.awaits_start) return "This body is real: it moves when you press Start below. Keep your hands away from it.";
  return "There is no exploration yet: select an object below and press Explore.";
}

function surroundings(): { table: string; line: string } {
  return { table: themeColour("raised"), line: themeColour("line-strong") };
}
