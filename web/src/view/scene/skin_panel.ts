// The skin: the touch sensors on an outline of the hand, grey at rest and bright where it is
// touched. Bodies without touch sensors show the present values of their other senses.

import { element, fill } from "../../parts/dom";
import { handMap, type HandPicture } from "../../parts/hands/hand_map";
import type { ChannelData } from "../../parts/data";
import { isTouched, touchColour } from "../../parts/hands/touch_colours";
import type { Frame, State } from "../data";
import type { Model } from "../session/model";
import { Panel } from "../page/panel";
import { Senses } from "./senses";

export class SkinPanel {
  readonly panel = new Panel(2, "skin", "Skin");
  private readonly place = element("div", { class: "skin-place" });
  private readonly senses = new Senses();
  private readonly hold = element("input", { type: "checkbox" });
  private readonly holding: HTMLElement;
  private picture: HandPicture | null = null;
  private cells: readonly Element[] = [];
  private built = "";

  constructor(private readonly model: Model) {
    this.hold.addEventListener("change", () => (model.scale.held = this.hold.checked));
    this.holding = element(
      "label",
      { class: "hold", title: "Otherwise the colours follow the strongest touch of the exploration" },
      [this.hold, "hold scale"],
    );
    this.panel.addTools(this.holding);
    this.panel.add(this.place, this.senses.root);
    model.shownState.watch((state) => state && this.take(state));
    model.frame.watch((frame) => this.draw(frame));
    model.question.watch((question) =>
      this.picture?.select(question?.about === "taxel" ? question.element : null),
    );
    this.panel.whenOpen(() => this.draw(model.frame.value));
  }

  private take(state: State): void {
    const text = JSON.stringify(state.channels);
    if (text === this.built) return;
    this.built = text;
    const touch = state.channels.find(({ name }) => name === "touch");
    this.picture = touch === undefined ? null : this.make(touch);
    this.cells = [...(this.picture?.svg.querySelectorAll("[data-cell]") ?? [])];
    fill(this.place, [this.picture?.element ?? null]);
    this.place.hidden = this.holding.hidden = touch === undefined;
    this.panel.rename(touch === undefined ? "Senses" : "Skin");
    this.senses.build(touch === undefined ? state.channels : []);
    this.draw(this.model.frame.value);
  }

  private make(channel: ChannelData): HandPicture {
    const onChoose = (taxel: number) => void this.model.askTaxel(taxel);
    const look = { colour: touchColour, unit: channel.unit, size: 300, palm: true };
    const picture = handMap(channel, { label: "Touch sensors", onChoose, ...look });
    picture.element.querySelector("output")?.setAttribute("aria-live", "off"); // changes with every frame
    return picture;
  }

  private draw(frame: Frame | null): void {
    if (frame === null || !this.panel.isOpen.value) return;
    const { scale } = this.model;
    const touch = frame.channels["touch"] ?? [];
    this.picture?.setValues(touch, [0, scale.end]);
    this.place.dataset["end"] = String(scale.end);
    this.cells.forEach((cell, i) => cell.classList.toggle("lit", isTouched(scale.share(touch[i] ?? 0))));
    this.senses.show(frame);
  }
}
