// A metric as a function of a setting: a line through the means, a band of one standard deviation
// and a dot for every value.

import * as Plot from "@observablehq/plot";

import type { Table } from "../../parts/csv";
import { element, type Child } from "../../parts/dom";
import { figure } from "../../parts/figure";
import { markerShape, plotSymbol } from "../../parts/maps/markers";
import { shortened } from "../../parts/svg";
import type { CurveReport, ReportData } from "../page/unpacked";
import { lazy } from "../page/lazy";
import { plotFigure, plotPicture, seriesLegend, strokeOf } from "./plots";
import { isShare, metricName } from "../page/words";

export function curvesSection(data: ReportData): HTMLElement {
  return element("section", { id: "curves", "aria-labelledby": "curves-title" }, [
    element("h2", { id: "curves-title" }, ["Metrics as a function of a setting"]),
    element("p", { class: "muted lead" }, [
      "Lines show means, bands one standard deviation on either side, and dots single runs.",
    ]),
    lazy(360, () => [
      element(
        "div",
        { class: "figures" },
        data.curves.map((curve, i) => curveFigure(curve, i)),
      ),
    ]),
  ]);
}

function curveFigure(curve: CurveReport, index: number): Child {
  const plot = curvePlot(curve);
  return figure({
    title: curve.title,
    file: `curve-${index + 1}-${curve.title}`,
    body: element("div", {}, [seriesLegend(curve.lines.map((line) => line.name)), plot]),
    picture: () =>
      plotPicture(
        plot,
        curve.lines.map((line) => line.name),
      ),
    numbers: () => curveTable(curve),
  });
}

interface Point {
  line: number;
  x: number;
  mean: number;
  low: number;
  high: number;
}

function curvePlot(curve: CurveReport): HTMLElement {
  const points = curve.lines.flatMap(({ points: all }, line): Point[] =>
    all.flatMap(({ x, mean, sd }) =>
      mean === null ? [] : [{ line, x, mean, low: mean - (sd ?? 0), high: mean + (sd ?? 0) }],
    ),
  );
  const dots = curve.lines.flatMap(({ points: all }, line) =>
    all.flatMap(({ x, values }) => values.map((y) => ({ line, x, y }))),
  );
  const unit = curve.unit === "" ? "" : ` (${curve.unit})`;
  return plotFigure(curve.title, {
    height: 280,
    x: { label: shortened(`${curve.x}${unit}`, 380, 12), grid: false },
    y: {
      label: shortened(metricName(curve.metric), 380, 12),
      grid: true,
      ...(isShare(curve.metric) ? { domain: [0, 1], clamp: true } : { zero: true }),
    },
    marks: [
      Plot.areaY(points, {
        x: "x",
        y1: "low",
        y2: "high",
        z: "line",
        fill: (d: Point) => strokeOf(d.line),
        fillOpacity: 0.13,
      }),
      Plot.dot(dots, { x: "x", y: "y", r: 1.6, fill: (d: Point) => strokeOf(d.line), fillOpacity: 0.35 }),
      Plot.lineY(points, {
        x: "x",
        y: "mean",
        z: "line",
        stroke: (d: Point) => strokeOf(d.line),
        strokeWidth: 2,
      }),
      Plot.dot(points, {
        x: "x",
        y: "mean",
        r: 3.5,
        fill: (d: Point) => strokeOf(d.line),
        symbol: "line",
        title: pointWords(curve),
      }),
    ],
    symbol: {
      domain: curve.lines.map((_, line) => line),
      range: curve.lines.map((_, line) => plotSymbol(markerShape(line))),
    },
    color: { type: "identity" },
  });
}

function pointWords(curve: CurveReport) {
  return (point: Point) => `${curve.lines[point.line]?.name ?? ""}, ${curve.x} ${point.x}: ${point.mean}`;
}

function curveTable(curve: CurveReport): Table {
  const rows = curve.lines.flatMap(({ name, points }) =>
    points.map(({ x, mean, sd, values }) => [name, x, mean, sd, values.join(" ")]),
  );
  return { columns: ["line", curve.x, `mean ${curve.metric}`, "sd", "values"], rows };
}
