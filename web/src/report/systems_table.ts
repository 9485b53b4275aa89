// A table of systems: main metrics, and the number of claims that hold.

import type { Table } from "../parts/csv";
import { breakable, element, type Child } from "../parts/dom";
import { figure, scrolled } from "../parts/figure";
import { hundredths } from "../parts/numbers";
import { isOfPaper } from "./claims";
import type { ClaimReport, MetricData, ReportData, SystemReport } from "./data";
import { systemId, type Numbered } from "./groups";
import { systemName } from "./words";

const kColumns = [
  "system",
  "runs",
  "accuracy, train = test",
  "held out",
  "nearest neighbour, held out",
  "claims that hold",
];

export function systemsFigure(systems: Numbered[], data: ReportData, file: string): HTMLElement {
  const rows = systems.map(({ system, index }) => systemRow(system, index, data));
  const head = kColumns.map((name, i) =>
    element("th", { scope: "col", class: i > 0 ? "number" : "" }, [name]),
  );
  const table = element("table", { class: "wide-table" }, [
    element("thead", {}, [element("tr", {}, head)]),
    element("tbody", {}, rows),
  ]);
  return figure({
    title: "Systems",
    file,
    body: scrolled("Systems", table),
    numbers: () => systemsTable(systems, data),
    wide: true,
    note: "Mean ± standard deviation over the seeds. Held out: the first protocol with separate test data. Claims: only those of papers.",
  });
}

function systemRow(system: SystemReport, index: number, data: ReportData): HTMLElement {
  const main = mainFigures(system);
  const link = element("a", { href: `#${systemId(index)}` }, breakable(systemName(system)));
  const cells: Child[] = [
    String(main.runs),
    spread(main.trained),
    spread(main.heldOut),
    spread(main.baseline),
    claimsWords(claimsOf(system, data).filter(isOfPaper)),
  ];
  return element("tr", {}, [
    element("th", { scope: "row" }, [link]),
    ...cells.map((cell) => element("td", { class: "number" }, [cell])),
  ]);
}

export function claimsOf(system: SystemReport, data: ReportData): ClaimReport[] {
  return data.claims.filter((claim) => {
    const isOfFile =
      (claim.file ?? system.file) === system.file && (claim.question ?? "") === system.question;
    return isOfFile && claim.system === system.name && claim.variation === system.variation;
  });
}

function claimsWords(claims: ClaimReport[]): string {
  if (claims.length === 0) return "–";
  return `${holding(claims)} of ${claims.length}`;
}

function holding(claims: ClaimReport[]): number {
  return claims.filter((claim) => claim.verdict === "holds").length;
}

interface MainFigures {
  runs: number;
  trained: MetricData | undefined;
  heldOut: MetricData | undefined;
  baseline: MetricData | undefined;
}

function mainFigures(system: SystemReport): MainFigures {
  const trained = system.protocols.find((one) => one.protocol === "train_is_test");
  const heldOut = system.protocols.find((one) => one.protocol !== "train_is_test");
  return {
    runs: Math.max(0, ...system.protocols.map((one) => one.runs.length)),
    trained: trained?.metrics["accuracy"],
    heldOut: heldOut?.metrics["accuracy"],
    baseline: heldOut?.metrics["baseline_accuracy"],
  };
}

/** "0.85 ± 0.07"; a single run has no spread. */
function spread(metric: MetricData | undefined): string {
  if (!metric) return "–";
  const mean = hundredths(metric.mean);
  return metric.values?.length === 1 ? mean : `${mean} ± ${hundredths(metric.sd)}`;
}

function systemsTable(systems: Numbered[], data: ReportData): Table {
  const columns = [
    "system",
    "variation",
    "runs",
    "accuracy_train_is_test",
    "accuracy_train_is_test_sd",
    "accuracy_held_out",
    "accuracy_held_out_sd",
    "baseline_accuracy_held_out",
    "claims_that_hold",
    "claims",
    "file",
  ];
  const rows = systems.map(({ system }) => {
    const main = mainFigures(system);
    const claims = claimsOf(system, data).filter(isOfPaper);
    return [
      system.name,
      system.variation,
      main.runs,
      main.trained?.mean ?? null,
      main.trained?.sd ?? null,
      main.heldOut?.mean ?? null,
      main.heldOut?.sd ?? null,
      main.baseline?.mean ?? null,
      holding(claims),
      claims.length,
      system.file,
    ];
  });
  return { columns, rows };
}
