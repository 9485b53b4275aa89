// The section of a system and its variations, of which one is shown at a time.

import { choice } from "../../parts/controls";
import { element, fill, type Child } from "../../parts/dom";
import { gridWords } from "../../parts/maps/grid";
import { countOf } from "../../parts/numbers";
import { registerSection, showInAddress } from "../page/address";
import { confusionFigures } from "../maps/confusions";
import { allConnectivityFigures, connectivityFigures } from "../maps/connectivity";
import { decidingFigures } from "../moments/deciding";
import { graphFigure } from "../maps/graph";
import type { Group } from "../page/groups";
import { drawInside, lazy } from "../page/lazy";
import { momentFigures } from "../moments/moments";
import { outcomesFigure } from "./outcomes";
import { allPlaneFigures, planeFigures } from "../maps/planes";
import { Samples } from "../moments/samples";
import { Selection } from "../page/selection";
import { restored, stateOf } from "../page/selection_state";
import { mapFigures } from "../maps/system_map";
import { block, type Part } from "../page/system_part";
import { claimsOf } from "./systems_table";
import { missingList, notGivenFigure, settingsList } from "./tables";
import { thingsFigure } from "../moments/things";
import { toolbar } from "../page/toolbar";
import type { ReportData, SystemReport } from "../page/unpacked";
import { wonSamples } from "./won_samples";

/** `isFolded`: all parts but the maps are closed at first, because the report has many systems. */
export function systemSection({ id, name, systems }: Group, data: ReportData, isFolded: boolean): HTMLElement {
  const [place, facts] = [element("div"), element("dl", { class: "facts" })];
  const names = systems.map(({ system }) => system.variation || "original");
  const selections = systems.map(({ system }) => new Selection(system));
  const variations = choice("Variation", names, 0, (index) => show(index, true));
  let shown = -1;
  const state = () => ({
    ...(systems.length > 1 ? { variation: systems[shown]?.system.variation ?? "" } : {}),
    ...stateOf(selections[shown]!),
  });
  const write = () => showInAddress(id);
  const show = (index: number, isChosen: boolean) => {
    const selection = selections[index];
    if (!selection || index === shown) return;
    shown = index;
    variations.set(index);
    fill(facts, factsOf(selection.system).flatMap(([one, value]) => fact(one, value)));
    const first = systems.length > 1 ? [variations.element] : [];
    fill(place, [systemBody(selection, data, isFolded, first)]);
    if (isChosen) write();
  };
  selections.forEach((selection) => {
    selection.listen(write);
    selection.listenToNeuron(write);
  });
  const restore = (from: URLSearchParams) => {
    const variation = systems.findIndex(({ system }) => system.variation === (from.get("variation") ?? ""));
    show(Math.max(0, variation), false);
    restored(selections[shown]!, from);
  };
  registerSection(id, { state, restore });
  show(0, false);
  const title = element("h2", { id: `${id}-title`, class: "system-title" }, [name]);
  return element("section", { id, class: "system", "aria-labelledby": `${id}-title` }, [
    element("header", { class: "system-header" }, [title, facts]),
    place,
  ]);
}

/** A system without a section of its own. */
export function systemParts(system: SystemReport, data: ReportData, isFolded: boolean): HTMLElement {
  return systemBody(new Selection(system), data, isFolded, []);
}

function fact(name: string, value: string): Child[] {
  return [element("div", {}, [element("dt", {}, [name]), element("dd", {}, [value])])];
}

function factsOf(system: SystemReport): [string, string][] {
  const { grid, recordings, protocols } = system;
  const runs = Math.max(0, ...protocols.map((protocol) => protocol.runs.length));
  const samples = Math.max(0, ...protocols.map((protocol) => protocol.samples));
  const facts: [string, string][] = [["Results", system.file]];
  if (grid) facts.push(["Map", gridWords(grid)]);
  facts.push(["Samples", String(samples)], ["Runs", String(runs)]);
  const word = recordings.length === 1 ? "Recording" : "Recordings";
  if (recordings.length > 0) facts.push([word, recordingWords(recordings)]);
  if (system.data_hash !== "") facts.push(["Data", system.data_hash]);
  for (const one of system.summary?.sentences ?? []) facts.push(["Compared", one]);
  return facts;
}

