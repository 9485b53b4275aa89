// The touch sensors of the unfolded hand.

import { element, fill } from "../parts/dom";
import { handMap, type HandPicture } from "../parts/hand_map";
import type { ChannelData, NumberOrNull } from "../parts/data";
import type { Model } from "./model";

export class UnfoldedHand {
  readonly root = element("div", { class: "unfolded" });
  private picture: HandPicture | null = null;
  private built = "";

  constructor(private readonly model: Model) {
    model.shownState.watch((state) => this.build(state?.channels.find(({ name }) => name === "touch")));
    model.question.watch((question) =>
      this.picture?.select(question?.about === "taxel" ? question.element : null),
    );
  }

  draw(values: readonly NumberOrNull[]): void {
    this.picture?.setValues(values, [0, this.model.scale.end]);
  }

  private build(channel: ChannelData | undefined): void {
    const text = JSON.stringify(channel ?? null);
    if (text === this.built) return;
    this.built = text;
    this.picture = channel === undefined ? null : this.make(channel);
    fill(this.root, [this.picture?.element ?? null]);
    this.draw(this.model.frame.value?.channels["touch"] ?? []);
  }

  private make(channel: ChannelData): HandPicture {
    const onChoose = (taxel: number) => void this.model.askTaxel(taxel);
    const picture = handMap(channel, { label: "Touch sensors, unfolded", unit: channel.unit, onChoose });
    picture.element.querySelector("output")?.setAttribute("aria-live", "off"); // changes with every frame
    return picture;
  }
}
