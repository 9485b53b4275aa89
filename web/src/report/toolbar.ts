// The controls of a system's section: protocol, label and run. They remain visible while its
// figures are visible.

import { choice, segments } from "../parts/controls";
import { element, fill, uniqueId, type Child } from "../parts/dom";
import type { Selection } from "./selection";
import { protocolName } from "./words";

export function toolbar(selection: Selection): HTMLElement {
  const names = selection.system.protocols.map(protocolName);
  const protocols = choice("Protocol", names, selection.protocolIndex, (index) =>
    selection.setProtocol(index),
  );
  const labels = element("span", { class: "control-place" });
  const runs = element("span", { class: "control-place" });
  const redraw = () => {
    fill(labels, [labelControl(selection)]);
    fill(runs, [runControl(selection)]);
  };
  redraw();
  let protocol = selection.protocolIndex;
  selection.listen(() => {
    if (protocol === selection.protocolIndex) return;
    protocol = selection.protocolIndex;
    redraw();
  });
  const attributes = { class: "controls toolbar", role: "group", "aria-label": "Selection" };
  return element("div", attributes, [protocols.element, labels, runs]);
}

const kFew = 4;

function labelControl(selection: Selection): Child {
  const { labels, labelIndex } = selection;
  const isShort = labels.length <= kFew && labels.join("").length < 48;
  const change = (index: number) => selection.setLabel(index);
  if (isShort) return segments("Label", labels, labelIndex, change);
  return choice("Label", labels, labelIndex, change).element;
}

/** A slider; the arrow keys select the previous or next run. */
function runControl(selection: Selection): Child {
  const count = selection.protocol?.runs.length ?? 0;
  const id = uniqueId("run");
  const slider = element("input", { type: "range", id, min: 0, max: Math.max(0, count - 1), step: 1 });
  slider.value = String(selection.runIndex);
  slider.disabled = count < 2;
  const words = element("output", { for: id, class: "run-words" }, [runWords(selection)]);
  slider.setAttribute("aria-valuetext", runWords(selection));
  slider.addEventListener("input", () => {
    selection.setRun(Number(slider.value));
    words.textContent = runWords(selection);
    slider.setAttribute("aria-valuetext", runWords(selection));
  });
  return element("span", { class: "control" }, [element("label", { for: id }, ["Seed"]), slider, words]);
}

export function runWords(selection: Selection): string {
  const { run, system } = selection;
  if (!run) return "no run";
  const recording =
    system.recordings.length > 1 ? `, ${system.recordings[run.recording] ?? "recording ?"}` : "";
  return `${run.seed}${recording}`;
}
