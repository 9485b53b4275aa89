// The sensor readings over time: a strip for each selected channel.

import type { ChannelData } from "../../parts/data";
import { element, fill } from "../../parts/dom";
import type { State } from "../data";
import { drawsInSoftware } from "../scene/graphics";
import type { Model } from "../session/model";
import { Panel } from "../page/panel";
import { isPicture } from "../page/picture";
import { Strip } from "./strip";

// ms: strips change slowly.
const kPause = 60;
const kPauseInSoftware = 250;
const kFirst = ["joints", "touch", "sound"];
const kMost = 4;

export class StripsPanel {
  readonly panel = new Panel(6, "strips", "Over time");
  private readonly place = element("div", { class: "strips" });
  private readonly buttons = element("div", {
    class: "strip-choice",
    role: "group",
    "aria-label": "Channels",
  });
  private strips: Strip[] = [];
  private chosen = new Set<string>();
  private listed = "";
  private last = 0;
  private timer = 0;
  private next = 0; // the strip that is drawn next
  private waiting = 0; // strips that the newest frame has not reached yet

  constructor(private readonly model: Model) {
    this.panel.addTools(this.buttons);
    this.panel.add(this.place);
    model.shownState.watch((state) => state && this.take(state));
    model.frame.watch(() => this.schedule());
    model.theme.watch(() => this.rebuild());
    this.panel.whenOpen(() => this.rebuild());
  }

  private take(state: State): void {
    const text = JSON.stringify(state.channels);
    if (text !== this.listed) {
      this.listed = text;
      this.chosen = new Set(preferred(state.channels));
      this.rebuild();
    }
    this.schedule();
  }

  private rebuild(): void {
    const channels = this.model.shownState.value?.channels ?? [];
    for (const strip of this.strips) strip.destroy();
    this.next = 0;
    this.strips = channels
      .filter(({ name }) => this.chosen.has(name))
      .map((channel) => new Strip(channel, this.model));
    fill(
      this.buttons,
      channels.map((channel) => this.button(channel)),
    );
    const empty = element("p", { class: "empty" }, [
      channels.length === 0 ? "No sensor readings yet." : "No channel is selected.",
    ]);
    fill(this.place, this.strips.length === 0 ? [empty] : this.strips.map(({ root }) => root));
    this.place.dataset["count"] = String(this.strips.length);
    this.schedule();
  }

  private button({ name }: ChannelData): HTMLButtonElement {
    const attributes = { type: "button", class: "chip", "aria-pressed": String(this.chosen.has(name)) };
    const button = element("button", attributes, [name]);
    button.addEventListener("click", () => {
      if (!this.chosen.delete(name)) this.chosen.add(name);
      this.rebuild();
      [...this.buttons.querySelectorAll("button")].find((other) => other.textContent === name)?.focus();
    });
    return button;
  }

  /** All strips are drawn soon, one after the other, so that no picture of the page takes long. */
  private schedule(): void {
    if (isPicture()) return this.strips.forEach((strip) => strip.draw());
    this.waiting = this.strips.length;
    this.await();
  }

  private await(): void {
    window.clearTimeout(this.timer);
    if (this.waiting === 0) return;
    const pause = (drawsInSoftware() ? kPauseInSoftware : kPause) / this.strips.length;
    const wait = Math.max(0, this.last + pause - performance.now());
    this.timer = window.setTimeout(() => this.draw(), wait);
  }

  private draw(): void {
    this.last = performance.now();
    if (!this.panel.isOpen.value || document.hidden) return;
    this.strips[this.next]?.draw();
    this.next = (this.next + 1) % this.strips.length;
    this.waiting -= 1;
    this.await();
  }
}

function preferred(channels: readonly ChannelData[]): string[] {
  const names = channels.map(({ name }) => name);
  const first = kFirst.filter((name) => names.includes(name));
  return first.length > 0 ? first : names.slice(0, kMost);
}
