// The sentences of the methods about protocols and seeds.

import { countOf } from "../../parts/numbers";
import type { ProtocolData, SystemReport } from "../page/unpacked";
import { inWords } from "./printed";
import type { SettingsLeft } from "./settings_left";

export function protocolSentences(system: SystemReport, left: SettingsLeft): string[] {
  const tests = system.protocols.map((protocol) => {
    const by = `tested by the label ${inWords(protocol.label)}`;
    return `${trainedWords(protocol, left)}, and ${by}.`;
  });
  return [...tests, ...runSentences(system)];
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
