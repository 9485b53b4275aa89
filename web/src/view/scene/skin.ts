// The elements of a channel at their places on the skin.

import type { ChannelData } from "../../parts/data";
import { element } from "../../parts/dom";
import { handMap, type HandPicture } from "../../parts/hands/hand_map";
import { isTouched, touchColour } from "../../parts/hands/touch_colours";
import type { Frame } from "../data";
import type { Model } from "../session/model";
import { ForceScale } from "./force_scale";

const kSize = 300;
const kMostPitch = 75; // so that the scale of a small pad is not drawn larger than the pad

export class Skin {
  readonly root: HTMLElement;
  private readonly picture: HandPicture;
  private readonly cells: readonly Element[];
  private readonly isTouch: boolean; // which the program answers questions about
  private readonly scale: ForceScale;

  constructor(
    private readonly channel: ChannelData,
    private readonly model: Model,
    isNamed: boolean,
  ) {
    this.isTouch = channel.name === "touch";
    this.scale = this.isTouch ? model.scale : new ForceScale();
    this.scale.unit = channel.unit;
    this.picture = this.makePicture();
    this.picture.element.querySelector("output")?.setAttribute("aria-live", "off"); // changes with every frame
    this.cells = [...this.picture.svg.querySelectorAll("[data-cell]")];
    const title = isNamed ? element("h3", {}, [channel.name]) : null;
    this.root = element("div", { class: "skin" }, [title, this.picture.element]);
  }

  private makePicture(): HandPicture {
    const label = this.isTouch ? "Touch sensors" : `Elements of ${this.channel.name}`;
    const look = { label, colour: touchColour, unit: this.channel.unit, size: kSize, mostPitch: kMostPitch, palm: true };
    const onChoose = (taxel: number) => void this.model.askTaxel(taxel);
    return handMap(this.channel, this.isTouch ? { ...look, onChoose } : look);
  }

  show(frame: Frame): void {
    const values = frame.channels[this.channel.name] ?? [];
    if (!this.isTouch) this.see(frame.exploration, values);
    this.picture.setValues(values, [0, this.scale.end]);
    this.cells.forEach((cell, i) => cell.classList.toggle("lit", isTouched(this.scale.share(values[i]) ?? 0)));
  }

  private see(exploration: number, values: Frame["channels"][string]): void {
    this.scale.held = this.model.scale.held;
    this.scale.see(exploration, values);
  }

  select(taxel: number | null): void {
    if (this.isTouch) this.picture.select(taxel);
  }
}
