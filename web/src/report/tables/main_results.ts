// The main results of a system: how often it identifies what it was trained on, other explorations
// of the same things, and other things.

import { handLayout } from "../../parts/hands/hand_layout";
import { fixed, percent } from "../../parts/numbers";
import type { MetricData, ProtocolData, ReportData, SystemReport } from "../page/unpacked";
import { systemName } from "../page/words";

/** Accuracy for a label under a protocol. */
export interface Result {
  protocol: ProtocolData;
  label: string;
  accuracy: MetricData;
  baseline: MetricData | undefined; // of the nearest neighbour
}

export interface MainResults {
  runs: number;
  trained: Result | null; // the samples of the training
  known: Result | null; // other explorations of things that were in the training
  fresh: Result | null; // things that were not in the training, by another label of theirs
}

export function mainResults(system: SystemReport): MainResults {
  const heldOut = system.protocols.filter((one) => one.protocol !== "train_is_test");
  const trained = system.protocols.find((one) => one.protocol === "train_is_test");
  return {
    runs: Math.max(0, ...system.protocols.map((one) => one.runs.length)),
    trained: trained ? ownResult(trained) : null,
    known: hardest(heldOut.filter((one) => !leavesThingsOut(one)).map(ownResult)),
    fresh: hardest(heldOut.filter(leavesThingsOut).flatMap(otherResults)),
  };
}

/** Whether the classes of the studied label are left out, so that only other labels can be predicted. */
function leavesThingsOut(protocol: ProtocolData): boolean {
  return protocol.group === protocol.label || ownResult(protocol) === null;
}

function ownResult(protocol: ProtocolData): Result | null {
  const { accuracy, baseline_accuracy: baseline } = protocol.metrics;
  return accuracy ? { protocol, label: protocol.label, accuracy, baseline } : null;
}

const kOther = /^([^.\s]+)\.accuracy$/;

function otherResults(protocol: ProtocolData): Result[] {
  return Object.entries(protocol.metrics).flatMap(([name, accuracy]) => {
    const label = kOther.exec(name)?.[1];
    if (label === undefined) return [];
    return [{ protocol, label, accuracy, baseline: protocol.metrics[`${label}.baseline_accuracy`] }];
  });
}

function hardest(results: (Result | null)[]): Result | null {
  const found = results.filter((one) => one !== null);
  return found.sort((one, other) => (one.accuracy.mean ?? 1) - (other.accuracy.mean ?? 1))[0] ?? null;
}

/** The system whose lowest held-out accuracy is highest, among those of a hand, if any has a map; the first of equals. */
export function bestSystem(systems: readonly SystemReport[]): SystemReport | null {
  const shown = systems.filter((one) => one.grid !== null && one.protocols.some(({ runs }) => runs.length > 0));
  const ofHand = shown.filter(isOfHand);
  const ranked = (ofHand.length > 0 ? ofHand : shown).map((system) => ({ system, rank: lowest(mainResults(system)) }));
  return ranked.sort((one, other) => other.rank - one.rank)[0]?.system ?? null;
}

/** Whether the readings of a hand are on the page. */
export function isOfHand({ moments }: SystemReport): boolean {
  const moment = moments.find((one) => one !== null);
  return moment?.channels.some(({ channel }) => handLayout(channel.elements) !== null) ?? false;
}

function lowest({ trained, known, fresh }: MainResults): number {
  const heldOut = [known, fresh].filter((one) => one !== null);
  const means = (heldOut.length > 0 ? heldOut : [trained]).map((one) => one?.accuracy.mean ?? 0);
  return Math.min(...means);
}

/** The results in sentences. */
export function summaryOf(systems: readonly SystemReport[]): string {
  const [system] = systems;
  if (!system) return "";
  return systems.length === 1 ? summaryOfOne(system) : summaryOfMany(systems);
}

