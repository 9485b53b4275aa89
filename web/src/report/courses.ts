// A channel over the time of an exploration: lines for few elements, rows of a matrix for many.

import * as Plot from "@observablehq/plot";

import { element, type Child } from "../parts/dom";
import { figure } from "../parts/figure";
import { handLayout } from "../parts/hand_layout";
import { markerShape, plotSymbol } from "../parts/markers";
import { readable } from "../parts/numbers";
import type { MomentChannel, MomentData, SystemReport } from "./data";
import { capital } from "./groups";
import { matrixPicture } from "./matrix";
import { momentIndex, momentTime } from "./moment_time";
import { plotFigure, plotPicture, seriesLegend, strokeOf } from "./plots";
import { systemName } from "./words";

const kLines = 8;

export function courseFigure(
  system: SystemReport,
  moment: MomentData,
  of: MomentChannel,
  name: string,
): Child {
  const { channel } = of;
  const isFew = channel.elements.length <= kLines;
  const body = isFew ? linesOf(of, name) : stripsOf(of, name);
  return figure({
    title: `${capital(channel.name)} over time`,
    file: `${systemName(system)}-${channel.name}-course`,
    body,
    picture: () => (isFew ? plotPicture(body, channel.elements) : body.querySelector("svg")),
    numbers: () => ({
      columns: ["time (s)", ...channel.elements],
      rows: of.series.map((values, i) => [of.times[i] ?? null, ...values]),
    }),
    note: `${name}. ${isFew ? "The" : "Each row is an element; the"} vertical line marks ${momentWords(moment)}.`,
  });
}

/** The moment is that of maximum touch if there is a touch channel, otherwise the last frame. */
function momentWords({ channels }: MomentData): string {
  if (channels.some(({ channel }) => handLayout(channel.elements) !== null))
    return "the moment shown on the hand";
  const hasTouch = channels.some(({ channel }) => channel.name === "touch");
  return hasTouch ? "the moment of maximum touch" : "the last frame";
}

function linesOf(of: MomentChannel, name: string): HTMLElement {
  const { channel } = of;
  const points = of.series.flatMap((values, i) =>
    values.map((value, line) => ({ frame: i, time: of.times[i] ?? 0, value, line })),
  );
  const marksApart = Math.max(8, Math.floor(of.series.length / 5));
  const plot = plotFigure(`${channel.name} while exploring ${name}`, {
    height: 250,
    x: { label: "time (s)", grid: false },
    y: { label: channel.unit || "value", grid: true, nice: true },
    color: { type: "identity" },
    marks: [
      Plot.ruleX([momentTime(of)], { stroke: "var(--line-strong)", strokeDasharray: "4 3" }),
      Plot.lineY(points, {
        x: "time",
        y: "value",
        z: "line",
        stroke: (point: { line: number }) => strokeOf(point.line),
        strokeWidth: 1.6,
      }),
      Plot.dot(
        points.filter(({ frame, line }) => (frame + 4 * line) % marksApart === 0),
        {
          x: "time",
          y: "value",
          r: 3.5,
          fill: (point: { line: number }) => strokeOf(point.line),
          symbol: "line",
        },
      ),
    ],
    symbol: {
      domain: channel.elements.map((_, i) => i),
      range: channel.elements.map((_, i) => plotSymbol(markerShape(i))),
    },
  });
  return element("div", {}, channel.elements.length > 1 ? [seriesLegend(channel.elements), plot] : [plot]);
}

function stripsOf(of: MomentChannel, name: string): HTMLElement {
  const { channel } = of;
  const rows = channel.elements.map((_, i) => of.series.map((values) => values[i] ?? null));
  const picture = matrixPicture(rows, {
    label: `${channel.name} while exploring ${name}`,
    rowName: "element",
    columnName: "time",
    unit: channel.unit,
    height: Math.max(160, Math.min(340, rows.length * 7)),
    rowEnds: [shortName(channel.elements[0]), shortName(channel.elements.at(-1))],
    columnEnds: [`${readable(of.times[0])} s`, `${readable(of.times.at(-1))} s`],
  });
  picture.markColumn(momentIndex(of));
  return element("div", {}, [picture.svg]);
}

function shortName(name: string | undefined): string {
  return (name ?? "").slice(0, 18);
}
