// A line over an ordered axis on a canvas: the samples of a sound, or a spectrum over frequency.

import type { NumberOrNull } from "../../parts/data";
import { element } from "../../parts/dom";
import { readable, withUnit } from "../../parts/numbers";
import { drawLine } from "./module_drawing";

/** The ends of the axis. */
export interface Axis {
  low: number;
  high: number;
  unit: string;
}

export class Plotter {
  readonly root: HTMLElement;
  private readonly canvas: HTMLCanvasElement;
  private readonly low = element("span");
  private readonly high = element("span");
  private readonly axis: HTMLElement;
  private values: readonly NumberOrNull[] = [];

  constructor(label: string) {
    this.canvas = element("canvas", { role: "img", class: "module-canvas", "aria-label": label });
    this.axis = element("div", { class: "plot-axis" }, [this.low, this.high]);
    this.root = element("div", { class: "plotter" }, [this.canvas, this.axis]);
    new ResizeObserver(([entry]) => this.resize(entry!.contentRect)).observe(this.canvas);
  }

  show(values: readonly NumberOrNull[], axis: Axis | null): void {
    this.values = values;
    this.axis.hidden = axis === null;
    if (axis !== null) {
      this.low.textContent = withUnit(readable(axis.low), axis.unit);
      this.high.textContent = withUnit(readable(axis.high), axis.unit);
    }
    this.draw();
  }

  private resize({ width, height }: DOMRectReadOnly): void {
    const ratio = Math.min(devicePixelRatio, 2);
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.draw();
  }

  private draw(): void {
    const context = this.canvas.getContext("2d");
    if (context === null || this.canvas.width === 0) return;
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    if (this.values.length > 0) drawLine(context, this.values);
  }
}
