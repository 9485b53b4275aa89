// The methods of a paper: in full sentences all that the results were obtained with, every setting
// included.

import { neuronCount } from "../../parts/maps/grid";
import { graphOf } from "../../parts/maps/neuron_graph";
import { countOf } from "../../parts/numbers";
import type { ProtocolData, ReportData, SystemReport } from "../page/unpacked";
import { systemName } from "../page/words";
import { classesOf } from "../tables/labels";
import type { Sentence, Text } from "./cited_text";
import { inWords, unquoted } from "./printed";
import { otherSources, papersOf, papersOfType, programReference } from "./references";
import { SettingsLeft } from "./settings_left";

/** A paragraph about the program, and those of each system; of a variation only what differs. */
export function methodsOf(data: ReportData): Text {
  const originals = data.systems.filter((system) => originalOf(system, data) === null);
  return [
    [[`All results were obtained with the program Somato, version ${data.somato}`, [programReference(data.somato)], "."]],
    ...originals.flatMap((system) => systemParagraphs(system, data)),
    ...data.systems.flatMap((system) => {
      const original = originalOf(system, data);
      return original ? [variationParagraph(system, original)] : [];
    }),
    [kReading],
  ];
}

const kReading: Sentence = [
  "A neuron of the map has the class of most training samples that it wins; the predicted class of a sample is that of the most similar neuron with a class. The nearest neighbour among the training samples, in the input of the map, is the baseline. Means and standard deviations are those over the runs.",
];

function originalOf(system: SystemReport, data: ReportData): SystemReport | null {
  if (system.variation === "") return null;
  const isOriginal = ({ file, name, question, variation }: SystemReport) =>
    file === system.file && name === system.name && question === system.question && variation === "";
  return data.systems.find(isOriginal) ?? null;
}

const nameOf = (system: SystemReport) => inWords(systemName(system));

function systemParagraphs(system: SystemReport, data: ReportData): Text {
  const left = new SettingsLeft(system.settings);
  const others = otherSources(system, data);
  const map = mapOf(left);
  return [
    [
      [`The system ${nameOf(system)}`, papersOf(system, data), ` ${dataWords(system)}.`],
      ...(others.length > 0 ? [[`Its claims also refer to ${others.join(" and ")}.`]] : []),
      ...left.parts(/^explore/).map((part) => left.sentence(part, exploringWords(part))),
    ],
    [...left.modules(map).map((part) => moduleSentence(left, part)), ...(map === null ? [] : mapSentences(left, map, system))],
    [
      ...system.protocols.map((protocol) => [`${trainedWords(protocol, left)}, and tested by the label ${inWords(protocol.label)}.`]),
      ...runSentences(system).map((words) => [words]),
      ...left.parts(/./).map((part) => left.sentence(part, otherWords(part))),
      ...notGivenSentences(system),
    ],
  ];
}

function dataWords(system: SystemReport): string {
  const { recordings, protocols, data_hash } = system;
  const samples = Math.max(0, ...protocols.map((one) => one.samples));
  const label = protocols[0]?.label ?? "";
  const classes = label === "" ? "" : ` of ${countOf(classesOf(system, label).length, "class", "classes")} of the label ${inWords(label)}`;
  const hash = data_hash === "" ? "" : ` (hash of the data${recordings.length > 1 ? " of the first" : ""}: ${data_hash})`;
  const from = recordings.length === 0 ? "" : ` ${recordingWords(recordings)}${hash}`;
  return `was trained and tested on ${countOf(samples, "exploration")}${classes}${from}`;
}

function recordingWords(names: string[]): string {
  if (names.length === 1) return `from the recording ${names[0]}`;
  return `from each of ${names.length} recordings, ${names[0]} to ${names.at(-1)}`;
}

function exploringWords(part: string): string {
  const what = part.replace(/^explore\.?/, "");
  return what === "" ? "The explorations were made" : `The settings ${inWords(what)} of the explorations were chosen`;
}

/** The output map: the only one, or that of which no other module takes the output. */
function mapOf(left: SettingsLeft): string | null {
  return left.parts(/^module\./).filter((part) => kMaps.has(left.type(part))).at(-1) ?? null;
}

const kMaps = new Map([
  ["som", "a self-organizing map"],
  ["growing_when_required", "a map that grows when required"],
  ["growing_cells", "a map of growing cells"],
  ["growing_grid", "a growing grid"],
]);

function moduleSentence(left: SettingsLeft, part: string): Sentence {
  const type = left.take(part, "type");
  const kind = kMaps.get(type) ?? `a module of the type ${inWords(type)}`;
  const name = inWords(part.replace(/^module\./, ""));
  return [`The module ${name} is ${kind}`, papersOfType(type), `${left.listed(part)}.`];
}

