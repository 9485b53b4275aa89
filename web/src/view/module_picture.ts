// The current output of one module: bars for few values, otherwise a picture of rows and columns.

import type { ModuleData } from "../parts/data";
import { element } from "../parts/dom";
import { digits, fineDigits } from "../parts/numbers";
import type { Frame } from "./data";
import type { Model } from "./model";
import { drawBars, drawCells } from "./module_drawing";

const kMostBars = 64;

type Values = Frame["modules"][string];

export class ModulePicture {
  readonly root = element("div", { class: "module-values" });
  private readonly name = element("h3");
  private readonly about = element("span", { class: "muted module-about" });
  private readonly numbers = element("p", { class: "number module-numbers" });
  private readonly canvas = element("canvas", { role: "img", class: "module-canvas" });
  private readonly context = this.canvas.getContext("2d");
  private readonly pixels = element("canvas");

  constructor(private readonly model: Model) {
    const head = element("div", { class: "module-head" }, [this.name, this.about]);
    this.root.append(head, this.canvas, this.numbers);
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
    this.numbers.textContent = values === undefined ? notHere(module) : wordsOf(module, values);
    this.paint(values);
  }

  private describe({ name, text }: ModuleData): void {
    if (this.name.textContent === name && this.about.title === text) return;
    this.name.textContent = name;
    this.about.textContent = this.about.title = text;
    this.canvas.setAttribute("aria-label", `Values of ${name}`);
  }

  private paint(values: Values | undefined): void {
    const { context, pixels } = this;
    const { width, height } = this.canvas;
    if (context === null || width === 0 || height === 0) return;
    context.clearRect(0, 0, width, height);
    if (values === undefined) return;
    if (values.values.length <= kMostBars) drawBars(context, values.values, Math.min(devicePixelRatio, 2));
    else drawCells(context, pixels, values.values, values.shape);
  }
}

function notHere(module: ModuleData): string {
  return module.rate === "exploration"
    ? "The output is available at the end of an exploration."
    : "No output yet.";
}

function wordsOf(module: ModuleData, { shape, values, folded }: Values): string {
  const size = module.shape.length === 0 ? "one number" : module.shape.join(" × ");
  const shown = folded ? `, summed to ${shape.join(" × ")}` : "";
  const numbers = values.filter((value) => value !== null);
  const most = numbers.reduce((best, value) => (Math.abs(value) > Math.abs(best) ? value : best), 0);
  const active = numbers.filter((value) => value !== 0).length;
  const head =
    values.length === 1
      ? `value ${digits(values[0])}`
      : `most ${fineDigits(most)}, ${active} of ${values.length} not 0`;
  return `${head}; ${size}${shown}`;
}
