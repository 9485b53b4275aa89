// The legend of the taxels' colours, with a switch that keeps their scale fixed.

import { sequenceColour } from "../parts/colour_maps";
import { element, fill } from "../parts/dom";
import { colourBar } from "../parts/legend";
import { svg } from "../parts/svg";
import type { Model } from "./model";

const kWidth = 150;

export class ForceLegend {
  readonly root: HTMLElement;
  private readonly hold = element("input", { type: "checkbox" });
  private readonly place = element("div", { class: "force-bar" });
  private unit: string | null = null;
  private end = -1;
  private setRange: (low: number, high: number) => void = () => undefined;

  constructor(private readonly model: Model) {
    const label = element(
      "label",
      { class: "hold", title: "Otherwise the scale follows the strongest touch of the exploration" },
      [this.hold, "hold scale"],
    );
    this.root = element("div", { class: "force-legend" }, [this.place, label]);
    this.hold.addEventListener("change", () => (model.scale.held = this.hold.checked));
    model.shownState.watch((state) => {
      const unit = state?.channels.find(({ name }) => name === "touch")?.unit ?? "";
      if (unit !== this.unit) this.build(unit);
    });
  }

  draw(): void {
    const { end } = this.model.scale;
    if (end !== this.end) this.setRange(0, end);
    this.end = end;
    this.root.dataset["end"] = String(end);
  }

  private build(unit: string): void {
    this.unit = unit;
    this.end = -1;
    const bar = colourBar(kWidth, unit, sequenceColour);
    this.setRange = bar.setRange;
    fill(this.place, [svg(kWidth, 30, `Colours of touch${unit && `, in ${unit}`}`, [bar.group])]);
    this.draw();
  }
}
