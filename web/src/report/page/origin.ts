// The content of a system's figures in words and its origin, for saved files.

import { fileName, type Shown } from "../../parts/figure";
import { medianFold, type ShownMap } from "../maps/shown_map";
import type { Placed } from "./same_names";
import type { Selection } from "./selection";
import type { SystemReport } from "./unpacked";
import { protocolName, systemName } from "./words";

type Made = Placed<SystemReport> & { somato?: string };

/** For a figure that does not depend on the selection. */
export function shownOf(system: Made, words = "", name = words): Shown {
  const facts: [string, string][] = [
    ["Software", `Somato ${system.somato ?? ""}`],
    ["System", systemName(system)],
    ["Data", system.data_hash],
  ];
  return { words, name: fileName(name), facts: facts.filter(([, value]) => value !== "") };
}

/** For a figure of the selected run. */
export function shownBySelection(selection: Selection): Shown {
  const { system, protocol, label, run } = selection;
  if (!protocol) return shownOf(system);
  const seed = run ? `seed ${seedWords(selection)}` : "";
  const words = [protocolName(protocol), `by ${label}`, seed].filter((one) => one !== "").join(", ");
  const shown = shownOf(system, words, nameOf(selection, [label, seed]));
  return { ...shown, facts: [...shown.facts, ["Selection", words]] };
}

/** For a figure of one map: of all samples of the selected run, of a training that tested some, or of the saved system. */
export function shownOfMap({ kind, samples }: ShownMap, selection: Selection): Shown {
  const { label, system, protocol, run, fold, folds } = selection;
  if (kind === "saved") {
    const shown = shownOfSaved(system);
    const seed = system.trained?.seed ?? null;
    const words = `Trained on all ${samples.length} samples, by ${label}${seed === null ? "" : `, seed ${seed}`}`;
    return { ...shown, words, name: fileName(["saved", label, shown.name].join("-")) };
  }
  const shown = shownBySelection(selection);
  if (kind === "run" || fold === null || !protocol || !run) return shown;
  const isMedian = fold === medianFold(protocol, run) ? ", the fold nearest the median" : "";
  const words = `${shown.words}, fold ${fold + 1} of ${folds}${isMedian}`;
  return { ...shown, words, name: `${shown.name}-fold${fold + 1}`, facts: [...shown.facts, ["Fold", String(fold + 1)]] };
}

/** The protocol and the other `parts` as a part of the name of a file. */
export function nameOf({ protocol }: Selection, parts: string[]): string {
  return [protocol?.protocol ?? "", protocol?.group ?? "", ...parts].filter((one) => one !== "").join("-");
}

/** For a figure of the saved system, which does not depend on the selection. */
export function shownOfSaved(system: Made): Shown {
  const seed = system.trained?.seed ?? null;
  if (seed === null) return shownOf(system, "Trained system");
  const shown = shownOf(system, `Trained system, seed ${seed}`, `seed ${seed}`);
  return { ...shown, facts: [...shown.facts, ["Seed", String(seed)]] };
}

/** "2011", or "2011, recording 3" if there are several. */
export function seedWords({ run, system }: Selection): string {
  if (!run) return "";
  return system.recordings.length > 1 ? `${run.seed}, recording ${run.recording + 1}` : String(run.seed);
}
