// Overview of the results: every system with its main metrics and the verdicts of its claims.

import { element, type Child } from "../parts/dom";
import { countOf } from "../parts/numbers";
import { isOfPaper } from "./claims";
import type { ReportData } from "./data";
import { questionsOf, standing } from "./groups";
import { systemsFigure } from "./systems_table";
import { kVerdicts } from "./words";

export function overviewSection(data: ReportData): HTMLElement {
  const systems = standing(data);
  const questions = questionsOf(data).length;
  const claims = data.claims.filter(isOfPaper).length;
  const counts = [
    countOf(systems.length, "system"),
    ...(questions > 0 ? [countOf(questions, "question")] : []),
    ...(claims > 0 ? [countOf(claims, "claim")] : []),
  ];
  return element("section", { id: "overview", class: "overview", "aria-labelledby": "overview-title" }, [
    element("header", { class: "title" }, [
      element("h1", { id: "overview-title" }, ["Results"]),
      element("p", { class: "muted" }, [`${counts.join(", ")}. Written by Somato ${data.somato}.`]),
    ]),
    ...summary(data),
    data.systems.length === 0
      ? element("p", { class: "message" }, [
          "No results were given. Name one or more results.json: somato report RESULTS.json -o report.html",
        ])
      : systems.length > 0
        ? systemsFigure(systems, data, "somato-systems")
        : null,
  ]);
}

function summary(data: ReportData): Child[] {
  const claims = data.claims.filter(isOfPaper);
  if (claims.length === 0) return [];
  const tiles = kVerdicts.map(([verdict, kind]) => {
    const count = claims.filter((claim) => claim.verdict === verdict).length;
    return element("div", { class: `tile ${kind}` }, [
      element("strong", {}, [String(count)]),
      element("span", {}, [verdict]),
    ]);
  });
  const label = `Of ${countOf(claims.length, "claim")} of the papers`;
  return [
    element("div", { class: "tiles", role: "group", "aria-label": label }, [
      element("p", {}, [label]),
      ...tiles,
    ]),
  ];
}
