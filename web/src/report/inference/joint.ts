// How many claims hold together, over the settings of the prior and of the posterior.

import * as Plot from "@observablehq/plot";

import type { Table } from "../../parts/csv";
import { element, type Child } from "../../parts/dom";
import { figure } from "../../parts/figure";
import { plotFigure, plotPicture, seriesLegend, strokeOf } from "../maps/plots";
import type { InferenceReport } from "../page/unpacked";

const kSeries = ["posterior, fresh seeds", "prior"];

interface Bin {
  from: number;
  to: number;
  share: number;
}

export function jointFigure({ joint, claims }: InferenceReport, id: string): Child {
  if (joint.prior.sums.length === 0) return null;
  const plot = jointPlot(joint, claims.length);
  return figure({
    title: "Claims that hold together",
    file: `${id}-joint`,
    body: element("div", {}, [seriesLegend(kSeries), plot]),
    picture: () => plotPicture(plot, kSeries),
    numbers: () => jointTable(joint),
    note: "For each setting, the mean number of claims that hold in a pair of recording and seed.",
  });
}

function jointPlot(joint: InferenceReport["joint"], claims: number): HTMLElement {
  const [posterior, prior] = [binsOf(joint.fresh.sums), binsOf(joint.prior.sums)];
  const bars = (bins: Bin[], options: object) => Plot.rectY(bins, { x1: "from", x2: "to", y: "share", insetLeft: 1, ...options });
  return plotFigure("Claims that hold together", {
    height: 240,
    x: { label: `claims that hold, of ${claims}`, grid: false },
    y: { label: "share of settings", grid: true, domain: [0, greatest([...posterior, ...prior])] },
    marks: [
      bars(posterior, { fill: strokeOf(0), fillOpacity: 0.55 }),
      bars(prior, { fill: "none", stroke: strokeOf(1), strokeWidth: 2 }),
      Plot.ruleY([0]),
    ],
  });
}

function greatest(bins: readonly Bin[]): number {
  return Math.max(0.01, ...bins.map(({ share }) => share));
}

/** Bins of one claim. */
function binsOf(sums: readonly number[]): Bin[] {
  const counts = new Map<number, number>();
  for (const sum of sums) counts.set(Math.floor(sum), (counts.get(Math.floor(sum)) ?? 0) + 1);
  return [...counts].sort(([one], [other]) => one - other).map(([from, count]) => ({ from, to: from + 1, share: count / sums.length }));
}

function jointTable({ prior, fresh }: InferenceReport["joint"]): Table {
  const rows = (name: string, sums: readonly number[]) => sums.map((sum) => [name, sum]);
  return { columns: ["settings", "claims that hold"], rows: [...rows("prior", prior.sums), ...rows("posterior", fresh.sums)] };
}
