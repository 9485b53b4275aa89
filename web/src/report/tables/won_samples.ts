// The samples that the selected neuron wins, each with a button that plays its exploration.

import { element, fill, type Child } from "../../parts/dom";
import { neuronWords } from "../../parts/maps/grid";
import { capital, countOf } from "../../parts/numbers";
import { valuesOf } from "./labels";
import type { Samples } from "../moments/samples";
import type { Selection } from "../page/selection";

/** `onPlay` brings the readings into view. */
export function wonSamples(selection: Selection, samples: Samples, onPlay: () => void): HTMLElement {
  const place = element("div", { class: "won no-print", "aria-live": "polite" });
  const show = () => fill(place, listed(selection, samples, onPlay));
  show();
  selection.listen(show);
  selection.listenToNeuron(show);
  return place;
}

function listed(selection: Selection, samples: Samples, onPlay: () => void): Child[] {
  const { protocol, run, neuron, system, label, grid } = selection;
  if (!protocol || !run || !grid) return [];
  if (neuron === null) return [element("p", { class: "small muted" }, [kHint])];
  const won = run.winners.flatMap((winner, sample) => (winner === neuron ? [sample] : []));
  const words = `${capital(neuronWords(grid, neuron))} wins ${countOf(won.length, "sample")}.`;
  const names = valuesOf(system, protocol, run, label);
  // The samples of other recordings have no readings, and some of a recording are not numbered as in it.
  const isWhole = run.winners.length === (system.samples ?? []).length;
  const isRecording = protocol.protocol !== "test_data" && isWhole && run.recording === system.recording;
  const buttons = won.map((sample) => {
    const index = isRecording ? samples.placeOf(sample) : null;
    if (index === null) return element("span", {}, [names?.[sample] ?? `sample ${sample + 1}`]);
    const play = () => {
      samples.choose(index, true);
      onPlay();
    };
    return element("button", { type: "button", onclick: play }, [`▶ ${samples.names[index] ?? ""}`]);
  });
  return [element("p", { class: "small" }, [words]), element("div", { class: "won-list" }, buttons)];
}

const kHint = "Select a neuron to see the samples it wins, and to mark it in all maps.";
