// What was found, at a glance: every system with its main figures and how its claims hold.

import { element, type Child } from "../parts/dom";
import type { ReportData } from "./data";
import { questionsOf, standing } from "./groups";
import { systemsFigure } from "./systems_table";
import { countOf, holds } from "./words";

export function overviewSection(data: ReportData): HTMLElement {
  const systems = standing(data);
  const questions = questionsOf(data).length;
  const counts = [
    countOf(systems.length, "system"),
    ...(questions > 0 ? [countOf(questions, "question")] : []),
    ...(data.claims.length > 0 ? [countOf(data.claims.length, "claim")] : []),
  ];
  return element("section", { id: "overview", class: "overview", "aria-labelledby": "overview-title" }, [
    element("header", { class: "title" }, [
      element("h1", { id: "overview-title" }, ["What the hands felt, and what the maps made of it"]),
      element("p", { class: "muted" }, [`${counts.join(", ")}. Written by Somato ${data.somato}.`]),
    ]),
    ...summary(data),
    data.systems.length === 0
      ? element("p", { class: "message" }, [
          "No results were given, so there is no system to show. Name one or more results.json: somato report RESULTS.json -o report.html",
        ])
      : systems.length > 0
        ? systemsFigure(systems, data, "somato-systems")
        : null,
  ]);
}

function summary(data: ReportData): Child[] {
  const shares = data.claims.filter((claim) => claim.paper !== "").map((claim) => claim.share);
  if (shares.length === 0) return [];
  const count = (kind: string) => shares.filter((share) => holds(share).kind === kind).length;
  const tile = (kind: "good" | "middling" | "bad", words: string) =>
    element("div", { class: `tile ${kind}` }, [
      element("strong", {}, [String(count(kind))]),
      element("span", {}, [words]),
    ]);
  const tiles = [
    tile("good", "hold in at least 95 % of the runs"),
    tile("middling", "hold in some runs"),
    tile("bad", "hold in at most 5 %"),
  ];
  const label = `Of ${countOf(shares.length, "claim")} of the papers`;
  return [
    element("div", { class: "tiles", role: "group", "aria-label": label }, [
      element("p", {}, [label]),
      ...tiles,
    ]),
  ];
}
