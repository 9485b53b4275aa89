// The controls of a system's section: protocol, label and run. They remain visible while its
// figures are visible.

import { choice, segments } from "../../parts/controls";
import { element, fill, uniqueId, type Child } from "../../parts/dom";
import { percent } from "../../parts/numbers";
import { foldAccuracies } from "../maps/shown_map";
import { seedWords } from "./origin";
import type { Selection } from "./selection";
import { protocolName } from "./words";

/** With `first` before its controls. */
export function toolbar(selection: Selection, first: Child[] = []): HTMLElement {
  const names = selection.system.protocols.map(protocolName);
  const protocols = choice("Protocol", names, selection.protocolIndex, (index) => selection.setProtocol(index));
  const [labels, runs, maps] = [element("span"), element("span"), element("span")];
  const shown = { protocol: -1, label: -1 };
  const redraw = () => {
    fill(maps, [mapControl(selection)]);
    const { protocolIndex, labelIndex } = selection;
    if (shown.protocol === protocolIndex && shown.label === labelIndex) return;
    if (shown.protocol !== protocolIndex) fill(runs, [runControl(selection)]);
    Object.assign(shown, { protocol: protocolIndex, label: labelIndex });
    protocols.set(protocolIndex);
    const change = (index: number) => {
      shown.label = index; // the control keeps the focus
      selection.setLabel(index);
    };
    fill(labels, [labelControl(selection, change)]);
  };
  redraw();
  selection.listen(redraw);
  const attributes = { class: "controls toolbar", role: "group", "aria-label": "Selection" };
  return element("div", attributes, [...first, protocols.element, labels, runs, maps]);
}

/** Which of several trainings is shown. */
function mapControl(selection: Selection): Child {
  const { protocol, run, folds, fold, canShowSaved } = selection;
  if (!protocol || !run || folds === 0) return null;
  const word = protocol.protocol === "k_folds" ? "fold" : "training";
  const names = foldAccuracies(protocol, run).map((accuracy, i) => `${word} ${i + 1} of ${folds}: ${percent(accuracy)}`);
  const all = canShowSaved ? ["all samples, saved system", ...names] : names;
  const before = all.length - names.length;
  const index = fold === null ? 0 : fold + before;
  return choice("Map", all, index, (chosen) => selection.setFold(chosen < before ? null : chosen - before)).element;
}

const kFew = 4;

function labelControl({ labels, labelIndex }: Selection, change: (index: number) => void): Child {
  const isShort = labels.length <= kFew && labels.join("").length < 48;
  if (isShort) return segments("Label", labels, labelIndex, change);
  return choice("Label", labels, labelIndex, change).element;
}

/** A slider; the arrow keys select the previous or next run. One run needs no choice. */
function runControl(selection: Selection): Child {
  const count = selection.protocol?.runs.length ?? 0;
  if (count < 2) {
    const seed = seedWords(selection) || "no run";
    return element("span", { class: "control" }, [element("span", { class: "name" }, ["Seed"]), seed]);
  }
  const id = uniqueId("run");
  const slider = element("input", { type: "range", id, min: 0, max: count - 1, step: 1 });
  const words = element("output", { for: id, class: "run-words" });
  const show = () => {
    slider.value = String(selection.runIndex);
    words.textContent = seedWords(selection);
    slider.setAttribute("aria-valuetext", seedWords(selection));
  };
  show();
  selection.listen(show);
  slider.addEventListener("input", () => selection.setRun(Number(slider.value)));
  return element("span", { class: "control" }, [element("label", { for: id }, ["Seed"]), slider, words]);
}
