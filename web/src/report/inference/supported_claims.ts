// The claims of an inference: in how many maps of the prior and of the posterior they hold, and which
// of them exclude each other.

import { element, type Child } from "../../parts/dom";
import { figure } from "../../parts/figure";
import { countOf, fixed, percent, readable } from "../../parts/numbers";
import type { ConflictData, InferenceReport, SupportedClaim, TargetData } from "../page/unpacked";
import type { VerdictKind } from "../page/words";
import { boundWords } from "../tables/claims";
import { savedTable, shownTable, type Column } from "./columns";
import { claimWords } from "./names";

type Support = SupportedClaim["support"];

const kSupports: [support: Support, kind: VerdictKind][] = [
  ["explained", "good"],
  ["reachable", "middling"],
  ["excluded", "bad"],
  ["not decided", "neutral"],
];

/** How many claims have each support. */
export function supportTiles({ claims }: InferenceReport): Child {
  if (claims.length === 0) return null;
  const counted = kSupports.flatMap(([support, kind]) => {
    const count = claims.filter((claim) => claim.support === support).length;
    if (count === 0) return [];
    return [element("div", { class: `tile ${kind}` }, [element("strong", {}, [String(count)]), element("span", {}, [support])])];
  });
  const label = `Of ${countOf(claims.length, "claim")}`;
  return element("div", { class: "tiles", role: "group", "aria-label": label }, [element("p", {}, [label]), ...counted]);
}

export function supportedFigure({ claims }: InferenceReport, id: string): Child {
  if (claims.length === 0) return null;
  return figure({
    title: "Claims of the inference",
    file: `${id}-claims`,
    body: shownTable("Claims of the inference", kClaims, claims),
    numbers: () => savedTable(kClaims, claims),
    printed: { table: () => savedTable(kClaims.slice(0, kPrintedColumns), claims), note: kClaimsNote },
    note: kClaimsNote,
    wide: true,
  });
}

const kClaimsNote =
  "Shares of maps in which a claim holds. Prior: all draws. Fresh: settings of the posterior with other seeds. Without it: of draws that are accepted without the observed values of its own measure. By chance: wrong groupings of the fresh maps. Explained: at least 90 % of the fresh maps, and less than 90 % by chance.";

const kPrintedColumns = 7;

const kClaims: Column<SupportedClaim>[] = [
  {
    name: "claim",
    value: claimWords,
    shown: (claim) => [claim.text, element("span", { class: "measured" }, [measured(claim)])],
    kind: "claim",
  },
  { name: "prior", value: ({ prior }) => prior, shown: (claim) => [shareBar(claim.prior, claim.support)] },
  share("fresh", ({ fresh }) => fresh),
  share("without it", ({ left_out: one }) => one),
  share("by chance", ({ fresh_chance: one }) => one),
  { name: "support", value: ({ support }) => support, shown: ({ support }) => [supportWords(support)] },
  {
    name: "verdict, fresh",
    value: ({ fresh_verdict: verdict }) => verdict,
    shown: (claim) => [claim.fresh_verdict ?? "–", ...writtenWords(claim)],
  },
  { name: "verdict as written", value: ({ fresh_verdict_as_written: verdict }) => verdict },
  { name: "paper", value: ({ paper }) => paper, shown: ({ paper }) => [paper || "ours"] },
  { name: "metric", value: ({ metric }) => metric },
  { name: "published", value: ({ published }) => published },
  { name: "at_least", value: ({ at_least: bound }) => bound },
  { name: "at_most", value: ({ at_most: bound }) => bound },
  { name: "by chance, prior", value: ({ chance }) => chance },
];

function share(name: string, of: (claim: SupportedClaim) => number | null): Column<SupportedClaim> {
  return { name, value: of, shown: (claim) => [percent(of(claim))], kind: "number" };
}

function measured(claim: SupportedClaim): string {
  return claimWords({ ...claim, text: `${claim.metric} ${boundWords(claim)}` });
}

function writtenWords({ fresh_verdict: first, fresh_verdict_as_written: second }: SupportedClaim): Child[] {
  if (second === null || second === first) return [];
  return [element("span", { class: "range" }, [`as written: ${second}`])];
}

function kindOf(support: Support): VerdictKind {
  return kSupports.find(([name]) => name === support)?.[1] ?? "neutral";
}

function supportWords(support: Support): HTMLElement {
  return element("span", { class: `support ${kindOf(support)}` }, [support]);
}

/** A bar with the share, of the colour of the support that stands beside it in words. */
function shareBar(prior: number | null, support: Support): HTMLElement {
  const filled = element("span", { class: "filled", style: `width:${Math.round(100 * (prior ?? 0))}%` });
  return element("span", { class: `share ${kindOf(support)}` }, [
    element("span", { class: "bar", "aria-hidden": "true" }, [filled]),
    element("span", { class: "words" }, [percent(prior)]),
  ]);
}

export function targetsFigure({ targets }: InferenceReport, id: string): HTMLElement {
  return figure({
    title: "Observed values",
    file: `${id}-targets`,
    body: shownTable("Observed values", kTargets, targets),
    numbers: () => savedTable(kTargets, targets),
    note: "Means over all maps of the prior, and over the accepted maps. The scale is the difference that counts as 1.",
    wide: true,
  });
}

const kTargets: Column<TargetData>[] = [
  { name: "value", value: ({ text }) => text, shown: (target) => [target.text, element("span", { class: "measured" }, [measuredOf(target)])], kind: "claim" },
  { name: "system", value: ({ system }) => system },
  { name: "variation", value: ({ variation }) => variation },
  { name: "metric", value: ({ metric }) => metric },
  number("observed", ({ observed }) => observed),
  number("prior", ({ prior }) => prior),
  number("accepted", ({ posterior }) => posterior),
  number("scale", ({ scale }) => scale),
  { name: "paper", value: ({ paper }) => paper, shown: ({ paper }) => [paper] },
];

function measuredOf(target: TargetData): string {
  return claimWords({ ...target, text: target.metric });
}

function number(name: string, of: (target: TargetData) => number): Column<TargetData> {
  return { name, value: of, shown: (target) => [readable(of(target))], kind: "number" };
}

export function conflictsFigure({ conflicts }: InferenceReport, id: string): HTMLElement {
  return figure({
    title: "Conflicts between claims",
    file: `${id}-conflicts`,
    body:
      conflicts.length > 0
        ? shownTable("Conflicts between claims", kConflicts, conflicts)
        : element("p", {}, ["No two claims hold together less often than expected, by more than three standard deviations."]),
    numbers: () => savedTable(kConflicts, conflicts),
    note: "Numbers of maps of the prior in which both claims hold, and which their own shares let expect.",
  });
}

const kConflicts: Column<ConflictData>[] = [
  { name: "claim", value: ({ first }) => claimWords(first), shown: ({ first }) => [claimWords(first)], kind: "claim" },
  { name: "other", value: ({ second }) => claimWords(second), shown: ({ second }) => [claimWords(second)], kind: "claim" },
  { name: "together", value: ({ together }) => together, shown: ({ together }) => [readable(together)], kind: "number" },
  { name: "expected", value: ({ expected }) => expected, shown: ({ expected }) => [fixed(expected, 0)], kind: "number" },
  { name: "deviations", value: ({ deviations }) => deviations, shown: ({ deviations }) => [fixed(deviations, 1)], kind: "number" },
];
