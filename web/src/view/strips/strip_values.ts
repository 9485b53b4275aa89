// The legend of a strip: the names of few elements with their values, or the maximum of many. The
// values are those of the present moment, or of the moment under the pointer.

import type { ChannelData, NumberOrNull } from "../../parts/data";
import { element, fill, write } from "../../parts/dom";
import { digits, seconds, withUnit } from "../../parts/numbers";
import { shape } from "../../parts/svg";
import { lineLook } from "./strip_lines";

const kMost = 12;

/** The moment under the pointer, in s, and the element, if a single one is under it. */
export interface Pointed {
  time: number;
  element: number | null;
}

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

  show(values: readonly NumberOrNull[] | null, pointed: Pointed | null = null): void {
    this.root.classList.toggle("pointed", pointed !== null);
    if (values === null) return;
    if (!this.few) write(this.root, this.manyWords(values, pointed));
    else if (values.length > this.cells.length) write(this.root, `last ${values.length} samples`);
    else this.cells.forEach((cell, i) => write(cell, digits(values[i] ?? Number.NaN)));
  }

  private manyWords(values: readonly NumberOrNull[], pointed: Pointed | null): string {
    const { elements, unit } = this.channel;
    const at = pointed?.element ?? greatest(values);
    const value = withUnit(digits(values[at] ?? Number.NaN), pointed === null ? "" : unit);
    const name = elements[at] ?? String(at + 1);
    if (pointed === null) return `max ${value} at ${name}`;
    return `${name}: ${value} at ${seconds(pointed.time)}`;
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
    const single = this.channel.elements.length === 1;
    return element("span", { class: "strip-value", title: name }, [
      single ? null : sample,
      single ? null : element("span", { class: "strip-name" }, [name]),
      this.cells[i]!,
    ]);
  }
}

/** The element with the greatest magnitude. */
function greatest(values: readonly NumberOrNull[]): number {
  const size = (i: number) => Math.abs(values[i] ?? 0) || 0;
  return values.reduce<number>((best, _, i) => (size(i) > size(best) ? i : best), 0);
}
