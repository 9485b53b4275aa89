// A bar for each class: the distance of the nearest class divided by that of the class, so that the
// longest bar is the best. The order is fixed, so that bars can be followed.

import { element, fill, write } from "../../parts/dom";
import { marker } from "../../parts/maps/markers";
import { digits, percent } from "../../parts/numbers";
import { shape } from "../../parts/svg";
import type { Reading, State } from "../data";
import type { Model } from "../session/model";

interface Row {
  root: HTMLElement;
  bar: HTMLElement;
  nearness: HTMLElement;
}

export class Candidates {
  readonly root = element("div", { class: "candidates" });
  private readonly list = element("ul", { "aria-label": "Nearness of each class" });
  private readonly note = element("p", { class: "muted small" }, [
    "Nearness: distance of the nearest class divided by the distance of each.",
  ]);
  private rows = new Map<string, Row>();
  private listed = "";

  constructor(private readonly model: Model) {
    this.root.append(this.list, this.note);
    new ResizeObserver(() => this.makeReachable()).observe(this.list);
  }

  /** The keyboard scrolls a list that does not fit. */
  private makeReachable(): void {
    if (this.list.scrollHeight > this.list.clientHeight) this.list.tabIndex = 0;
    else this.list.removeAttribute("tabindex");
  }

  /** The classes of the map that is shown. */
  build(): void {
    const classes = classesOf(this.model.shownState.value, this.model.map.value);
    const text = JSON.stringify(classes);
    if (text === this.listed) return;
    this.listed = text;
    this.fillList(classes, classes);
  }

  show(reading: Reading | null): void {
    this.note.hidden = reading === null;
    const names = reading?.candidates.map(({ name }) => name) ?? [];
    if (names.some((name) => !this.rows.has(name))) this.fillList(names, []);
    const nearest = Math.min(...(reading?.candidates.map(({ distance }) => distance ?? Infinity) ?? []));
    const distances = new Map(reading?.candidates.map(({ name, distance }) => [name, distance]));
    for (const [name, row] of this.rows) {
      const distance = distances.get(name) ?? null;
      const share = distance === null ? null : distance > 0 ? nearest / distance : 1;
      row.bar.style.width = `${100 * (share ?? 0)}%`;
      write(row.nearness, share === null ? "" : percent(share));
      row.root.title = distance === null ? name : `${name}: distance ${digits(distance)}`;
      row.root.classList.toggle("nearest", name === reading?.answer);
    }
  }

  private fillList(names: readonly string[], classes: readonly string[]): void {
    this.rows = new Map(names.map((name) => [name, makeRow(name, classes.indexOf(name))]));
    fill(
      this.list,
      [...this.rows.values()].map(({ root }) => root),
    );
  }
}

function classesOf(state: State | null, map: string | null): string[] {
  return state?.maps.find(({ module }) => module === map)?.classes ?? [];
}

function makeRow(name: string, number: number): Row {
  const bar = element("span", { class: "bar-fill" });
  const nearness = element("span", { class: "number" });
  const root = element("li", { class: "candidate" }, [
    sign(number),
    element("span", { class: "candidate-name" }, [name]),
    element("span", { class: "bar" }, [bar]),
    nearness,
  ]);
  return { root, bar, nearness };
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
