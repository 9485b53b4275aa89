// A band for each of many elements, its colour telling the value: drawn as one small picture that is
// stretched over the plot.

import type uPlot from "uplot";

import { parsed, sequenceColour } from "../parts/colour_maps";
import type { ChannelData } from "../parts/data";
import { gapsOf } from "./gaps";
import type { History } from "./history";
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
  const bands = new Bands(channel, model);
  const options = {
    scales: { x: timeScale(model), y: { range: (): [number, number] => [count + 0.5, 0.5] } },
    axes: axes({
      values: (_: uPlot, ticks: number[]) =>
        ticks.map((tick) => (Number.isInteger(tick) ? String(tick) : "")),
    }),
    series: [{}, { show: false }],
    cursor: kCursor,
    hooks: {
      drawSeries: [],
      drawClear: [(plot: uPlot) => bands.draw(plot)],
      draw: [drawMoment(model)],
    },
  };
  return { options, data: () => nothingAt(model.history.times) };
}

function nothingAt(times: number[]): uPlot.AlignedData {
  return [times, times.map(() => null)];
}

class Bands {
  private readonly canvas = document.createElement("canvas");
  private painted = "";

  constructor(
    private readonly channel: ChannelData,
    private readonly model: Model,
  ) {}

  draw(plot: uPlot): void {
    const { left, top, width, height } = plot.bbox;
    this.paint(Math.max(1, Math.round(width / devicePixelRatio)), plot.scales["x"]?.max ?? 1);
    plot.ctx.imageSmoothingEnabled = false;
    plot.ctx.drawImage(this.canvas, left, top, width, height);
  }

  /** Only where something else is to be seen. */
  private paint(width: number, end: number): void {
    const wanted = [this.model.history.version, width, end].join();
    if (wanted === this.painted) return;
    this.painted = wanted;
    const columns = columnsOf(this.model.history, this.channel.name, width, end);
    paint(this.canvas, width, this.channel.elements.length, columns);
  }
}

/** For each column of pixels the values that held then, or null where nobody has looked. */
function columnsOf(
  history: History,
  channel: string,
  width: number,
  end: number,
): (readonly number[] | null)[] {
  const { times } = history;
  const rows = history.rows(channel);
  const isGap = gapsOf(history, end);
  const isSeen = (at: number, time: number) =>
    at + 1 < times.length ? !isGap(at) : time - (times[at] ?? 0) <= kLast * end;
  let at = -1;
  return Array.from({ length: width }, (_, x) => {
    const time = ((x + 0.5) / width) * end;
    while (at + 1 < times.length && (times[at + 1] ?? 0) <= time) at += 1;
    return at >= 0 && isSeen(at, time) ? (rows[at] ?? null) : null;
  });
}

function paint(
  canvas: HTMLCanvasElement,
  width: number,
  height: number,
  columns: (readonly number[] | null)[],
): void {
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
