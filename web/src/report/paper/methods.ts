// The methods of a paper: in full sentences all that the results were obtained with, every setting
// included.

import { countOf } from "../../parts/numbers";
import type { ReportData, SystemReport } from "../page/unpacked";
import { systemName } from "../page/words";
import { classesOf } from "../tables/labels";
import type { Sentence, Text } from "./cited_text";
import { moduleSentences } from "./method_modules";
import { protocolSentences } from "./method_protocols";
import { inWords, unquoted } from "./printed";
import { otherSources, papersOf, programReference } from "./references";
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
  return [
    [
      [`The system ${nameOf(system)}`, papersOf(system, data), ` ${dataWords(system)}.`],
      ...(others.length > 0 ? [[`Its claims also refer to ${others.join(" and ")}.`]] : []),
      ...left.parts(/^explore/).map((part) => left.sentence(part, exploringWords(part))),
    ],
    moduleSentences(left, system),
    [
      ...protocolSentences(system, left).map((words) => [words]),
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

/** The settings that a variation changes. */
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
