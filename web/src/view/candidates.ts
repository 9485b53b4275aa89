// A bar for each class, with a length proportional to its distance. The order is fixed, so that bars
// can be followed; the nearest class is marked.

import type { NumberOrNull } from "../parts/data";
import { element, fill } from "../parts/dom";
import { marker } from "../parts/markers";
import { digits } from "../parts/numbers";
import { shape } from "../parts/svg";
import type { Reading } from "./data";
import type { Model } from "./model";

interface Row {
  root: HTMLElement;
  bar: HTMLElement;
  distance: HTMLElement;
}

export class Candidates {
  readonly root = element("div", { class: "candidates" });
  private readonly list = element("ul", { "aria-label": "Distance to each class" });
  private rows = new Map<string, Row>();

  constructor(private readonly model: Model) {
    const note = element("p", { class: "muted small" }, [
      "Distance to the nearest neuron of each class",
    ]);
    this.root.append(this.list, note);
  }

  show(reading: Reading): void {
    const known = reading.candidates.every(({ name }) => this.rows.has(name));
    if (!known || reading.candidates.length !== this.rows.size) this.build(reading);
    const most = Math.max(...reading.candidates.map(({ distance }) => distance ?? 0), 1e-12);
    for (const { name, distance } of reading.candidates)
      this.update(name, distance, (distance ?? 0) / most, reading);
  }

  private update(name: string, distance: NumberOrNull, share: number, reading: Reading): void {
    const row = this.rows.get(name);
    if (row === undefined) return;
    row.bar.style.width = `${Math.min(1, Math.max(0, share)) * 100}%`;
    row.distance.textContent = digits(distance);
    row.root.classList.toggle("nearest", name === reading.answer);
  }

  private build(reading: Reading): void {
    const order = this.classes();
    const place = (name: string) => (order.indexOf(name) + order.length + 1) % (order.length + 1);
    const names = reading.candidates
      .map(({ name }) => name)
      .sort((a, b) => place(a) - place(b) || (a < b ? -1 : 1));
    this.rows = new Map(names.map((name) => [name, makeRow(name, order.indexOf(name))]));
    fill(
      this.list,
      [...this.rows.values()].map(({ root }) => root),
    );
  }

  private classes(): string[] {
    const state = this.model.shownState.value;
    return state?.maps.find(({ module }) => module === state.graph?.map)?.classes ?? [];
  }
}

function makeRow(name: string, number: number): Row {
  const bar = element("span", { class: "bar-fill" });
  const distance = element("span", { class: "number" });
  const root = element("li", { class: "candidate" }, [
    sign(number),
    element("span", { class: "candidate-name", title: name }, [name]),
    element("span", { class: "bar" }, [bar]),
    distance,
  ]);
  return { root, bar, distance };
}

/** The marker of the class on the map. */
export function sign(number: number): SVGSVGElement {
  const drawn = number < 0 ? [] : [marker(number, 8, 8, 5)];
  return shape(
    "svg",
    { viewBox: "0 0 16 16", width: 16, height: 16, class: "sign", "aria-hidden": "true" },
    drawn,
  );
}
