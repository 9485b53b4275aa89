// Confusion matrices: rows are the true classes, columns the predicted ones.

import type { Table } from "../../parts/csv";
import { element } from "../../parts/dom";
import type { Shown } from "../../parts/figure";
import { confusionPicture, type Counts } from "./confusion_picture";
import type { RunData, SystemReport } from "../page/unpacked";
import { classesOf, predictionsOf, valuesOf } from "../tables/labels";
import { liveFigure, nothing, type Drawn } from "./live_figure";
import type { Selection } from "../page/selection";
import { nameOf, shownBySelection, shownOf } from "../page/origin";
import { protocolName, systemName } from "../page/words";

/** The confusion matrix over all runs, and that of the selected run if there are several. */
export function confusionFigures(selection: Selection): HTMLElement[] {
  const hasSeveral = selection.system.protocols.some(({ runs }) => runs.length > 1);
  return (hasSeveral ? [true, false] : [false]).map((isAll) => {
    const options = {
      title: isAll ? "Confusion matrix of all runs" : kOfOne,
      file: `${systemName(selection.system)}-confusions${isAll ? "-of-all" : ""}`,
      note: "Rows are true classes, columns predicted classes; the colour is the share of the row.",
      about: () => shown(selection, isAll),
    };
    return liveFigure(options, selection, () => draw(selection, isAll));
  });
}

const kOfOne = "Confusion matrix of the selected run";

function shown(selection: Selection, isAll: boolean): Shown {
  const { protocol, label, system } = selection;
  if (!isAll || !protocol) return shownBySelection(selection);
  const words = `${protocolName(protocol)}, by ${label}, all ${protocol.runs.length} runs`;
  return shownOf(system, words, nameOf(selection, [label]));
}

function draw(selection: Selection, isAll: boolean): Drawn {
  const { protocol, run, label, system } = selection;
  if (!protocol || !run) return nothing("This protocol has no runs.");
  const counts = countsOf(system, selection, isAll ? protocol.runs : [run]);
  if (!counts) return nothing(`There are no predictions of the label ${label} under this protocol.`);
  const { words } = shown(selection, isAll);
  const picture = confusionPicture(counts, `Confusions: ${words}`);
  const what = element("p", { class: "small what" }, [words]);
  return { body: [what, picture.element], svg: picture.svg, table: tableOf(counts) };
}

function countsOf(system: SystemReport, { protocol, label }: Selection, runs: RunData[]): Counts | null {
  if (!protocol) return null;
  const pairs: [string, string][] = [];
  for (const run of runs) {
    const [truth, named] = [valuesOf(system, protocol, run, label), predictionsOf(protocol, run, label)];
    if (truth && named) truth.forEach((value, i) => pairs.push([value, named[i] ?? ""]));
  }
  if (pairs.length === 0) return null;
  const occurring = new Set(pairs.flat());
  const classes = [...new Set([...classesOf(system, label), ...occurring])].filter((one) => occurring.has(one));
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
