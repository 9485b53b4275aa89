// The values of a channel at one moment: numbers for few elements, a plot for many.

import * as Plot from "@observablehq/plot";

import type { Table } from "../../parts/csv";
import { element, type Child } from "../../parts/dom";
import { figure } from "../../parts/figure";
import { capital, readable, withUnit } from "../../parts/numbers";
import type { MomentChannel, SystemReport } from "../page/unpacked";
import { plotFigure, plotPicture } from "../maps/plots";
import { shownOf } from "../page/origin";
import { systemName } from "../page/words";

export function valuesFigure(system: SystemReport, of: MomentChannel, name: string): Child {
  return of.channel.elements.length <= kFewValues
    ? fewValues(system, of, name)
    : manyValues(system, of, name);
}

const kFewValues = 4;

function fewValues(system: SystemReport, of: MomentChannel, name: string): Child {
  const { channel } = of;
  const values = channel.elements.map((one, i) => {
    const words = withUnit(readable(of.values[i]), channel.unit);
    return element("div", {}, [
      element("dt", {}, [one === "1" ? channel.name : one]),
      element("dd", {}, [words]),
    ]);
  });
  return figure({
    title: `${capital(channel.name)} at the end`,
    file: `${systemName(system)}-${channel.name}-moment`,
    note: name,
    body: element("dl", { class: "facts values" }, values),
    numbers: () => valuesTable(of),
    about: () => shownOf(system, name),
  });
}

export function valuesTable({ channel, values }: MomentChannel): Table {
  return {
    columns: ["element", channel.unit || "value"],
    rows: channel.elements.map((one, i) => [one, values[i] ?? null]),
  };
}

function manyValues(system: SystemReport, of: MomentChannel, name: string): Child {
  const { channel } = of;
  const points = of.values.map((value, i) => ({ x: i + 1, value: value ?? 0 }));
  const plot = plotFigure(`${channel.name} while exploring ${name}`, {
    height: 220,
    x: { label: "element", grid: false },
    y: { label: channel.unit || "value", grid: true, nice: true },
    marks: [
      points.length > 120
        ? Plot.lineY(points, { x: "x", y: "value", stroke: "var(--class-0)" })
        : Plot.ruleX(points, { x: "x", y: "value", stroke: "var(--class-0)", strokeWidth: 2 }),
    ],
  });
  return figure({
    title: `${capital(channel.name)} at a moment`,
    file: `${systemName(system)}-${channel.name}-moment`,
    body: plot,
    note: name,
    picture: () => plotPicture(plot, []),
    numbers: () => valuesTable(of),
    about: () => shownOf(system, name),
  });
}
