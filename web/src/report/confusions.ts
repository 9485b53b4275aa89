// Confusion matrices: rows are the true classes, columns the predicted ones.

import type { Table } from "../parts/csv";
import { element } from "../parts/dom";
import { confusionPicture, type Counts } from "./confusion_picture";
import type { RunData, SystemReport } from "./data";
import { classesOf, predictionsOf, valuesOf } from "./labels";
import { liveFigure, nothing, type Drawn } from "./live_figure";
import type { Selection } from "./selection";
import { runWords } from "./toolbar";
import { protocolName, systemName } from "./words";

/** The confusion matrix over all runs, and that of the selected run. */
export function confusionFigures(system: SystemReport, selection: Selection): HTMLElement[] {
  return [true, false].map((isAll) => {
    const options = {
      title: isAll ? "Confusion matrix of all runs" : "Confusion matrix of the selected seed",
      file: `${systemName(system)}-confusions${isAll ? "" : "-of-seed"}`,
      note: isAll
        ? "Rows are true classes, columns predicted classes; the colour is the share of the row."
        : "",
    };
    return liveFigure(options, selection, () => draw(system, selection, isAll)).element;
  });
}

function draw(system: SystemReport, selection: Selection, isAll: boolean): Drawn {
  const { protocol, run, label } = selection;
  if (!protocol || !run) return nothing("This protocol has no runs.");
  const counts = countsOf(system, selection, isAll ? protocol.runs : [run]);
  if (!counts) return nothing(`There are no predictions of the label ${label} under this protocol.`);
  const runs = isAll ? allRuns(protocol.runs.length) : `seed ${runWords(selection)}`;
  const words = `${protocolName(protocol)}, by ${label}, ${runs}`;
  const picture = confusionPicture(counts, `Confusions: ${words}`);
  const what = element("p", { class: "small what" }, [words]);
  return { body: [what, picture.element], svg: picture.svg, table: tableOf(counts) };
}

function allRuns(count: number): string {
  return count === 1 ? "the only run" : `all ${count} runs`;
}

function countsOf(system: SystemReport, { protocol, label }: Selection, runs: RunData[]): Counts | null {
  if (!protocol) return null;
  const pairs: [string, string][] = [];
  for (const run of runs) {
    const [truth, named] = [valuesOf(system, protocol, run, label), predictionsOf(protocol, run, label)];
    if (truth && named) truth.forEach((value, i) => pairs.push([value, named[i] ?? ""]));
  }
  if (pairs.length === 0) return null;
  const classes = [...new Set([...classesOf(system, label), ...pairs.map(([, named]) => named)])];
  const number = new Map(classes.map((name, i) => [name, i]));
  const counts = classes.map(() => new Array<number>(classes.length).fill(0));
  for (const [truth, named] of pairs) {
    const row = counts[number.get(truth) ?? 0];
    const column = number.get(named) ?? 0;
    if (row) row[column] = (row[column] ?? 0) + 1;
  }
  return { classes, counts };
}

function tableOf({ classes, counts }: Counts): Table {
  return {
    columns: ["true class", ...classes],
    rows: classes.map((name, i) => [name, ...(counts[i] ?? [])]),
  };
}
