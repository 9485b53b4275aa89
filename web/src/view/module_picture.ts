// The values of one module as they go through the system: bars where they are few, else a picture of
// rows and columns.

import type { ModuleData } from "../parts/data";
import { element } from "../parts/dom";
import type { Frame } from "./data";
import type { Model } from "./model";
import { drawBars, drawCells } from "./module_drawing";
import { digits } from "./numbers";
import { Pixels } from "./pixels";

const kMostBars = 64;

type Values = Frame["modules"][string];

export class ModulePicture {
  readonly root = element("div", { class: "module-values" });
  private readonly name = element("h3");
  private readonly about = element("span", { class: "muted module-about" });
  private readonly numbers = element("p", { class: "number module-numbers" });
  private readonly canvas = element("canvas", { role: "img", class: "module-canvas" });
  private readonly context = this.canvas.getContext("2d");
  private readonly pixels = new Pixels();

  constructor(private readonly model: Model) {
    const head = element("div", { class: "module-head" }, [this.name, this.about]);
    this.root.append(head, this.canvas, this.numbers);
    new ResizeObserver(([entry]) => this.resize(entry!.contentRect)).observe(this.canvas);
  }

  /** Told, not asked for with each frame: to ask makes the browser lay out the page at once. */
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
    this.tell(module);
    const values = frame?.modules[module.name];
    this.numbers.textContent = values === undefined ? notHere(module) : wordsOf(module, values);
    this.paint(values);
  }

  private tell({ name, text }: ModuleData): void {
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
    ? "Comes at the end of an exploration."
    : "Nothing comes out of it yet.";
}

function wordsOf(module: ModuleData, { shape, values, folded }: Values): string {
  const size = module.shape.length === 0 ? "one number" : module.shape.join(" × ");
  const shown = folded ? `, summed to ${shape.join(" × ")}` : "";
  const most = values.reduce((best, value) => (Math.abs(value) > Math.abs(best) ? value : best), 0);
  const active = values.filter((value) => value !== 0).length;
  const head =
    values.length === 1
      ? `value ${digits(values[0] ?? 0)}`
      : `most ${small(most)}, ${active} of ${values.length} not 0`;
  return `${head}; ${size}${shown}`;
}

/** Weights and normalized values are often small. */
function small(value: number): string {
  return value !== 0 && Math.abs(value) < 0.1 ? value.toFixed(4).replace(/^-/, "−") : digits(value);
}
