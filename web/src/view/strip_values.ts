// The values of a channel at the current moment: all of few elements, the maximum of many.

import type { ChannelData, NumberOrNull } from "../parts/data";
import { element, fill } from "../parts/dom";
import { digits } from "../parts/numbers";
import { shape } from "../parts/svg";
import { lineLook } from "./strip_lines";

const kMost = 12;

export class StripValues {
  readonly root = element("output", { class: "strip-values", "aria-live": "off" });
  private cells: HTMLElement[] = [];
  private readonly few: boolean;

  constructor(private readonly channel: ChannelData) {
    this.few = channel.elements.length <= kMost;
    this.root.classList.add(this.few ? "few" : "many");
    if (!this.few) return;
    this.cells = channel.elements.map(() => element("span", { class: "number" }));
    const items = channel.elements.map((name, i) => this.item(name, i));
    fill(this.root, items);
  }

  show(values: readonly NumberOrNull[] | null): void {
    if (values === null) return;
    if (!this.few) this.root.textContent = greatest(this.channel, values);
    else if (values.length > this.cells.length) this.root.textContent = `last ${values.length} samples`;
    else this.cells.forEach((cell, i) => (cell.textContent = digits(values[i] ?? Number.NaN)));
  }

  private item(name: string, i: number): HTMLElement {
    const { colour, dash } = lineLook(i);
    const line = shape("line", {
      x1: 0,
      y1: 5,
      x2: 9,
      y2: 5,
      stroke: colour,
      "stroke-width": 2.5,
      "stroke-dasharray": dash.join(" "),
    });
    const sample = shape("svg", { viewBox: "0 0 9 10", width: 9, height: 10, "aria-hidden": "true" }, [line]);
    const words = element("span", { class: "hidden-text" }, [name]);
    const single = this.channel.elements.length === 1;
    return element("span", { class: "strip-value", title: name }, [
      single ? null : sample,
      words,
      this.cells[i]!,
    ]);
  }
}

function greatest(channel: ChannelData, values: readonly NumberOrNull[]): string {
  const size = (i: number) => Math.abs(values[i] ?? 0) || 0;
  const at = values.reduce<number>((best, _, i) => (size(i) > size(best) ? i : best), 0);
  return `most ${digits(values[at] ?? 0)} at ${channel.elements[at] ?? at + 1}`;
}
