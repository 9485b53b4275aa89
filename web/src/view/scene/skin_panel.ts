// Beside the body: its skin, or its other senses (readings.ts). Hidden if everything is in place of
// the body.

import { Panel } from "../page/panel";
import type { Frame } from "../data";
import type { Model } from "../session/model";
import { contributionsSwitch } from "./contributions";
import { holdScale, Readings, readingsAt } from "./readings";

export class SkinPanel {
  readonly panel = new Panel(2, "skin", "Skin");
  private readonly readings: Readings;
  private readonly holding: HTMLElement;
  private readonly explaining: HTMLElement;

  constructor(private readonly model: Model) {
    this.readings = new Readings(model);
    this.holding = holdScale(model);
    this.explaining = contributionsSwitch(model);
    this.panel.addTools(this.explaining, this.holding);
    this.panel.add(this.readings.root);
    model.shownState.watch(() => this.arrange());
    model.shownScene.watch(() => this.arrange());
    model.frame.watch((frame) => this.draw(frame));
    this.panel.whenOpen(() => this.draw(model.frame.value));
  }

  private arrange(): void {
    const channels = this.model.shownState.value?.channels ?? [];
    const shown = readingsAt("beside", channels, this.model.hasBody);
    this.panel.root.hidden = channels.length > 0 && shown.skins.length + shown.senses.length === 0;
    this.panel.rename(shown.skins.length > 0 || channels.length === 0 ? "Skin" : "Senses");
    this.holding.hidden = this.explaining.hidden = shown.skins.length === 0;
    this.readings.take(shown);
    this.draw(this.model.frame.value);
  }

  private draw(frame: Frame | null): void {
    if (frame !== null && this.panel.isOpen.value) this.readings.show(frame);
  }
}
