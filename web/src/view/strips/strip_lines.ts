// A line for each element, distinguished by colour and dashes.

import type uPlot from "uplot";

import type { ChannelData } from "../../parts/data";
import { kClassColours } from "../../parts/maps/colour_maps";
import { gapsOf } from "./gaps";
import type { Model } from "../session/model";
import { axes, drawMoment, kCursor, tickWords, timeEnd, timeScale, type Plot } from "./strip_axes";
import { themeColour } from "../page/theme_colours";

const kDashes = [[], [5, 2], [2, 2], [6, 2, 1, 2]];
const kOrder = [0, 1, 2, 3, 5, 4, 7, 6]; // yellow last: it is faint on white

export function lineLook(element: number): { colour: string; dash: number[] } {
  const colour = themeColour(`class-${kOrder[element % kClassColours] ?? 0}`);
  return { colour, dash: kDashes[element % kDashes.length] ?? [] };
}

export function linePlot(channel: ChannelData, model: Model): Plot {
  const series = channel.elements.map((name, i): uPlot.Series => {
    const { colour, dash } = lineLook(i);
    return { label: name, stroke: colour, dash, width: 1.5, points: { show: fewPoints, size: 4 } };
  });
  const options = {
    scales: { x: timeScale(model), y: { range: comfortable } },
    axes: axes({ values: tickWords }),
    series: [{}, ...series],
    cursor: kCursor,
    hooks: { draw: [drawMoment(model)] },
  };
  return { options, data: () => columns(channel, model) };
}

/** A margin above and below; the range is never empty. */
function comfortable(_: uPlot, low: number | null, high: number | null): [number, number] {
  if (low === null || high === null || !Number.isFinite(low) || !Number.isFinite(high)) return [0, 1];
  const air = high > low ? (high - low) * 0.08 : Math.max(1, Math.abs(high) * 0.1);
  return [low - air, high + air];
}

/** If there are few frames, each is a dot. */
function fewPoints(_: uPlot, __: number, first: number, last: number): boolean {
  return last - first < 16;
}

/** With a missing value in the middle of a gap, so that no line is drawn across it. */
function columns(channel: ChannelData, model: Model): uPlot.AlignedData {
  const { times } = model.history;
  const rows = model.history.rows(channel.name);
  const isGap = gapsOf(model.history, timeEnd(model));
  const cuts = times.map((time, i) => (isGap(i) ? [time, (time + times[i + 1]!) / 2] : [time]));
  const column = (element: number) =>
    cuts.flatMap(({ length }, i) => [rows[i]?.[element] ?? null, null].slice(0, length));
  return [cuts.flat(), ...channel.elements.map((_, i) => column(i))];
}