function summaryOfOne(system: SystemReport): string {
  const { trained, known, fresh, runs } = mainResults(system);
  const label = words((trained ?? known)?.label ?? "");
  const own = [
    trained && `of ${shareOf(trained)} of the training samples`,
    known && `of ${shareOf(known)} of samples left out${beside(known, chanceOf(system, known))}`,
  ].filter((part) => part !== null);
  const other =
    fresh &&
    `the ${words(fresh.label)} of ${shareOf(fresh)} of samples whose ${words(fresh.protocol.label)} was left out${beside(fresh)}`;
  const parts = [...(own.length > 0 ? [`the ${label} ${own.join(" and ")}`] : []), ...(other ? [other] : [])];
  if (parts.length === 0) return "";
  return `${systemName(system)} identifies ${parts.join(", and ")}${runs > 1 ? `; means over ${runs} runs` : ""}.${confusionWords(system)}${sentencesOf(system)}`;
}

/** The sentences of the program, each after a space. */
const sentencesOf = ({ summary }: SystemReport) => (summary?.sentences ?? []).map((one) => ` ${one}`).join("");

/** The most frequent confusions. */
function confusionWords({ summary, protocols }: SystemReport): string {
  const runs = protocols[summary?.protocol ?? 0]?.runs.length ?? 1;
  const most = (summary?.confusions ?? []).map(({ label, predicted, count, of }) => `${words(label)} named ${words(predicted)} (${count} of ${of} samples)`);
  if (most.length === 0) return "";
  const [noun, verb] = most.length === 1 ? ["confusion", "is"] : ["confusions", "are"];
  return ` The most frequent ${noun}${runs > 1 ? ", counted over all runs," : ""} ${verb} ${listed(most)}.`;
}

const listed = (all: string[]) => (all.length === 1 ? all[0]! : `${all.slice(0, -1).join(", ")} and ${all.at(-1)!}`);

const words = (label: string) => label.replaceAll("_", " ");
const shareOf = ({ accuracy }: Result) => percent(accuracy.mean);

/** The chance of the result that the summary of the program states. */
function chanceOf({ summary, protocols }: SystemReport, { protocol }: Result): number | null {
  return summary && protocols[summary.protocol] === protocol ? summary.chance : null;
}

function beside({ accuracy, baseline }: Result, chance: number | null = null): string {
  const parts = [
    ...(accuracy.values.length > 1 ? [`± ${fixed((accuracy.sd ?? 0) * 100, 1)} %`] : []),
    ...(baseline ? [`nearest neighbour: ${percent(baseline.mean)}`] : []),
    ...(chance === null ? [] : [`by chance: ${percent(chance)}`]),
  ];
  return parts.length > 0 ? ` (${parts.join("; ")})` : "";
}

function summaryOfMany(systems: readonly SystemReport[]): string {
  const results = systems.map(mainResults);
  const parts = [
    range("the class of", results.map(({ known }) => known), "the samples that were left out of the training"),
    range("another label of", results.map(({ fresh }) => fresh), "the samples whose class was left out"),
  ].filter((part) => part !== null);
  return parts.length === 0 ? "" : `${systems.length} systems identify ${parts.join(", and ")}.`;
}

function range(label: string, results: (Result | null)[], of: string): string | null {
  const found = results.filter((one) => one !== null);
  const ends = (values: (number | null | undefined)[]) => {
    const known = values.filter((value) => value !== null && value !== undefined);
    const [least, most] = [percent(Math.min(...known)), percent(Math.max(...known))];
    return least === most ? least : `${least} to ${most}`;
  };
  if (found.length === 0) return null;
  return `${label} ${ends(found.map(({ accuracy }) => accuracy.mean))} of ${of} (nearest neighbour: ${ends(found.map(({ baseline }) => baseline?.mean))})`;
}

/** The original systems, without variations. */
export function originals(data: ReportData): SystemReport[] {
  const standing = data.systems.filter(({ question }) => question === "");
  const unchanged = standing.filter(({ variation }) => variation === "");
  return unchanged.length > 0 ? unchanged : standing;
}
