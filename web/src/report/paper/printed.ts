// The tables of a paper: the same results as on the page, in words and few columns.

import type { Cell } from "../../parts/csv";
import type { Printed } from "../../parts/figure";
import { hundredths, median, percent, readable } from "../../parts/numbers";
import type { Strip } from "../moments/strips";
import type { Selection } from "../page/selection";
import type { ClaimReport, MetricData, SystemReport } from "../page/unpacked";
import { systemName } from "../page/words";
import { valuesOf } from "../tables/labels";
import { mainResults, type Result } from "../tables/main_results";

/** A row for each kind of test of a system. */
export function printedSystems(systems: SystemReport[]): Printed {
  const columns = ["System", "Tested on", "Accuracy", "Nearest neighbour", "Chance", "Samples", "Runs"];
  return {
    table: () => ({ columns, rows: systems.flatMap(systemRows) }),
    note: "Accuracy: mean and standard deviation over the runs. Chance: the share of the most frequent class, which an answer that is always the same reaches.",
  };
}

function systemRows(system: SystemReport): Cell[][] {
  const { runs, trained, known, fresh } = mainResults(system);
  const row = (tested: string, result: Result | null): Cell[][] => {
    if (!result) return [];
    const { label, accuracy, baseline, protocol } = result;
    const by = label === protocol.label ? tested : `${tested}, by ${inWords(label)}`;
    const chance = hundredths(chanceOf(system, result));
    return [[inWords(systemName(system)), by, spread(accuracy), spread(baseline), chance, protocol.samples, runs]];
  };
  const things = inWords(fresh?.protocol.group ?? "thing");
  const rows = [
    ...row("training samples", trained),
    ...row("samples left out", known),
    ...row(`each ${things} left out`, fresh),
  ];
  return rows.length > 0 ? rows : [[inWords(systemName(system)), "–", "–", "–", "–", null, runs]];
}

/** The share of the most frequent class in the first run; null if the classes are unknown. */
function chanceOf(system: SystemReport, { protocol, label }: Result): number | null {
  const [run] = protocol.runs;
  const values = run ? valuesOf(system, protocol, run, label) : null;
  if (!values || values.length === 0) return null;
  const counts = new Map<string, number>();
  for (const value of values) counts.set(value, (counts.get(value) ?? 0) + 1);
  return Math.max(...counts.values()) / values.length;
}

export function printedClaims(claims: ClaimReport[]): Printed {
  const columns = ["Claim", "Source", "Published", "Here", "By chance", "Holds in"];
  const rows = () =>
    claims.map((claim) => [
      claim.text,
      claim.paper || "ours",
      readable(claim.published),
      spanWords(claim.values),
      readable(claim.by_chance),
      percent(claim.share),
    ]);
  return {
    table: () => ({ columns, rows: rows() }),
    note: "Here: median, minimum and maximum over the runs. By chance: the mean for wrong groupings. Holds in: the share of the runs in which the claim holds.",
  };
}

function spanWords(values: readonly (number | null)[]): string {
  const [middle, range] = spanOf(values);
  return range === "" ? middle : `${middle} (${range})`;
}

/** The median, and the range from the minimum to the maximum unless they are equal. */
export function spanOf(values: readonly (number | null)[]): [median: string, range: string] {
  const sorted = values.filter((value) => value !== null).sort((one, other) => one - other);
  const [low, high] = [sorted[0], sorted.at(-1)];
  return [readable(median(sorted)), low === high ? "" : `${readable(low)} to ${readable(high)}`];
}

/** The metrics of the selected protocol. */
export function printedOutcomes(selection: Selection, strips: () => Strip[]): Printed {
  const columns = ["Metric", "Here", "Nearest neighbour", "By chance", "Published"];
  const rowOf = ({ metric, name, baseline, chance, published }: Strip): Cell[] => [
    name,
    spread(selection.protocol?.metrics[metric]),
    hundredths(baseline),
    hundredths(meanOf(chance)),
    readable(published),
  ];
  return {
    table: () => ({ columns, rows: strips().map(rowOf) }),
    note: "Here: mean and standard deviation over the runs. By chance: the mean for wrong groupings.",
  };
}

function meanOf(all: readonly (number | null)[]): number | null {
  const values = all.filter((value) => value !== null);
  return values.length === 0 ? null : values.reduce((sum, value) => sum + value, 0) / values.length;
}

/** Rows of a part, a name, a value in TOML notation and its meaning. */
export function printedSettings(settings: string[][], note: string): Printed {
  const columns = ["Module", "Setting", "Value", "Meaning"];
  const rows = settings.map(([part = "", name = "", value = "", text = ""]) => [
    inWords(part.replace(/^module\./, "")),
    inWords(name),
    unquoted(value),
    text,
  ]);
  return { table: () => ({ columns, rows }), note };
}

/** "0.85 ± 0.07"; a single run has no spread. */
export function spread(metric: MetricData | undefined): string {
  if (!metric) return "–";
  const mean = hundredths(metric.mean);
  return metric.values?.length === 1 || metric.mean === null ? mean : `${mean} ± ${hundredths(metric.sd)}`;
}

/** A name such as "block_1" as it is read. */
export function inWords(name: string): string {
  return name.replaceAll("_", " ");
}

/** A value in TOML notation without the quotation marks of texts. */
export function unquoted(value: string): string {
  return value.replaceAll('"', "");
}
