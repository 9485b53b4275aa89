// Options of all saved figures, and how to cite the program.

import { choice } from "../../parts/controls";
import { element, uniqueId } from "../../parts/dom";
import { kSaving, saveFile } from "../../parts/save";

const kWidths: [name: string, width: number | null][] = [
  ["as shown", null],
  ["85 mm", 85],
  ["120 mm", 120],
  ["180 mm", 180],
];

export function savingControls(version: string): HTMLElement {
  const widths = choice("Width", kWidths.map(([name]) => name), 0, (index) => {
    kSaving.width = kWidths[index]?.[1] ?? null;
  });
  const id = uniqueId("caption");
  const caption = element("input", { type: "checkbox", id });
  caption.checked = kSaving.hasCaption;
  caption.addEventListener("change", () => {
    kSaving.hasCaption = caption.checked;
  });
  const cite = element("button", { type: "button", class: "quiet", onclick: () => saveBibtex(version) }, ["BibTeX"]);
  return element("div", { class: "saving small" }, [
    element("p", { class: "list-title" }, ["Saved figures"]),
    widths.element,
    element("span", { class: "control" }, [caption, element("label", { for: id }, ["Title and caption"])]),
    element("p", { class: "muted version" }, [`Somato ${version} `, cite]),
  ]);
}

function saveBibtex(version: string): void {
  saveFile("somato.bib", new Blob([bibtex(version)], { type: "text/plain" }));
}

/** As CITATION.cff has it. */
export function bibtex(version: string): string {
  return [
    "@software{somato,",
    "  author = {{Somato contributors}},",
    "  title = {Somato: a self-organizing sense of touch for robots},",
    `  version = {${version}},`,
    "  license = {Apache-2.0},",
    "}",
    "",
  ].join("\n");
}
