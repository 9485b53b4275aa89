// The section of a question: a table of its systems, each of which can be opened.

import { breakable, element, type Child } from "../../parts/dom";
import { countOf } from "../../parts/numbers";
import { claimsFigure } from "../tables/claims";
import type { Question } from "./groups";
import { drawInside } from "./lazy";
import { systemParts } from "../tables/system";
import { claimsOf, systemsFigure } from "../tables/systems_table";
import type { ReportData } from "./unpacked";
import { systemName } from "./words";

export function questionSection(question: Question, data: ReportData): HTMLElement {
  const { id, name, systems } = question;
  const folds = systems.map((one) => {
    const summary = element("summary", {}, breakable(systemName(one.system)));
    const parts = systemParts(one.system, data, true);
    const fold = element("details", { class: "fold", id: one.link.slice(1) }, [
      summary,
      element("div", { class: "system" }, [parts]),
    ]);
    fold.addEventListener("toggle", () => (fold.open ? drawInside(fold) : undefined));
    return fold;
  });
  return element("section", { id, class: "question", "aria-labelledby": `${id}-title` }, [
    element("h2", { id: `${id}-title` }, [name]),
    element("p", { class: "muted lead" }, [`Question about ${countOf(systems.length, "system")}.`]),
    ...questionFigures(question, data),
    element("div", { class: "folds" }, folds),
  ]);
}

/** The tables of all systems of a question. */
export function questionFigures({ name, systems }: Question, data: ReportData): Child[] {
  const claims = systems.flatMap(({ system }) => claimsOf(system, data));
  return [
    systemsFigure(systems, data, `question-${name}`),
    claims.length === 0 ? null : claimsFigure(claims, `question-${name}-claims`, true),
  ];
}
