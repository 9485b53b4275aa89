// A band for each of many elements, its colour telling the value: drawn as one small picture that is
// stretched over the plot.

import type uPlot from "uplot";

import { parsed, sequenceColour } from "../parts/colour_maps";
import type { ChannelData } from "../parts/data";
import { isGap } from "./gaps";
import type { Model } from "./model";
import type { Plot } from "./strip";
import { axes, drawMoment, kCursor, timeScale } from "./strip_axes";

const kLast = 0.01; // share of the whole that the last frame takes
const kTable = Array.from({ length: 256 }, (_, i) => {
  const [red, green, blue] = parsed(sequenceColour(i / 255));
  return 0xff000000 | (blue << 16) | (green << 8) | red;
});

export function bandPlot(channel: ChannelData, model: Model): Plot {
  const count = channel.elements.length;
  const canvas = document.createElement("canvas");
  const options = {
    scales: { x: timeScale(model), y: { range: (): [number, number] => [count + 0.5, 0.5] } },
    axes: axes({ values: (_: uPlot, ticks: number[]) => ticks.map((tick) => (Number.isInteger(tick) ? String(tick) : "")) }),
    series: [{}, { show: false }],
    cursor: kCursor,
    hooks: { drawSeries: [], drawClear: [(plot: uPlot) => drawBands(plot, canvas, channel, model)], draw: [drawMoment(model)] },
  };
  return { options, data: () => [model.history.times, model.history.times.map(() => null)] };
}

function drawBands(plot: uPlot, canvas: HTMLCanvasElement, channel: ChannelData, model: Model): void {
  const width = Math.max(1, Math.round(plot.bbox.width / devicePixelRatio));
  const end = plot.scales["x"]?.max ?? 1;
  const count = channel.elements.length;
  paint(canvas, width, count, columnsOf(model, channel.name, width, end));
  const { left, top, width: wide, height } = plot.bbox;
  plot.ctx.imageSmoothingEnabled = false;
  plot.ctx.drawImage(canvas, left, top, wide, height);
}

/** For each column of pixels the values that held then, or null where nobody has looked. */
function columnsOf(model: Model, channel: string, width: number, end: number): (readonly number[] | null)[] {
  const times = model.history.times;
  const rows = model.history.rows(channel);
  let at = -1;
  return Array.from({ length: width }, (_, x) => {
    const time = ((x + 0.5) / width) * end;
    while (at + 1 < times.length && (times[at + 1] ?? 0) <= time) at += 1;
    const seen = at >= 0 && isSeen(times, at, time, end);
    return seen ? (rows[at] ?? null) : null;
  });
}

function isSeen(times: readonly number[], at: number, time: number, end: number): boolean {
  if (at + 1 < times.length) return !isGap(times, at, end);
  return time - (times[at] ?? 0) <= kLast * end;
}

function paint(canvas: HTMLCanvasElement, width: number, height: number, columns: (readonly number[] | null)[]): void {
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d");
  if (context === null) return;
  const most = mostOf(columns);
  const image = context.createImageData(width, height);
  const pixels = new Uint32Array(image.data.buffer);
  columns.forEach((values, x) => {
    for (let y = 0; values !== null && y < height; y += 1)
      pixels[y * width + x] = colour(Math.abs(values[y] ?? 0) / most);
  });
  context.putImageData(image, 0, 0);
}

function mostOf(columns: (readonly number[] | null)[]): number {
  let most = 1e-9;
  for (const values of columns) for (const value of values ?? []) most = Math.max(most, Math.abs(value) || 0);
  return most;
}

function colour(share: number): number {
  return kTable[Math.round(Math.min(1, Math.max(0, share || 0)) * 255)] ?? 0;
}
