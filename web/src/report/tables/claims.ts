// The claims of the papers, and how often each holds.

import type { Table } from "../../parts/csv";
import { breakable, element, type Child } from "../../parts/dom";
import { figure, scrolled } from "../../parts/figure";
import { countOf, percent, readable } from "../../parts/numbers";
import type { ClaimReport, ReportData } from "../page/unpacked";
import type { Placed } from "../page/same_names";
import { printedClaims, spanOf } from "../paper/printed";
import { kindOf, kVerdicts } from "../page/words";

/** The claims, and how many of those of papers have each verdict. */
export function claimsSection(data: ReportData): HTMLElement {
  return element("section", { id: "claims", "aria-labelledby": "claims-title" }, [
    element("h2", { id: "claims-title" }, ["Claims"]),
    element("p", { class: "muted lead" }, [
      "The papers trained each system once and interpreted a figure. Here each claim is a measured number, evaluated for every run.",
    ]),
    ...tiles(data.claims.filter(isOfPaper)),
    claimsFigure(data.claims, "claims-results", true),
  ]);
}

function tiles(claims: ClaimReport[]): Child[] {
  if (claims.length === 0) return [];
  const counted = kVerdicts.flatMap(([verdict, kind]) => {
    const count = claims.filter((claim) => claim.verdict === verdict).length;
    if (count === 0) return [];
    const number = element("strong", {}, [String(count)]);
    return [element("div", { class: `tile ${kind}` }, [number, element("span", {}, [verdict])])];
  });
  const label = `Of ${countOf(claims.length, "claim")} of the papers`;
  return [element("div", { class: "tiles", role: "group", "aria-label": label }, [element("p", {}, [label]), ...counted])];
}

export function claimsFigure(claims: ClaimReport[], file: string, hasSystem: boolean): HTMLElement {
  const head = kColumns.map((name) =>
    element("th", { scope: "col", class: kNumbers.has(name) ? "number" : "" }, [name]),
  );
  const table = element("table", { class: "wide-table" }, [
    element("thead", {}, [element("tr", {}, head)]),
    ...bodies(claims.filter(isOfPaper), hasSystem),
    ...ownBodies(claims.filter((claim) => !isOfPaper(claim)), hasSystem),
  ]);
  return figure({
    title: "Results of the claims",
    file,
    body: scrolled("Claims", table),
    numbers: () => claimsTable(claims),
    printed: printedClaims(claims),
    note: "Here: median, minimum and maximum over the runs. By chance: the mean for wrong groupings, and how many of them meet the claim.",
    wide: true,
  });
}

export function isOfPaper(claim: ClaimReport): boolean {
  return claim.paper !== "";
}

function bodies(claims: ClaimReport[], hasSystem: boolean): HTMLElement[] {
  return hasSystem ? bodiesBySystem(claims) : [element("tbody", {}, claims.map(claimRow))];
}

/** The claims that are not from a paper, listed separately. */
function ownBodies(claims: ClaimReport[], hasSystem: boolean): HTMLElement[] {
  if (claims.length === 0) return [];
  const title = element("th", { scope: "rowgroup", colspan: kColumns.length, class: "own" }, [
    "Additional comparisons",
  ]);
  return [element("tbody", {}, [element("tr", {}, [title])]), ...bodies(claims, hasSystem)];
}

/** The claims of each system below its name. */
function bodiesBySystem(claims: ClaimReport[]): HTMLElement[] {
  const groups = new Map<string, ClaimReport[]>();
  for (const claim of claims) {
    const name = claimedSystem(claim);
    groups.set(name, [...(groups.get(name) ?? []), claim]);
  }
  return [...groups].map(([name, own]) => {
    const title = element(
      "th",
      { scope: "rowgroup", colspan: kColumns.length, class: "group" },
      breakable(name),
    );
    return element("tbody", {}, [element("tr", {}, [title]), ...own.map(claimRow)]);
  });
}

function claimedSystem({ system, variation, question, place }: Placed<ClaimReport>): string {
  const ofQuestion = question ? ` (${question.replaceAll("_", " ")})` : "";
  const of = place === undefined ? "" : ` (${place})`;
  return `${variation === "" ? system : `${system}, ${variation}`}${ofQuestion}${of}`;
}

