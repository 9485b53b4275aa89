// What the sensors told while a thing was explored: touch on the hand at one moment, and joints and
// touch over time.

import * as Plot from "@observablehq/plot";

import { choice } from "../parts/controls";
import { element, fill, uniqueId, type Child } from "../parts/dom";
import { figure } from "../parts/figure";
import { handLayout } from "../parts/hand_layout";
import { handMap } from "../parts/hand_map";
import { markerShape, plotSymbol } from "../parts/markers";
import { rangeOf, readable } from "../parts/numbers";
import type { MomentChannel, MomentData, SystemReport } from "./data";
import { matrixPicture } from "./matrix";
import { plotFigure, seriesLegend, strokeOf } from "./plots";
import { systemName } from "./words";

export function momentFigures(system: SystemReport): Child[] {
  const names = system.moments.map(momentName);
  const place = element("div", { class: "figures" });
  const show = (index: number) => {
    const moment = system.moments[index];
    if (moment) fill(place, figuresOf(system, moment, names[index] ?? ""));
  };
  show(0);
  return [element("div", { class: "controls" }, [choice("Exploration of", names, 0, show).element]), place];
}

function momentName(moment: MomentData, index: number): string {
  const words = Object.entries(moment.labels).map(([name, value]) => (name === "trial" ? `trial ${value}` : value));
  return words.join(", ") || `exploration ${index + 1}`;
}

function figuresOf(system: SystemReport, moment: MomentData, name: string): Child[] {
  const channels = moment.channels;
  const onHand = channels.filter((one) => one.channel.elements.length > 1 && handLayout(one.channel.elements) !== null);
  return channels.flatMap((one) => {
    const isOnHand = onHand.includes(one);
    const hasCourse = one.series.length > 1;
    return [
      isOnHand ? handFigure(system, one, name) : null,
      hasCourse ? courseFigure(system, one, name) : null,
      isOnHand || hasCourse ? null : valuesFigure(system, one, name),
    ];
  });
}

/** The hand at a moment that a slider chooses, where there is more than one. */
function handFigure(system: SystemReport, of: MomentChannel, name: string): Child {
  const { channel, series, times } = of;
  const picture = handMap(channel, { label: `${channel.name} while feeling ${name}`, unit: channel.unit, size: 380 });
  const range = rangeOf(series.flatMap((values) => rangeOf(values) ?? [])) ?? rangeOf(of.values) ?? [0, 1];
  const frames = [...series.map((values, i) => ({ time: times[i] ?? 0, values }))];
  let shown = { time: momentTime(of), values: of.values };
  const title = element("p", { class: "small what" });
  const show = () => {
    picture.setValues(shown.values, [Math.min(0, range[0]), range[1]]);
    title.textContent = `${name}, at ${readable(shown.time)} s`;
  };
  show();
  const slider = frames.length < 2 ? [] : [timeSlider(of, (index) => ((shown = frames[index] ?? shown), show()))];
  return figure({
    title: `${capital(channel.name)} at a moment`,
    file: `${systemName(system)}-${channel.name}-moment`,
    controls: slider,
    body: element("div", {}, [title, picture.element]),
    picture: () => picture.svg,
    numbers: () => ({ columns: ["element", channel.unit || "value"], rows: channel.elements.map((one, i) => [one, shown.values[i] ?? null]) }),
    note: "At first the moment at which most of the hand is touched.",
  });
}

function momentTime(of: MomentChannel): number {
  return of.rate > 0 ? of.frame / of.rate : (of.times.at(-1) ?? 0);
}

function timeSlider(of: MomentChannel, onChange: (index: number) => void): HTMLElement {
  const id = uniqueId("time");
  const nearest = of.times.reduce((best, time, i) => (Math.abs(time - momentTime(of)) < Math.abs((of.times[best] ?? 0) - momentTime(of)) ? i : best), 0);
  const slider = element("input", { type: "range", id, min: 0, max: of.times.length - 1, step: 1 });
  slider.value = String(nearest);
  const say = () => slider.setAttribute("aria-valuetext", `${readable(of.times[Number(slider.value)])} s`);
  say();
  slider.addEventListener("input", () => {
    say();
    onChange(Number(slider.value));
  });
  return element("span", { class: "control" }, [element("label", { for: id }, ["Time"]), slider]);
}