function mapSentences(left: SettingsLeft, part: string, system: SystemReport): Sentence[] {
  const type = left.take(part, "type");
  const input = inWords(left.take(part, "input"));
  const first: Sentence = [`The output map is ${kMaps.get(type)}${sizeWords(system)}`, papersOfType(type), ` with the input ${input}.`];
  if (left.look(part, "iterations") === "") return [first, left.sentence(part, "It was trained")];
  const take = (name: string) => inWords(left.take(part, name));
  const learning = `It was trained for ${take("iterations")} iterations (${take("training")}); the learning rate changed from ${take("learning_rate_start")} to ${take("learning_rate_end")} (${take("learning_rate_schedule")} schedule), and the radius of the neighbourhood (${take("neighbourhood")}) from ${take("radius_start")} to ${take("radius_end")} (${take("radius_schedule")} schedule).`;
  return [first, [learning], left.sentence(part, "Map and training were set up")];
}

function sizeWords({ grid }: SystemReport): string {
  if (!grid) return "";
  return graphOf(grid) ? ` of ${countOf(neuronCount(grid), "neuron")}` : ` of ${grid.rows} × ${grid.columns} neurons`;
}

/** One for all protocols, or one for each if they differ. */
function runSentences({ protocols }: SystemReport): string[] {
  const runs = protocols.map(runWords);
  const [first] = runs;
  if (first === undefined) return [];
  if (new Set(runs).size === 1) return [`${protocols.length > 1 ? "Each of these tests" : "This"} was done in ${first}.`];
  return runs.map((words, i) => `Test ${i + 1} was done in ${words}.`);
}

function runWords({ runs }: ProtocolData): string {
  const seeds = [...new Set(runs.map(({ seed }) => seed))].sort((one, other) => one - other);
  const span = seeds.length === 1 ? `the seed ${seeds[0]}` : `${seeds.length} seeds from ${seeds[0]} to ${seeds.at(-1)}`;
  return seeds.length === 0 ? "no run" : `${countOf(runs.length, "run")} with ${span}`;
}

function trainedWords({ protocol, group, samples, label }: ProtocolData, left: SettingsLeft): string {
  const words: Record<string, string> = {
    train_is_test: `The system was trained on all ${samples} samples`,
    leave_one_out: `Each of ${samples} samples was left out in turn; the system was trained on all others`,
    leave_group_out: `The samples of each ${inWords(group ?? "group")} were left out in turn; the system was trained on all others, ${samples} samples in all`,
    leave_class_out: `Each ${inWords(label)} was left out in turn as an unknown class; the system was trained on the others, ${samples} samples in all`,
    k_folds: `The ${samples} samples were divided into ${left.look("study", "folds")} folds, each of which was left out in turn; the system was trained on the others`,
    object_after_object: `The classes of ${samples} samples were learned one after another, in a random order for each seed`,
    test_data: `The system was trained on all samples and tested on ${samples} samples of another recording`,
  };
  return words[protocol] ?? `The system was trained under the protocol ${inWords(protocol)} on ${samples} samples`;
}

function otherWords(part: string): string {
  if (part === "study") return "The study was made";
  if (part === "recording") return "The recordings were read";
  const [kind, name] = part.split(/\.(.*)/s);
  if (kind === "phase") return `Phase ${name} of the training was made`;
  if (kind === "altered") return `The explorations were altered as ${inWords(name ?? "")} for a further test`;
  return `The part ${inWords(part)} was set up`;
}

function notGivenSentences({ not_given }: SystemReport): Sentence[] {
  if (not_given.length === 0) return [];
  const names = not_given.map(({ part, name }) => `${inWords(name)} of ${inWords(part.replace(/^module\./, ""))}`);
  return [[`The papers do not give these settings, whose values are assumptions: ${names.join("; ")}.`]];
}

/** What a variation changes. */
function variationParagraph(system: SystemReport, original: SystemReport): Sentence[] {
  const changes = Object.entries(system.settings).flatMap(([part, settings]) =>
    Object.entries(settings).flatMap(([name, value]) => {
      const before = original.settings[part]?.[name];
      if (before === value) return [];
      const instead = before === undefined ? "" : ` instead of ${unquoted(before)}`;
      return [`${inWords(name)} of ${inWords(part.replace(/^module\./, ""))} is ${unquoted(value)}${instead}`];
    }),
  );
  const gone = Object.keys(original.settings).filter((part) => system.settings[part] === undefined);
  const without = gone.map((part) => `there is no ${inWords(part.replace(/^module\./, ""))}`);
  const all = [...changes, ...without];
  const end = all.length === 0 ? "has the same settings" : `differs from it: ${all.join("; ")}`;
  return [[`The variation ${inWords(system.variation)} of the system ${inWords(original.name)} ${end}.`]];
}
