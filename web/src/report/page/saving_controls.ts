// Options of all saved figures, and how to cite the program.

import { choice } from "../../parts/controls";
import { element, uniqueId } from "../../parts/dom";
import { kSaving, saveFile } from "../../parts/save";
import { asLatex } from "../paper/cited_text";
import { methodsOf } from "../paper/methods";
import { bibtex } from "../paper/references";
import type { ReportData } from "./unpacked";

const kWidths: [name: string, width: number | null][] = [
  ["as shown", null],
  ["85 mm", 85],
  ["120 mm", 120],
  ["180 mm", 180],
];

export function savingControls(data: ReportData): HTMLElement {
  const widths = choice("Width", kWidths.map(([name]) => name), 0, (index) => {
    kSaving.width = kWidths[index]?.[1] ?? null;
  });
  const id = uniqueId("caption");
  const caption = element("input", { type: "checkbox", id });
  caption.checked = kSaving.hasCaption;
  caption.addEventListener("change", () => {
    kSaving.hasCaption = caption.checked;
  });
  const saver = (name: string, file: string, text: () => string) =>
    element("button", { type: "button", class: "quiet", onclick: () => saveText(file, text()) }, [name]);
  const cite = saver("BibTeX", "references.bib", () => bibtex(data));
  const methods = saver("Methods", "methods.tex", () => asLatex(methodsOf(data)));
  return element("div", { class: "saving small" }, [
    element("p", { class: "list-title" }, ["Saved figures"]),
    widths.element,
    element("span", { class: "control" }, [caption, element("label", { for: id }, ["Title and caption"])]),
    element("p", { class: "muted version" }, ["Save ", cite, methods]),
    element("p", { class: "muted version" }, [`Somato ${data.somato}`]),
  ]);
}

function saveText(file: string, text: string): void {
  saveFile(file, new Blob([text], { type: "text/plain" }));
}
