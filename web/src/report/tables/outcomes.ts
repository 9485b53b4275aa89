// The results over the seeds, compared with the paper, the nearest neighbour and wrong groupings.

import type { Table } from "../../parts/csv";
import { element } from "../../parts/dom";
import type { Shown } from "../../parts/figure";
import { countOf } from "../../parts/numbers";
import type { ClaimReport, MetricData, ProtocolData, SystemReport } from "../page/unpacked";
import { classesOf } from "./labels";
import { printedOutcomes } from "../paper/printed";
import { liveFigure, nothing, type Drawn } from "../maps/live_figure";
import { nameOf, shownOf } from "../page/origin";
import type { Selection } from "../page/selection";
import { stripsPicture, type Strip } from "../moments/strips";
import { metricName, metricRange, protocolName, splitMetric, systemName } from "../page/words";

export function outcomesFigure(selection: Selection, claims: ClaimReport[]): HTMLElement {
  const { system } = selection;
  const hasSeveral = system.protocols.some(({ runs }) => runs.length > 1);
  const options = {
    title: "Outcomes",
    file: `${systemName(system)}-outcomes`,
    note: hasSeveral
      ? "Each dot is a run; equal runs share one dot whose area is proportional to their number. The vertical line is the median."
      : "",
    wide: true,
    about: () => shown(selection),
    printed: printedOutcomes(selection, () => stripsOfSelection(selection, claims)),
  };
  return liveFigure(options, selection, () => draw(selection, claims));
}

function shown(selection: Selection): Shown {
  const { system, protocol, label } = selection;
  if (!protocol) return shownOf(system);
  const runs = countOf(protocol.runs.length, "run");
  const words = `${protocolName(protocol)}, ${label}, ${runs} of ${countOf(protocol.samples, "sample")}`;
  return shownOf(system, words, nameOf(selection, [label]));
}

function draw(selection: Selection, claims: ClaimReport[]): Drawn {
  const { protocol, label } = selection;
  if (!protocol) return nothing("There are no protocols.");
  const strips = stripsOfSelection(selection, claims);
  if (strips.length === 0) return nothing(`There are no metrics for the label ${label} under this protocol.`);
  const { words } = shown(selection);
  const picture = stripsPicture(strips, `Outcomes: ${words}`);
  const seeds = protocol.runs.map((run) => run.seed);
  return {
    body: [element("p", { class: "small what" }, [words]), picture],
    svg: picture,
    table: stripsTable(strips, seeds),
  };
}

const kBeside = /^baseline_|_chance$/;

function stripsOfSelection({ system, protocol, label }: Selection, claims: ClaimReport[]): Strip[] {
  return protocol ? stripsOf(system, protocol, label, claims) : [];
}

function stripsOf(
  system: SystemReport,
  protocol: ProtocolData,
  label: string,
  claims: ClaimReport[],
): Strip[] {
  const prefix = label === protocol.label ? "" : label;
  const classes = classesOf(system, label).length;
  return Object.entries(protocol.metrics).flatMap(([metric, data]) => {
    const [own, name] = splitMetric(metric);
    if (own !== prefix || kBeside.test(name)) return [];
    return [stripOf(protocol, metric, data, metricRange(metric, protocol.samples, classes), claims)];
  });
}

function stripOf(
  protocol: ProtocolData,
  metric: string,
  data: MetricData,
  range: [number, number] | null,
  claims: ClaimReport[],
): Strip {
  const [prefix, name] = splitMetric(metric);
  const other = (own: string) => protocol.metrics[prefix === "" ? own : `${prefix}.${own}`];
  const claim = claims.find((one) => one.metric === metric && one.than === "" && isOf(one, protocol));
  return {
    metric,
    name: metricName(metric),
    values: data.values,
    chance: other(`${name}_chance`)?.values ?? [],
    baseline: name === "accuracy" ? (other("baseline_accuracy")?.mean ?? null) : null,
    published: claim?.published ?? null,
    range,
  };
}

function isOf(claim: ClaimReport, protocol: ProtocolData): boolean {
  const of = claim.protocol === "" ? "train_is_test" : claim.protocol;
  return of === protocol.protocol && (claim.group || "") === (protocol.group ?? "");
}

function stripsTable(strips: Strip[], seeds: number[]): Table {
  const rows = strips.flatMap((strip) => [
    ...strip.values.map((value, i) => [strip.metric, "here", seeds[i] ?? null, value]),
    ...strip.chance.map((value, i) => [strip.metric, "by chance", seeds[i] ?? null, value]),
    ...(strip.baseline === null ? [] : [[strip.metric, "nearest neighbour", null, strip.baseline]]),
    ...(strip.published === null ? [] : [[strip.metric, "paper", null, strip.published]]),
  ]);
  return { columns: ["metric", "what", "seed", "value"], rows };
}
