// Tables of the settings not given in the papers, of missing data, and of all settings.

import { element, type Child } from "../../parts/dom";
import { figure, scrolled } from "../../parts/figure";
import type { SystemReport } from "../page/unpacked";
import { systemName } from "../page/words";
import { printedSettings } from "../paper/printed";

export function notGivenFigure(system: SystemReport): Child {
  const rows = system.not_given.map((one) => [one.part, one.name, one.value, withoutRemark(one.text)]);
  const note = "The papers do not specify these settings. Their values are assumptions.";
  return figure({
    title: "Values of these settings",
    file: `${systemName(system)}-not-given`,
    body: plainTable("Not given", ["module", "setting", "value", "meaning"], rows, 3),
    numbers: () => ({ columns: ["part", "setting", "value", "text"], rows }),
    printed: printedSettings(rows, note),
    note,
    wide: true,
  });
}

/** The heading states for all settings that they are not given. */
function withoutRemark(text: string): string {
  return text.replace(/[.;]\s*not given in the papers?\.$/i, ".");
}

/** A table of words; the first `codes` columns are as in the file. */
function plainTable(label: string, columns: string[], rows: string[][], codes: number): HTMLElement {
  const head = columns.map((name) => element("th", { scope: "col" }, [name]));
  const cell = (words: string, i: number) =>
    element("td", {}, [i < codes ? element("code", {}, [words]) : words]);
  const table = element("table", {}, [
    element("thead", {}, [element("tr", {}, head)]),
    element(
      "tbody",
      {},
      rows.map((row) => element("tr", {}, row.map(cell))),
    ),
  ]);
  return scrolled(label, table);
}

/** The missing data and how to obtain them. */
export function missingList(system: SystemReport): Child[] {
  if (system.missing.length === 0) return [];
  const items = system.missing.map((sentence) => element("li", {}, [sentence]));
  return [
    element("div", { class: "message missing" }, [
      element("p", {}, ["Not on this page:"]),
      element("ul", {}, items),
    ]),
  ];
}

export function settingsList(system: SystemReport): Child[] {
  const parts = Object.entries(system.settings);
  if (parts.length === 0) return [];
  const rows = parts.flatMap(([part, settings]) =>
    Object.entries(settings).map(([name, value]) => [part, name, String(value)]),
  );
  return [
    element("details", { class: "settings" }, [
      element("summary", {}, [`All ${rows.length} settings`]),
      plainTable("Settings", ["part", "setting", "value"], rows, 3),
    ]),
  ];
}
