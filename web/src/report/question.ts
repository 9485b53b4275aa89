// The section of a question: a table of its systems, each of which can be opened.

import { breakable, element } from "../parts/dom";
import { countOf } from "../parts/numbers";
import { claimsFigure } from "./claims";
import type { ReportData } from "./data";
import type { Question } from "./groups";
import { drawInside } from "./lazy";
import { claimsOf, systemsFigure } from "./systems_table";
import { systemSection } from "./system";
import { systemName } from "./words";

export function questionSection(question: Question, data: ReportData): HTMLElement {
  const { id, name, systems } = question;
  const claims = systems.flatMap(({ system }) => claimsOf(system, data));
  const folds = systems.map(({ system, index }) => {
    const summary = element("summary", {}, breakable(systemName(system)));
    const fold = element("details", { class: "fold" }, [summary, systemSection(system, index, data)]);
    fold.addEventListener("toggle", () => (fold.open ? drawInside(fold) : undefined));
    return fold;
  });
  return element("section", { id, class: "question", "aria-labelledby": `${id}-title` }, [
    element("h2", { id: `${id}-title` }, [name]),
    element("p", { class: "muted lead" }, [`Question about ${countOf(systems.length, "system")}.`]),
    systemsFigure(systems, data, `question-${name}`),
    claims.length === 0 ? null : claimsFigure(claims, `question-${name}-claims`, true),
    element("div", { class: "folds" }, folds),
  ]);
}
