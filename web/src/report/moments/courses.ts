// A channel over the time of an exploration: lines for few elements, rows of a matrix for many.

import * as Plot from "@observablehq/plot";

import { element, type Child } from "../../parts/dom";
import { figure } from "../../parts/figure";
import { fingerRuns } from "../../parts/hands/hand_layout";
import { markerShape, plotSymbol } from "../../parts/maps/markers";
import { capital, readable, withUnit } from "../../parts/numbers";
import { rounded, shape } from "../../parts/svg";
import type { MomentChannel, SystemReport } from "../page/unpacked";
import { matrixPicture } from "../maps/matrix";
import { frameAt, type Exploration } from "./exploration";
import { colourNote, readingColours } from "./reading_colours";
import { plotFigure, plotPicture, seriesLegend, strokeOf } from "../maps/plots";
import { shownOf } from "../page/origin";
import { systemName } from "../page/words";

const kLines = 8;

export function courseFigure(system: SystemReport, of: MomentChannel, exploration: Exploration): Child {
  const { channel } = of;
  const { name } = exploration;
  const isFew = channel.elements.length <= kLines;
  const body = isFew ? linesOf(of, exploration) : stripsOf(of, exploration);
  return figure({
    title: `${capital(channel.name)} over time`,
    file: `${systemName(system)}-${channel.name}-course`,
    body,
    picture: () => (isFew ? plotPicture(body, channel.elements) : body.querySelector("svg")),
    numbers: () => ({
      columns: ["time (s)", ...channel.elements],
      rows: of.series.map((values, i) => [of.times[i] ?? null, ...values]),
    }),
    about: () => shownOf(system, name),
    note: isFew ? "" : `Each row is an element.${colourNote(of)}`,
    hint: "The vertical line marks the time above.",
  });
}

function linesOf(of: MomentChannel, exploration: Exploration): HTMLElement {
  const { channel } = of;
  const points = of.series.flatMap((values, i) =>
    values.map((value, line) => ({ frame: i, time: of.times[i] ?? 0, value, line })),
  );
  const marksApart = Math.max(8, Math.floor(of.series.length / 5));
  const plot = plotFigure(`${channel.name} while exploring ${exploration.name}`, {
    height: 250,
    x: { label: "time (s)", grid: false },
    y: { label: channel.unit || "value", grid: true, nice: true },
    color: { type: "identity" },
    marks: [
      Plot.lineY(points, {
        x: "time",
        y: "value",
        z: "line",
        stroke: (point: Point) => strokeOf(point.line),
        strokeWidth: 1.6,
      }),
      Plot.dot(
        points.filter(({ frame, line }) => (frame + 4 * line) % marksApart === 0),
        { x: "time", y: "value", r: 3.5, fill: (point: Point) => strokeOf(point.line), symbol: "line" },
      ),
      Plot.tip(points, Plot.pointer({ x: "time", y: "value", title: tipOf(of) })),
    ],
    symbol: {
      domain: channel.elements.map((_, i) => i),
      range: channel.elements.map((_, i) => plotSymbol(markerShape(i))),
    },
  });
  followTime(plot, of, exploration);
  return element("div", {}, channel.elements.length > 1 ? [seriesLegend(channel.elements), plot] : [plot]);
}

interface Point {
  line: number;
  time: number;
  value: number | null;
}

function tipOf({ channel }: MomentChannel): (point: Point) => string {
  return ({ line, time, value }) => {
    const name = channel.elements.length > 1 ? `${channel.elements[line] ?? ""}\n` : "";
    return `${name}${readable(time)} s: ${withUnit(readable(value), channel.unit)}`;
  };
}

/** A line at the time of the exploration. */
function followTime(plot: HTMLElement, of: MomentChannel, exploration: Exploration): void {
  const picture = plot.querySelector<SVGSVGElement & { scale?: (name: string) => Plot.Scale }>("svg.plot");
  const scale = (name: string) => picture?.scale?.(name);
  const [x, y] = [scale("x"), scale("y")];
  const [low, high] = (y?.range ?? []) as number[];
  if (!picture || !x || low === undefined || high === undefined) return;
  const line = shape("path", { class: "time-line" });
  const show = () => {
    const at = Number(x.apply(of.times[frameAt(of, exploration.time)]));
    line.setAttribute("d", `M${rounded(at)} ${low}V${high}`);
  };
  show();
  exploration.listen(show);
  picture.append(line);
}

function stripsOf(of: MomentChannel, exploration: Exploration): HTMLElement {
  const { channel } = of;
  const rows = channel.elements.map((_, i) => of.series.map((values) => values[i] ?? null));
  const picture = matrixPicture(rows, {
    label: `${channel.name} while exploring ${exploration.name}`,
    rowName: "element",
    columnName: "time",
    unit: channel.unit,
    ...readingColours(of),
    height: Math.max(160, Math.min(340, rows.length * 7)),
    rowEnds: [shortName(channel.elements[0]), shortName(channel.elements.at(-1))],
    columnEnds: [`${readable(of.times[0])} s`, `${readable(of.times.at(-1))} s`],
    bands: fingerRuns(channel.elements),
    describe: (row, column) => `${channel.elements[row] ?? ""}, ${readable(of.times[column])} s`,
  });
  const show = () => picture.markColumn(frameAt(of, exploration.time));
  show();
  exploration.listen(show);
  return picture.element;
}

function shortName(name: string | undefined): string {
  return (name ?? "").slice(0, 18);
}
