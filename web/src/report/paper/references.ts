// The references of a paper: the program, the papers whose systems are used, and those that introduced the
// maps in them.

import type { ReportData, SystemReport } from "../page/unpacked";
import { claimsOf } from "../tables/systems_table";
import { kOfTypes, kReferences, type Reference } from "./reference_list";

/** The program, as CITATION.cff has it. */
export function programReference(version: string): Reference {
  return {
    key: "somato",
    short: "Somato contributors",
    kind: "software",
    fields: [
      ["author", "{Somato contributors}"],
      ["title", "Somato: a self-organizing sense of touch for robots"],
      ["version", version],
      ["license", "Apache-2.0"],
    ],
  };
}

/** The papers of a system by the sources of its claims, such as "P06 2.3, P11". */
export function papersOf(system: SystemReport, data: ReportData): Reference[] {
  const sources = claimsOf(system, data).map(({ paper }) => paper);
  const named = Object.keys(kReferences).filter((name) => sources.some((source) => namesPaper(source, name)));
  return named.map((name) => kReferences[name]!);
}

function namesPaper(source: string, name: string): boolean {
  return source.split(/,\s*/).some((one) => one === name || one.startsWith(`${name} `));
}

/** The papers that introduced a type of module. */
export function papersOfType(type: string): Reference[] {
  return (kOfTypes[type] ?? [type]).flatMap((name) => kReferences[name] ?? []);
}

/** The sources of claims that are not among the references. */
export function otherSources(system: SystemReport, data: ReportData): string[] {
  const sources = claimsOf(system, data).flatMap(({ paper }) => paper.split(/,\s*(?=[A-Z])/));
  const isOther = (one: string) => one !== "" && !Object.keys(kReferences).some((name) => namesPaper(one, name));
  return [...new Set(sources)].filter(isOther);
}

/** All references of a report as BibTeX. */
export function bibtex(data: ReportData): string {
  return [programReference(data.somato), ...referencesOf(data)].map(entryOf).join("\n");
}

/** Those of all systems and their modules, each once. */
export function referencesOf(data: ReportData): Reference[] {
  const used = new Set(data.systems.flatMap((system) => [...papersOf(system, data), ...typesOf(system).flatMap(papersOfType)]));
  return Object.values(kReferences).filter((one) => used.has(one));
}

/** The types of a system's modules. */
function typesOf({ settings }: SystemReport): string[] {
  const types = Object.values(settings).flatMap(({ type }) => (type === undefined ? [] : [type]));
  return [...new Set(types.map((type) => type.replaceAll('"', "")))];
}

function entryOf({ kind, key, fields }: Reference): string {
  return [`@${kind}{${key},`, ...fields.map(([name, value]) => `  ${name} = {${value}},`), "}", ""].join("\n");
}

/** As a line of a list below a text. */
export function listedReference({ fields }: Reference): string {
  const words = (name: string) => fields.find(([one]) => one === name)?.[1].replaceAll("--", "–") ?? "";
  const authors = words("author").replaceAll(/[{}]/g, "").replaceAll(" and ", "; ");
  const year = words("year") === "" ? "" : ` (${words("year")})`;
  const version = words("version") === "" ? "" : `Version ${words("version")}`;
  const places = [words("journal"), words("publisher"), words("volume"), words("pages"), version];
  const place = places.filter((one) => one !== "").join(", ");
  return `${authors}${year}. ${words("title")}.${place === "" ? "" : ` ${place}.`}`;
}
