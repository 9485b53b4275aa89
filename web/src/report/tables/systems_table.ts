// A table of systems: accuracy on samples of the training and on held-out ones, and the number of
// claims that hold.

import type { Table } from "../../parts/csv";
import { breakable, element, type Child } from "../../parts/dom";
import { figure, scrolled } from "../../parts/figure";
import { hundredths } from "../../parts/numbers";
import { isOfPaper } from "./claims";
import type { Numbered } from "../page/groups";
import { mainResults, type Result } from "./main_results";
import { printedSystems, spread } from "../paper/printed";
import type { ClaimReport, ReportData, SystemReport } from "../page/unpacked";
import { protocolName, systemName } from "../page/words";

const kColumns = ["system", "runs", "training samples", "samples left out", "things left out", "claims that hold"];

export function systemsFigure(systems: Numbered[], data: ReportData, file: string): HTMLElement {
  const rows = systems.map((one) => systemRow(one, data));
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
    printed: printedSystems(systems.map(({ system }) => system)),
    wide: true,
    note: "Accuracy: mean and standard deviation over the runs; below it that of the nearest neighbour. Of several held-out protocols and labels the one with the lowest accuracy. Things left out are objects or materials that the training did not contain; another label of them is predicted.",
  });
}

function systemRow({ system, link }: Numbered, data: ReportData): HTMLElement {
  const { runs, trained, known, fresh } = mainResults(system);
  const name = element("a", { href: link }, breakable(systemName(system)));
  const cells: Child[][] = [
    [String(runs)],
    [spread(trained?.accuracy)],
    resultWords(known),
    resultWords(fresh),
    [claimsWords(claimsOf(system, data).filter(isOfPaper))],
  ];
  return element("tr", {}, [
    element("th", { scope: "row" }, [name]),
    ...cells.map((cell) => element("td", { class: "number" }, cell)),
  ]);
}

function resultWords(result: Result | null): Child[] {
  if (!result) return ["–"];
  const label = result.label === result.protocol.label ? "" : `${result.label}, `;
  const baseline = `${label}neighbour ${hundredths(result.baseline?.mean)}`;
  return [spread(result.accuracy), element("span", { class: "range", title: protocolName(result.protocol) }, [baseline])];
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
  const decided = claims.filter((claim) => claim.verdict !== "cannot be decided here").length;
  const open = claims.length - decided;
  if (decided === 0) return `${open} undecided`;
  return `${holding(claims)} of ${decided}${open > 0 ? `, ${open} undecided` : ""}`;
}

function holding(claims: ClaimReport[]): number {
  return claims.filter((claim) => claim.verdict === "holds").length;
}

function systemsTable(systems: Numbered[], data: ReportData): Table {
  const ofResult = (name: string) => [name, `${name}_sd`, `${name}_label`, `${name}_protocol`, `${name}_baseline`];
  const columns = ["system", "variation", "runs"]
    .concat(ofResult("training_samples"), ofResult("samples_left_out"), ofResult("things_left_out"))
    .concat("claims_that_hold", "claims", "file");
  const rows = systems.map(({ system }) => {
    const { runs, trained, known, fresh } = mainResults(system);
    const claims = claimsOf(system, data).filter(isOfPaper);
    const cells = [trained, known, fresh].flatMap((result) => [
      result?.accuracy.mean ?? null,
      result?.accuracy.sd ?? null,
      result?.label ?? null,
      result ? protocolName(result.protocol) : null,
      result?.baseline?.mean ?? null,
    ]);
    return [system.name, system.variation, runs, ...cells, holding(claims), claims.length, system.file];
  });
  return { columns, rows };
}
