// The unknowns of an inference: prior, posterior, their dependences and the check of the inference.

import { element, type Child } from "../../parts/dom";
import { figure } from "../../parts/figure";
import { fixed, hundredths, percent } from "../../parts/numbers";
import type { CalibratedData, DependenceData, InferenceReport, UnknownData } from "../page/unpacked";
import { savedTable, shownTable, type Column } from "./columns";
import { priorAndPosterior, rankStrip } from "./histogram";
import { cellWords, isListed, unknownWords, valueWords } from "./names";

export function unknownsFigure({ unknowns }: InferenceReport, id: string): HTMLElement {
  return figure({
    title: "Unknowns",
    file: `${id}-unknowns`,
    body: shownTable("Unknowns", kUnknowns, unknowns),
    numbers: () => savedTable(kUnknowns, unknowns),
    printed: { table: () => savedTable(kUnknowns.slice(0, 5), unknowns), note: kWidthNote },
    note: `Bars: posterior; lines: prior. Values are medians, with the range from 5 to 95 %. ${kWidthNote}`,
    hint: "The CSV contains the shares of all parts of a range, and the reasons for the ranges.",
    wide: true,
  });
}

const kWidthNote = "Width: that of the posterior relative to the prior; about 1 if the observed values say nothing.";

const kUnknowns: Column<UnknownData>[] = [
  { name: "unknown", value: ({ name }) => name, shown: ({ name, text }) => [unknownWords(name), reason(text)], kind: "name" },
  { name: "shipped", value: ({ system }) => system, shown: ({ system }) => [element("code", {}, [system])] },
  { name: "prior", value: (one) => valuesWords(one, "prior"), shown: (one) => [valuesWords(one, "prior")] },
  { name: "posterior", value: (one) => valuesWords(one, "posterior"), shown: (one) => [valuesWords(one, "posterior")] },
  { name: "width", value: ({ shrinkage }) => shrinkage, shown: ({ shrinkage }) => [fixed(shrinkage, 2)], kind: "number" },
  { name: "distribution", value: sharesWords, shown: (one) => [priorAndPosterior(one)] },
  { name: "key", value: ({ key }) => key.join(" ") },
  { name: "reason", value: ({ text }) => text },
];

function reason(text: string): Child {
  if (text === "") return null;
  return element("details", { class: "reason" }, [element("summary", {}, ["reason"]), text]);
}

/** A median with its range, or the shares of single values. */
function valuesWords(unknown: UnknownData, which: "prior" | "posterior"): string {
  if (isListed(unknown)) return unknown.cells.map((cell) => `${cellWords(cell)} ${percent(cell[which])}`).join(", ");
  const { low, median, high } = unknown[which];
  return `${valueWords(median)} (${valueWords(low)} to ${valueWords(high)})`;
}

function sharesWords({ cells }: UnknownData): string {
  return cells.map((cell) => `${cellWords(cell)}: ${fixed(cell.prior, 3)} ${fixed(cell.posterior, 3)}`).join("; ");
}

const kMostShown = 12;
const kDeviations = 3; // of a correlation by chance

/** The strongest dependences; the CSV has all of them. */
export function dependencesFigure({ dependences, accepted }: InferenceReport, id: string): Child {
  if (dependences.length === 0) return null;
  const limit = kDeviations / Math.sqrt(Math.max(1, accepted));
  const strong = sorted(dependences).filter(({ correlation }) => Math.abs(correlation) >= limit);
  const shown = strong.slice(0, kMostShown);
  const words = `A correlation of ${fixed(limit, 2)} is ${kDeviations} standard deviations by chance.`;
  return figure({
    title: "Dependences in the posterior",
    file: `${id}-dependences`,
    body:
      shown.length > 0
        ? shownTable("Dependences in the posterior", kDependences, shown)
        : element("p", {}, ["No two unknowns depend on each other more than by chance."]),
    numbers: () => savedTable(kDependences, sorted(dependences)),
    note: `${words} ${strong.length} of ${dependences.length} pairs reach it. The CSV contains all pairs.`,
  });
}

function sorted(dependences: readonly DependenceData[]): DependenceData[] {
  return [...dependences].sort((one, other) => Math.abs(other.correlation) - Math.abs(one.correlation));
}

const kDependences: Column<DependenceData>[] = [
  { name: "unknown", value: ({ first }) => first, shown: ({ first }) => [unknownWords(first)], kind: "name" },
  { name: "other", value: ({ second }) => second, shown: ({ second }) => [unknownWords(second)] },
  {
    name: "correlation",
    value: ({ correlation }) => correlation,
    shown: ({ correlation }) => [hundredths(correlation)],
    kind: "number",
  },
];

export function calibrationFigure({ calibration, truths }: InferenceReport, id: string): Child {
  if (calibration.length === 0) return null;
  const mean = calibration.reduce((all, { covered }) => all + covered, 0) / calibration.length;
  const small = calibration.filter(({ uniform_p: p }) => p < 0.05).length;
  return figure({
    title: "Check of the inference",
    file: `${id}-calibration`,
    body: shownTable("Check of the inference", kCalibration, calibration),
    numbers: () => savedTable(kCalibration, calibration),
    printed: { table: () => savedTable(kCalibration.slice(0, 3), calibration), note: "" },
    note:
      `${truths} draws were taken as observations. If the inference is right, ranks are uniform and 90 % of them are in the shaded part: ` +
      `here ${percent(mean)} on average, and p is below 0.05 for ${small} of ${calibration.length} unknowns.`,
  });
}

const kCalibration: Column<CalibratedData>[] = [
  { name: "unknown", value: ({ name }) => name, shown: ({ name }) => [unknownWords(name)], kind: "name" },
  { name: "in 90 %", value: ({ covered }) => covered, shown: ({ covered }) => [percent(covered)], kind: "number" },
  { name: "p", value: ({ uniform_p: p }) => p, shown: ({ uniform_p: p }) => [fixed(p, 2)], kind: "number" },
  { name: "ranks", value: ({ ranks }) => ranks.join(" "), shown: (one) => [rankStrip(one)] },
];
