// The activity of a map, beside those that other senses call up, or its training.

import { sequenceColour } from "../../parts/maps/colour_maps";
import { element, fill, write } from "../../parts/dom";
import { choice, segments } from "../../parts/controls";
import { type ValuesPicture, valuesPicture } from "../../parts/maps/map_picture";
import type { Frame, State } from "../data";
import type { Model } from "../session/model";
import { Panel } from "../page/panel";
import { RecalledMaps } from "./recalled_maps";
import { answeringMap, taughtFrom } from "../naming/taught";
import { TrainingView } from "./training_view";

type MapState = State["maps"][number];

export class MapPanel {
  readonly panel = new Panel(4, "map", "Map");
  private readonly place = element("div", { class: "map-place" });
  private readonly nothing = element("p", { class: "empty" });
  private readonly recalled = new RecalledMaps((map, neuron) => void this.model.askNeuron(map, neuron));
  private readonly activity = element("div", { class: "map-activity" }, [
    element("div", { class: "map-places" }, [this.place, this.recalled.root]),
    this.nothing,
  ]);
  private readonly training: TrainingView;
  private readonly mode: HTMLElement;
  private readonly maps = choice("map", [], 0, (index) => this.choose(index));
  private picture: ValuesPicture | null = null;
  private map: MapState | null = null;
  private built = "";

  constructor(private readonly model: Model) {
    this.training = new TrainingView(model);
    this.mode = segments("show", ["activity", "training"], 0, (index) => this.show(index === 1));
    this.panel.addTools(this.maps.element, this.mode, this.training.button);
    this.panel.add(this.activity, this.training.root);
    this.show(false);
    model.shownState.watch((state) => state && this.take(state));
    model.map.watch(() => this.build());
    model.frame.watch((frame) => this.draw(frame));
    model.question.watch(() => this.markChosen());
    this.panel.whenOpen(() => this.draw(model.frame.value));
    this.followTraining();
  }

  /** A training is shown when its first picture arrives; that before a view has none. */
  private followTraining(): void {
    let before = false;
    this.model.training.watch((training) => {
      const now = training !== null && !training.done;
      if (now && !before) this.switchTo(1);
      before = now;
    });
  }

  private switchTo(index: 0 | 1): void {
    const option = this.mode.querySelectorAll("input")[index];
    if (option !== undefined) option.checked = true;
    this.show(index === 1);
  }

  private show(learning: boolean): void {
    this.activity.hidden = learning;
    this.training.root.hidden = !learning;
  }

  private choose(index: number): void {
    this.model.map.set(this.model.shownState.value?.maps[index]?.module ?? null);
  }

  private take(state: State): void {
    const names = state.maps.map(({ module }) => module);
    this.maps.setOptions(names, Math.max(0, names.indexOf(this.model.map.value ?? "")));
    this.maps.element.hidden = names.length < 2;
    this.build();
    this.markTaught(this.model.frame.value);
  }

  /** Rebuilt only for another map, so that the pointed cell is kept. */
  private build(): void {
    const state = this.model.shownState.value;
    this.map = state?.maps.find(({ module }) => module === this.model.map.value) ?? null;
    const text = JSON.stringify([this.map, state?.graph]);
    if (text === this.built) return;
    this.built = text;
    this.picture = this.map === null ? null : this.makePicture(this.map);
    fill(this.place, [this.picture?.element ?? null]);
    delete this.place.dataset["taught"];
    this.recalled.build(this.map, state?.graph ?? null);
    this.draw(this.model.frame.value);
  }

  private makePicture(map: MapState): ValuesPicture {
    const picture = valuesPicture(map.grid, {
      label: `Activity of the map ${map.module}`,
      colour: sequenceColour,
      unit: "activity",
      onChoose: (neuron) => void this.model.askNeuron(map.module, neuron),
    });
    picture.setMarks(map.neuron_classes, map.classes);
    picture.element.querySelector("output")?.setAttribute("aria-live", "off"); // changes with every frame
    return picture;
  }

  private draw(frame: Frame | null): void {
    const shown = this.map === null ? undefined : frame?.maps[this.map.module];
    this.nothing.hidden = this.map !== null && (shown !== undefined || this.map.classes.length > 0);
    write(this.nothing, whyNoMap(this.model.shownState.value));
    if (this.picture === null || !this.panel.isOpen.value) return;
    this.picture.setValues(shown?.activity ?? [], [0, 1]);
    this.picture.setWinner(shown?.winner ?? null);
    this.place.dataset["winner"] = String(shown?.winner ?? "");
    this.markTaught(frame);
    this.recalled.draw(frame);
  }

  /** The neuron that has learned the exploration. */
  private markTaught(frame: Frame | null): void {
    const state = this.model.shownState.value;
    const isAnswering = state !== null && answeringMap(state)?.module === this.map?.module;
    const neuron = isAnswering && frame !== null ? (taughtFrom(state, frame.exploration)?.neuron ?? null) : null;
    const marked = neuron === null ? [] : [neuron];
    if (String(marked) === this.place.dataset["taught"]) return;
    this.place.dataset["taught"] = String(marked);
    this.picture?.mark(marked);
  }

  private markChosen(): void {
    const question = this.model.question.value;
    const neuron = question?.about === "neuron" && question.map === this.map?.module ? question.neuron : null;
    this.picture?.select(neuron);
  }
}

function whyNoMap(state: State | null): string {
  if (state === null) return "Waiting for the program.";
  if (state.system === null) return "No system is selected.";
  if (state.graph !== null && state.maps.length === 0) return "None of its maps can be drawn.";
  return state.training ? "The system is being trained." : "Not trained yet: press Train.";
}