const kLines = 8;

function courseFigure(system: SystemReport, of: MomentChannel, name: string): Child {
  const { channel } = of;
  const isFew = channel.elements.length <= kLines;
  const body = isFew ? linesOf(of, name) : stripsOf(of, name);
  return figure({
    title: `${capital(channel.name)} over time`,
    file: `${systemName(system)}-${channel.name}-course`,
    body,
    picture: () => body.querySelector<SVGSVGElement>("svg.plot, svg.picture"),
    numbers: () => ({ columns: ["time (s)", ...channel.elements], rows: of.series.map((values, i) => [of.times[i] ?? null, ...values]) }),
    note: isFew ? `${name}. The upright line is the moment shown on the hand.` : `${name}. A row is an element; the upright line is the moment shown on the hand.`,
  });
}

function linesOf(of: MomentChannel, name: string): HTMLElement {
  const { channel } = of;
  const points = of.series.flatMap((values, i) => values.map((value, line) => ({ frame: i, time: of.times[i] ?? 0, value, line })));
  const marksApart = Math.max(8, Math.floor(of.series.length / 5));
  const plot = plotFigure(`${channel.name} while feeling ${name}`, {
    height: 250,
    x: { label: "time (s)", grid: false },
    y: { label: channel.unit || "value", grid: true, nice: true },
    color: { type: "identity" },
    marks: [
      Plot.ruleX([momentTime(of)], { stroke: "var(--line-strong)", strokeDasharray: "4 3" }),
      Plot.lineY(points, { x: "time", y: "value", z: "line", stroke: (point: { line: number }) => strokeOf(point.line), strokeWidth: 1.6 }),
      Plot.dot(points.filter(({ frame, line }) => (frame + 4 * line) % marksApart === 0), {
        x: "time",
        y: "value",
        r: 3.5,
        fill: (point: { line: number }) => strokeOf(point.line),
        symbol: "line",
      }),
    ],
    symbol: { domain: channel.elements.map((_, i) => i), range: channel.elements.map((_, i) => plotSymbol(markerShape(i))) },
  });
  return element("div", {}, channel.elements.length > 1 ? [seriesLegend(channel.elements), plot] : [plot]);
}

function stripsOf(of: MomentChannel, name: string): HTMLElement {
  const { channel } = of;
  const rows = channel.elements.map((_, i) => of.series.map((values) => values[i] ?? null));
  const picture = matrixPicture(rows, {
    label: `${channel.name} while feeling ${name}`,
    rowName: "element",
    columnName: "time",
    unit: channel.unit,
    height: Math.max(160, Math.min(340, rows.length * 7)),
    rowEnds: [shortName(channel.elements[0]), shortName(channel.elements.at(-1))],
    columnEnds: [`${readable(of.times[0])} s`, `${readable(of.times.at(-1))} s`],
  });
  const last = of.times.at(-1) ?? 1;
  picture.markColumn(last > 0 ? (momentTime(of) / last) * (of.series.length - 1) : 0);
  return element("div", {}, [picture.svg]);
}

function shortName(name: string | undefined): string {
  return (name ?? "").slice(0, 18);
}

function valuesFigure(system: SystemReport, of: MomentChannel, name: string): Child {
  const { channel } = of;
  const points = of.values.map((value, i) => ({ x: i + 1, value: value ?? 0 }));
  const plot = plotFigure(`${channel.name} while feeling ${name}`, {
    height: 220,
    x: { label: "element", grid: false },
    y: { label: channel.unit || "value", grid: true, nice: true },
    marks: [points.length > 120 ? Plot.lineY(points, { x: "x", y: "value", stroke: "var(--class-0)" }) : Plot.ruleX(points, { x: "x", y: "value", stroke: "var(--class-0)", strokeWidth: 2 })],
  });
  return figure({
    title: `${capital(channel.name)} at a moment`,
    file: `${systemName(system)}-${channel.name}-moment`,
    body: plot,
    picture: () => plot.querySelector("svg"),
    numbers: () => ({ columns: ["element", channel.unit || "value"], rows: channel.elements.map((one, i) => [one, of.values[i] ?? null]) }),
    note: name,
  });
}

function capital(words: string): string {
  return words.slice(0, 1).toUpperCase() + words.slice(1);
}