function recordingWords(recordings: string[]): string {
  if (recordings.length <= 3) return recordings.join(", ");
  return `${countOf(recordings.length, "recording")}: ${recordings[0] ?? ""} to ${recordings.at(-1) ?? ""}`;
}

function systemBody(selection: Selection, data: ReportData, isFolded: boolean, first: Child[]): HTMLElement {
  return lazy(900, () => bodyParts(selection, data, isFolded, first));
}

function bodyParts(selection: Selection, data: ReportData, isFolded: boolean, first: Child[]): Child[] {
  const { system } = selection;
  const samples = new Samples(system);
  const readings: Part = {
    title: "Sensor readings",
    height: 480,
    make: () => momentFigures(system, samples),
  };
  const shownReadings = samples.names.length > 0 ? block(readings, !isFolded) : null;
  const showReadings = () => {
    if (!shownReadings) return;
    shownReadings.open = true;
    drawInside(shownReadings);
    shownReadings.scrollIntoView({ block: "start" });
  };
  const others = [...weightParts(selection), ...otherParts(selection, data)];
  const hasProtocols = system.protocols.length > 0;
  return [
    ...missingList(system),
    hasProtocols ? toolbar(selection, first) : noProtocols(first),
    hasProtocols ? maps(selection, wonSamples(selection, samples, showReadings)) : null,
    shownReadings,
    ...others.map((part) => block(part, !isFolded)),
    ...settingsList(system),
  ];
}

/** Winners and their samples, with the other maps beside them. */
function maps(selection: Selection, samples: HTMLElement): HTMLElement {
  const [winners, ...others] = mapFigures(selection);
  return element("div", { class: "maps" }, [
    element("div", {}, [winners ?? null, samples]),
    element("div", { class: "maps-beside" }, others),
  ]);
}

function part(title: string, height: number, isThere: boolean, make: () => Child[]): Part[] {
  return isThere ? [{ title, height, make }] : [];
}

function weightParts(selection: Selection): Part[] {
  const { trained, grid } = selection.system;
  const hasPlanes = grid !== null && (trained?.planes.length ?? 0) > 0;
  const hasFields = (trained?.receptive_fields.length ?? 0) > 0;
  return [
    ...part("Weights of the neurons", 560, hasPlanes, () => planeFigures(selection)),
    ...part("Connectivity", 480, hasFields, () => connectivityFigures(selection.system)),
  ];
}

function otherParts(selection: Selection, data: ReportData): Part[] {
  const { system } = selection;
  const { protocols, deciding, graph, things, not_given } = system;
  const claims = claimsOf(system, data);
  const hasProtocols = protocols.length > 0;
  const runs = Math.max(0, ...protocols.map((protocol) => protocol.runs.length));
  return [
    ...part(runs > 1 ? "Metrics over the runs" : "Metrics", 420, hasProtocols, () => [outcomesFigure(selection, claims)]),
    ...part("Confusion matrix", 420, hasProtocols, () => [element("div", { class: "figures" }, confusionFigures(selection))]),
    ...part("Which sensors decided", 420, (deciding?.decisions.length ?? 0) > 0, () => decidingFigures(system)),
    ...part("Graph of the modules", 260, graph !== null, () => [graphFigure(system)]),
    ...part("Objects and materials", 240, things.length > 0, () => [thingsFigure(system)]),
    ...part("Settings not given in the papers", 160, not_given.length > 0, () => [notGivenFigure(system)]),
  ];
}

/** All figures of a system, those of every channel and connection included. */
export function systemFigures(selection: Selection, data: ReportData): Child[] {
  const { system } = selection;
  const samples = new Samples(system);
  return [
    ...(system.protocols.length > 0 ? mapFigures(selection) : []),
    ...(samples.names.length > 0 ? momentFigures(system, samples) : []),
    ...allPlaneFigures(selection),
    ...allConnectivityFigures(system),
    ...otherParts(selection, data).flatMap((part) => part.make()),
  ];
}

function noProtocols(first: Child[]): Child {
  return element("div", {}, [...first, element("p", { class: "message" }, ["These results contain no protocol."])]);
}
