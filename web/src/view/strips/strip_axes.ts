// Common parts of the strips over time: the axes, and the line at the current moment. Later moments
// of a recording are pale.

import type uPlot from "uplot";

import { significant } from "../../parts/numbers";
import type { Model } from "../session/model";
import { themeColour } from "../page/theme_colours";

/** How a kind of strip is made and what it is given. */
export interface Plot {
  options: Partial<uPlot.Options>;
  data: () => uPlot.AlignedData;
}

const kVeil = 0.6;
const kLeast = 5; // s, shown when little has come yet
const kFont = "10px system-ui, 'Noto Sans', 'Liberation Sans', sans-serif";

export function timeScale(model: Model): uPlot.Scale {
  return {
    time: false,
    range: () => [0, timeEnd(model)],
  };
}

/** The end time of the strips. */
export function timeEnd(model: Model): number {
  const known = model.shownState.value?.duration ?? null;
  return Math.max(known ?? kLeast, model.history.end, 0.1);
}

export function axes(y: Partial<uPlot.Axis>, isGrid = true): uPlot.Axis[] {
  const look = {
    stroke: themeColour("muted"),
    font: kFont,
    grid: { show: isGrid, stroke: themeColour("line"), width: 1 },
    ticks: { show: false },
  };
  const x = { ...look, size: 18, gap: 2, space: 50 };
  return [x, { ...look, size: 40, gap: 4, space: 22, ...y }];
}

export function drawMoment(model: Model): (plot: uPlot) => void {
  const colour = themeColour("accent");
  const veil = themeColour("surface");
  return (plot) => {
    const time = model.frame.value?.time;
    if (time === undefined) return;
    const x = Math.round(plot.valToPos(time, "x", true)) + 0.5;
    const { ctx: context } = plot;
    const { left, top, width, height } = plot.bbox;
    context.save();
    if (model.history.isWhole) {
      context.fillStyle = veil;
      context.globalAlpha = kVeil;
      context.fillRect(x, top, left + width - x, height);
      context.globalAlpha = 1;
    }
    context.setLineDash([]); // as the last series may have left it
    context.strokeStyle = colour;
    context.lineWidth = 1.5 * devicePixelRatio;
    context.beginPath();
    context.moveTo(x, top);
    context.lineTo(x, top + height);
    context.stroke();
    context.restore();
  };
}

export const kCursor: uPlot.Cursor = {
  drag: { x: false, y: false, setScale: false },
  points: { show: false },
  y: false,
  sync: { key: "strips" },
};

/** Short numbers for an axis. */
export function tickWords(_: uPlot, values: number[]): string[] {
  return values.map((value) => significant(value, 6));
}
