// A band for each of many elements, coloured by its value: drawn as one small picture that is
// scaled to the plot.

import type uPlot from "uplot";

import { sequenceColour } from "../../parts/maps/colour_maps";
import type { ChannelData } from "../../parts/data";
import { paintPixels, pixelRamp, type PixelAt } from "../../parts/maps/painter";
import { fingerGroups, type Group } from "../scene/finger_groups";
import { gapsOf } from "./gaps";
import { strongest, type Column } from "./strongest";
import type { History } from "./history";
import type { Model } from "../session/model";
import { axes, drawMoment, kCursor, timeScale, type Plot } from "./strip_axes";
import { themeColour } from "../page/theme_colours";

const kLast = 0.01; // share of the whole that the last frame takes
const colour = pixelRamp(sequenceColour);

export function bandPlot(channel: ChannelData, model: Model): Plot {
  const count = channel.elements.length;
  const bands = new Bands(channel, model);
  const groups = fingerGroups(channel.elements);
  const options = {
    scales: { x: timeScale(model), y: { dir: -1 as const, range: (): [number, number] => [0.5, count + 0.5] } },
    axes: axes(groups.length > 0 ? fingerAxis(groups) : { values: wholeNumbers }, false),
    series: [{}, { show: false }],
    cursor: kCursor,
    hooks: {
      drawSeries: [],
      drawClear: [(plot: uPlot) => bands.draw(plot)],
      draw: [drawBetween(groups), drawMoment(model)],
    },
  };
  return { options, data: () => nothingAt(model.history.times) };
}

/** Names in the middle of the rows of each finger. */
function fingerAxis(groups: readonly Group[]): Partial<uPlot.Axis> {
  return {
    size: 48,
    splits: () => groups.map(({ first, count }) => first + (count + 1) / 2),
    values: () => groups.map(({ name }) => name),
  };
}

/** A line between the rows of two fingers. */
function drawBetween(groups: readonly Group[]): (plot: uPlot) => void {
  const colour = themeColour("surface");
  return (plot) => {
    const { left, width } = plot.bbox;
    plot.ctx.save(); // uPlot remembers the styles that it has set
    plot.ctx.fillStyle = colour;
    for (const { first } of groups.slice(1))
      plot.ctx.fillRect(left, Math.round(plot.valToPos(first + 0.5, "y", true)), width, devicePixelRatio);
    plot.ctx.restore();
  };
}

function wholeNumbers(_: uPlot, ticks: number[]): string[] {
  return ticks.map((tick) => (Number.isInteger(tick) ? String(tick) : ""));
}

function nothingAt(times: number[]): uPlot.AlignedData {
  return [times, times.map(() => null)];
}

class Bands {
  private readonly picture = document.createElement("canvas");
  private painted = "";

  constructor(
    private readonly channel: ChannelData,
    private readonly model: Model,
  ) {}

  draw(plot: uPlot): void {
    const { left, top, width, height } = plot.bbox;
    const across = Math.max(1, Math.round(width / devicePixelRatio));
    const down = Math.max(1, Math.round(height / devicePixelRatio));
    this.paint(across, Math.min(down, this.channel.elements.length), plot.scales["x"]?.max ?? 1);
    plot.ctx.imageSmoothingEnabled = false;
    plot.ctx.drawImage(this.picture, left, top, width, height);
  }

  /** Redraws only if the picture has changed. */
  private paint(width: number, height: number, end: number): void {
    const wanted = [this.model.history.version, width, height, end].join();
    if (wanted === this.painted) return;
    this.painted = wanted;
    const columns = columnsOf(this.model.history, this.channel.name, width, end);
    paintPixels(this.picture, width, height, pixelsOf(columns, height, this.channel.elements.length));
  }
}

function columnsOf(history: History, channel: string, width: number, end: number): Column[] {
  const { times } = history;
  const rows = history.rows(channel);
  const isGap = gapsOf(history, end);
  const isKnown = (at: number, time: number) =>
    at + 1 < times.length ? !isGap(at) : time - (times[at] ?? 0) <= kLast * end;
  let at = -1;
  return Array.from({ length: width }, (_, x) => {
    const before = at;
    const time = ((x + 0.5) / width) * end;
    while (at + 1 < times.length && (times[at + 1] ?? 0) <= time) at += 1;
    if (at > before) return rows.slice(before + 1, at + 1);
    return at >= 0 && isKnown(at, time) ? [rows[at] ?? []] : [];
  });
}

/** Where several elements or moments share a pixel it has the colour of the strongest; none where all are missing. */
function pixelsOf(columns: Column[], height: number, elements: number): PixelAt {
  const most = Math.max(1e-9, ...columns.map((rows) => strongest(rows, 0, elements) ?? 0));
  const first = (y: number) => Math.ceil((y * elements) / height);
  return (x, y) => {
    const value = strongest(columns[x] ?? [], first(y), first(y + 1));
    return value === null ? null : colour(value / most);
  };
}
