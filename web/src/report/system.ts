// The section of one system.

import { element, type Child } from "../parts/dom";
import { countOf } from "../parts/numbers";
import { claimsFigure } from "./claims";
import { confusionFigures } from "./confusions";
import { connectivityFigures } from "./connectivity";
import type { ReportData, SystemReport } from "./data";
import { systemId } from "./groups";
import { graphFigure } from "./graph";
import { lazy } from "./lazy";
import { momentFigures } from "./moments";
import { outcomesFigure } from "./outcomes";
import { claimsOf } from "./systems_table";
import { planeFigures } from "./planes";
import { Selection } from "./selection";
import { mapFigure, savedMapFigures } from "./system_map";
import { missingList, notGivenFigure, settingsList } from "./tables";
import { thingsFigure } from "./things";
import { toolbar } from "./toolbar";
import { systemName } from "./words";

export function systemSection(system: SystemReport, index: number, data: ReportData): HTMLElement {
  const id = systemId(index);
  const section = element("section", { id, class: "system", "aria-labelledby": `${id}-title` }, [
    systemHeader(system, `${id}-title`),
  ]);
  section.append(lazy(900, () => systemParts(system, data, id)));
  return section;
}

function systemHeader(system: SystemReport, id: string): HTMLElement {
  // Below the heading of a question the level is lower.
  const title = element(system.question === "" ? "h2" : "h3", { id, class: "system-title" }, [
    systemName(system),
  ]);
  return element("header", { class: "system-header" }, [
    title,
    element(
      "dl",
      { class: "facts" },
      factsOf(system).flatMap(([name, value]) => fact(name, value)),
    ),
  ]);
}

function fact(name: string, value: string): Child[] {
  return [element("div", {}, [element("dt", {}, [name]), element("dd", {}, [value])])];
}

function factsOf(system: SystemReport): [string, string][] {
  const { grid, recordings, protocols } = system;
  const runs = Math.max(0, ...protocols.map((protocol) => protocol.runs.length));
  const samples = Math.max(0, ...protocols.map((protocol) => protocol.samples));
  const facts: [string, string][] = [["Results", system.file]];
  if (grid) facts.push(["Map", `${grid.rows} × ${grid.columns}, ${grid.lattice}, ${grid.topology}`]);
  facts.push(["Samples", String(samples)], ["Runs", String(runs)]);
  const word = recordings.length === 1 ? "Recording" : "Recordings";
  if (recordings.length > 0) facts.push([word, recordingWords(recordings)]);
  if (system.data_hash !== "") facts.push(["Data", system.data_hash]);
  return facts;
}

function recordingWords(recordings: string[]): string {
  if (recordings.length <= 3) return recordings.join(", ");
  return `${countOf(recordings.length, "recording")}: ${recordings[0] ?? ""} to ${recordings.at(-1) ?? ""}`;
}

function systemParts(system: SystemReport, data: ReportData, id: string): Child[] {
  const selection = new Selection(system);
  const claims = claimsOf(system, data);
  const { trained } = system;
  const parts: [string, number, boolean, () => Child[]][] = [
    ["The graph of its modules", 260, system.graph !== null, () => [graphFigure(system)]],
    ["The map", 620, system.protocols.length > 0, () => mapFigures(system, selection)],
    [
      "Weights of the neurons",
      560,
      system.grid !== null && (trained?.planes.length ?? 0) > 0,
      () => planeFigures(system, selection),
    ],
    ["Connectivity", 480, (trained?.receptive_fields.length ?? 0) > 0, () => connectivityFigures(system)],
    ["Sensor readings", 480, system.moments.length > 0, () => momentFigures(system)],
    ["Over the seeds", 420, system.protocols.length > 0, () => [outcomesFigure(system, selection, claims)]],
    [
      "Confusion matrix",
      420,
      system.protocols.length > 0,
      () => figuresOf(confusionFigures(system, selection)),
    ],
    ["Claims", 200, claims.length > 0, () => [claimsFigure(claims, `${systemName(system)}-claims`, false)]],
    ["Objects and materials", 240, system.things.length > 0, () => [thingsFigure(system)]],
    ["Not given in the papers", 160, system.not_given.length > 0, () => [notGivenFigure(system)]],
  ];
  const blocks = parts
    .filter(([, , isThere]) => isThere)
    .map(([title, height, , make], i) => block(`${id}-part-${i}`, title, height, make));
  return [
    ...missingList(system),
    system.protocols.length > 0 ? toolbar(selection) : noProtocols(),
    ...blocks,
    ...settingsList(system),
  ];
}

function figuresOf(figures: HTMLElement[]): Child[] {
  return [element("div", { class: "figures" }, figures)];
}

function noProtocols(): Child {
  return element("p", { class: "message" }, [
    "These results contain no protocol.",
  ]);
}

function mapFigures(system: SystemReport, selection: Selection): Child[] {
  const saved = savedMapFigures(system);
  const beside = saved.length === 0 ? null : element("div", { class: "stack" }, saved);
  return [element("div", { class: beside ? "map-row" : "" }, [mapFigure(system, selection), beside])];
}

function block(id: string, title: string, height: number, make: () => Child[]): HTMLElement {
  return element("div", { class: "block", id }, [element("h3", {}, [title]), lazy(height, make)]);
}
