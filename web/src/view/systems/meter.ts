// A labelled bar with its number.

import { element, write } from "../../parts/dom";
import { digits } from "../../parts/numbers";

export class Meter {
  readonly root: HTMLElement;
  private readonly number = element("span", { class: "number" });
  private readonly bar = element("span", { class: "bar-fill" });
  private readonly meter: HTMLElement;

  /** The bar ends at `most`; a limit below it is marked, with a note that explains it. */
  constructor(
    name: string,
    private readonly most: number,
    private readonly limit: { at: number; note: string } | null = null,
  ) {
    const range = { "aria-valuemin": 0, "aria-valuemax": most };
    this.meter = element("div", { role: "meter", "aria-label": name, ...range, class: "bar" }, [this.bar]);
    const title = element("span", { class: "name" }, [name]);
    this.root = element("div", { class: `meter ${name.toLowerCase()}` }, [title, this.meter, this.number]);
    if (limit !== null) this.addLimit(limit.at / most, limit.note);
  }

  /** Hidden if there is no value. */
  show(value: number | null): void {
    this.root.hidden = value === null;
    if (value === null) return;
    const shown = Math.min(this.most, Math.max(0, value));
    write(this.number, digits(value));
    this.meter.setAttribute("aria-valuenow", shown.toFixed(2));
    if (this.limit !== null) this.meter.setAttribute("aria-valuetext", `${digits(value)}, ${this.limit.note}`);
    this.bar.style.width = `${(100 * shown) / this.most}%`;
    this.root.classList.toggle("beyond", this.limit !== null && value > this.limit.at);
  }

  private addLimit(share: number, note: string): void {
    this.meter.append(element("span", { class: "bar-limit", style: `left: ${100 * share}%` }));
    this.root.append(element("span", { class: "meter-note", "aria-hidden": "true" }, [note]));
  }
}
