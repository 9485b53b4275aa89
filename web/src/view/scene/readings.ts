// The present readings: skins, grey at rest and bright where they are touched, and the other senses.
// With a body in three dimensions its skin is beside it; without, the readings take its place.

import type { ChannelData } from "../../parts/data";
import { element, fill } from "../../parts/dom";
import { isSkin } from "../../parts/hands/skin_layout";
import type { Frame } from "../data";
import type { Model } from "../session/model";
import { Contributions } from "./contributions";
import { Senses } from "./senses";
import { Skin } from "./skin";

export type Place = "stage" | "beside";

export interface Shown {
  skins: readonly ChannelData[];
  senses: readonly ChannelData[];
}

const kAngles = new Set(["deg", "rad"]);
const kNothing: Shown = { skins: [], senses: [] };

/** The readings that are shown in place of the body ("stage") and beside it. */
export function readingsAt(place: Place, channels: readonly ChannelData[], hasBody: boolean): Shown {
  const touch = channels.filter(({ name }) => name === "touch");
  if (hasBody && place === "stage") return kNothing;
  if (hasBody) return touch.length > 0 ? { skins: touch, senses: [] } : { skins: [], senses: channels };
  const skins = channels.filter(isFelt);
  const senses = channels.filter((one) => !isFelt(one));
  if (place === "stage") return skins.length > 0 ? { skins, senses: [] } : { skins: [], senses };
  return { skins: [], senses: skins.length > 0 ? senses : [] };
}

/** Joints may have the names of fingers, but are no skin. */
function isFelt(channel: ChannelData): boolean {
  return isSkin(channel) && (channel.layout !== undefined || !kAngles.has(channel.unit));
}

export class Readings {
  readonly root = element("div", { class: "readings" });
  private readonly place = element("div", { class: "skin-place" });
  private readonly senses = new Senses();
  private readonly contributions: Contributions;
  private skins: readonly Skin[] = [];
  private built = "";

  constructor(private readonly model: Model) {
    this.contributions = new Contributions(model);
    this.root.append(this.place, this.contributions.root, this.senses.root);
    model.explains.watch(() => this.arrange());
    model.question.watch(() => this.select());
  }

  /** Rebuilt only for other channels, so that the pointed element is kept. */
  take(shown: Shown): void {
    const text = JSON.stringify(shown);
    if (text === this.built) return;
    this.built = text;
    this.skins = shown.skins.map((channel) => new Skin(channel, this.model, shown.skins.length > 1));
    fill(
      this.place,
      this.skins.map(({ root }) => root),
    );
    this.contributions.build(shown.skins);
    this.arrange();
    this.root.hidden = shown.skins.length + shown.senses.length === 0;
    this.senses.build(shown.senses);
    this.select();
  }

  private arrange(): void {
    const explains = this.model.explains.value && this.skins.length > 0;
    this.place.hidden = explains || this.skins.length === 0;
    if (explains) this.contributions.show(this.model.frame.value?.reading ?? null);
    else this.contributions.hide();
  }

  show(frame: Frame): void {
    for (const skin of this.skins) skin.show(frame);
    if (!this.contributions.root.hidden) this.contributions.show(frame.reading);
    this.senses.show(frame);
    this.place.dataset["end"] = String(this.model.scale.end);
  }

  private select(): void {
    const question = this.model.question.value;
    for (const skin of this.skins) skin.select(question?.about === "taxel" ? question.element : null);
  }
}

/** Whether the colours keep their scale. */
export function holdScale(model: Model): HTMLElement {
  const hold = element("input", { type: "checkbox" });
  hold.addEventListener("change", () => (model.scale.held = hold.checked));
  const title = "Otherwise the colours follow the strongest touch of the exploration";
  return element("label", { class: "hold", title }, [hold, "hold scale"]);
}
