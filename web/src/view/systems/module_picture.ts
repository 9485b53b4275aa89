// The current output of one module: bars for few values, a line over frequency for a spectrum, a line
// for other values in one row, otherwise a picture of rows and columns.

import type { ModuleData } from "../../parts/data";
import { element, fill, write } from "../../parts/dom";
import { countOf, fineDigits, percent, readable } from "../../parts/numbers";
import type { Frame } from "../data";
import type { Model } from "../session/model";
import { drawBars, drawCells, drawLine } from "./module_drawing";
import { spectrumAxis } from "../strips/spectrum_axis";

const kMostBars = 64;

type Values = Frame["modules"][string];

export class ModulePicture {
  readonly root = element("div", { class: "module-values" });
  private readonly about = element("p", { class: "muted module-about" });
  private readonly numbers = element("p", { class: "number module-numbers" });
  private readonly canvas = element("canvas", { role: "img", class: "module-canvas" });
  private readonly context = this.canvas.getContext("2d");
  private readonly pixels = element("canvas");
  private readonly axis = element("div", { class: "plot-axis" });

  constructor(private readonly model: Model) {
    this.root.append(this.about, this.canvas, this.axis, this.numbers);
    new ResizeObserver(([entry]) => this.resize(entry!.contentRect)).observe(this.canvas);
  }

  /** The size is passed in, because querying it for each frame forces a layout of the page. */
  private resize({ width, height }: DOMRectReadOnly): void {
    const ratio = Math.min(devicePixelRatio, 2);
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.draw(this.model.frame.value);
  }

  draw(frame: Frame | null): void {
    const name = this.model.module.value;
    const module = this.model.shownState.value?.graph?.modules.find((one) => one.name === name);
    if (module === undefined) return;
    this.describe(module);
    const values = frame?.modules[module.name];
    write(this.numbers, values === undefined ? notHere(module) : wordsOf(module, values));
    this.paint(values, isRow(module));
  }

  private describe(module: ModuleData): void {
    const { name, text } = module;
    if (this.root.dataset["module"] === name && this.about.title === text) return;
    this.root.dataset["module"] = name;
    this.about.textContent = this.about.title = text;
    this.canvas.setAttribute("aria-label", `Values of ${name}`);
    this.showAxis(module);
  }

  private showAxis(module: ModuleData): void {
    const state = this.model.shownState.value;
    const axis = state === null ? null : spectrumAxis(module, state);
    this.axis.hidden = axis === null;
    const ends = axis === null ? [] : [axis.low, axis.high];
    fill(
      this.axis,
      ends.map((end) => element("span", {}, [`${readable(end)} ${axis!.unit}`])),
    );
  }

  private paint(values: Values | undefined, isRow: boolean): void {
    const { context, pixels } = this;
    const { width, height } = this.canvas;
    if (context === null || width === 0 || height === 0) return;
    context.clearRect(0, 0, width, height);
    if (values === undefined) return;
    if (values.values.length <= kMostBars) drawBars(context, values.values, Math.min(devicePixelRatio, 2));
    else if (isRow) drawLine(context, values.values);
    else drawCells(context, pixels, values.values, values.shape);
  }
}

function notHere(module: ModuleData): string {
  return module.rate === "exploration"
    ? "The output is available at the end of an exploration."
    : "No output yet.";
}

/** Values in one row have an order, such as that of frequencies. */
function isRow(module: ModuleData): boolean {
  return !module.sparse && module.shape.filter((size) => size > 1).length === 1;
}

function wordsOf(module: ModuleData, { shape, values, folded }: Values): string {
  const numbers = values.filter((value) => value !== null);
  const most = numbers.reduce((best, value) => (Math.abs(value) > Math.abs(best) ? value : best), 0);
  if (values.length === 1) return fineDigits(most);
  const active = numbers.filter((value) => value !== 0).length / Math.max(1, numbers.length);
  const all = module.shape.reduce((product, size) => product * size, 1);
  const shown = folded ? `, shown as ${shape.join(" × ")}` : "";
  return `max ${fineDigits(most)} · ${percent(active)} active · ${countOf(all, "value")}${shown}`;
}