const kColumns = ["claim", "paper", "published", "here", "by chance", "holds in"];
const kNumbers = new Set(["published", "here", "by chance"]);

function claimRow(claim: ClaimReport): HTMLElement {
  const measured = [claim.metric, boundWords(claim), claim.protocol.replaceAll("_", " "), claim.group]
    .filter((words) => words !== "")
    .join(" ");
  return element("tr", {}, [
    element("td", { class: "claim" }, [claim.text, element("span", { class: "measured" }, [measured])]),
    element("td", { class: "paper" }, [claim.paper || "ours"]),
    element("td", { class: "number" }, [readable(claim.published)]),
    element("td", { class: "number" }, hereWords(claim.values)),
    element("td", { class: "number" }, chanceWords(claim)),
    element("td", {}, [shareBar(claim), ...secondWords(claim)]),
  ]);
}

/** The second measure, and the figure that contradicts the claim. */
function secondWords({ as_written: second, contradicted_by: figure }: ClaimReport): Child[] {
  const lines = second ? [`as written: ${second.verdict}`, second.reason, second.summary] : [];
  const words = [lines.filter((line) => line !== "").join("; "), figure ? `contradicted by ${figure}` : ""];
  return words.filter((line) => line !== "").map((line) => element("span", { class: "measured" }, [line]));
}

/** The bounds of a claim, and what is subtracted before they are compared. */
export function boundWords(claim: Pick<ClaimReport, "metric" | "than" | "than_metric" | "at_least" | "at_most">): string {
  const subtracted = claim.than_metric === claim.metric ? "that" : claim.than_metric;
  const less = claim.than === "" ? "" : `minus ${subtracted} of ${claim.than} `;
  if (claim.at_least !== null && claim.at_most !== null) {
    return `${less}between ${readable(claim.at_least)} and ${readable(claim.at_most)}`;
  }
  const least = claim.at_least === null ? "" : `≥ ${readable(claim.at_least)}`;
  const most = claim.at_most === null ? "" : `≤ ${readable(claim.at_most)}`;
  return less + least + most;
}

function hereWords(values: (number | null)[]): Child[] {
  const [middle, range] = spanOf(values);
  return range === "" ? [middle] : [middle, element("span", { class: "range" }, [range])];
}

function chanceWords({ by_chance, chance_share }: ClaimReport): Child[] {
  if ((chance_share ?? null) === null) return [readable(by_chance)];
  return [readable(by_chance), element("span", { class: "range" }, [`met by ${percent(chance_share)}`])];
}

/** A bar with words, so that the verdict is not shown by colour only. */
function shareBar({ share, verdict, reason }: ClaimReport): HTMLElement {
  const filled = element("span", { class: "filled", style: `width:${Math.round(100 * (share || 0))}%` });
  const words = [percent(share), verdict, reason].filter((part) => (part ?? "") !== "");
  return element("span", { class: `share ${kindOf(verdict)}` }, [
    element("span", { class: "bar", "aria-hidden": "true" }, [filled]),
    element("span", { class: "words" }, [words.join(", ")]),
  ]);
}

function claimsTable(claims: ClaimReport[]): Table {
  const columns = [
    "file",
    "question",
    "system",
    "variation",
    "claim",
    "paper",
    "metric",
    "protocol",
    "group",
    "than",
    "than_metric",
    "published",
    "at_least",
    "at_most",
    "by_chance",
    "chance_share",
    "verdict",
    "reason",
    "share",
    "as_written",
    "as_written_summary",
    "contradicted_by",
    "values",
  ];
  const rows = claims.map((claim) => [
    claim.file ?? null,
    claim.question ?? null,
    claim.system,
    claim.variation,
    claim.text,
    claim.paper,
    claim.metric,
    claim.protocol,
    claim.group,
    claim.than,
    claim.than_metric,
    claim.published,
    claim.at_least,
    claim.at_most,
    claim.by_chance,
    claim.chance_share ?? null,
    claim.verdict ?? null,
    claim.reason ?? null,
    claim.share,
    claim.as_written?.verdict ?? null,
    claim.as_written?.summary ?? null,
    claim.contradicted_by ?? null,
    claim.values.join(" "),
  ]);
  return { columns, rows };
}
