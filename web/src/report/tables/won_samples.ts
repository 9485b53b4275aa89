// The samples that the selected neuron wins, each with a button that plays its exploration.

import { element, fill, type Child } from "../../parts/dom";
import { neuronWords } from "../../parts/maps/grid";
import { capital, countOf } from "../../parts/numbers";
import { shownMap, valuesOn } from "../maps/shown_map";
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
  const { protocol, run, neuron, system } = selection;
  const shown = shownMap(selection);
  if (!protocol || !run || !shown) return [];
  if (neuron === null) return [element("p", { class: "small muted" }, [kHint])];
  const won = shown.winners.flatMap((winner, i) => (winner === neuron ? [i] : []));
  const words = `${capital(neuronWords(shown.grid, neuron))} wins ${countOf(won.length, "sample")}.`;
  const names = valuesOn(shown, selection);
  // The samples of other recordings have no readings, and some of a recording are not numbered as in it.
  const isWhole = run.winners.length === (system.samples ?? []).length;
  const isRecording = protocol.protocol !== "test_data" && isWhole && run.recording === system.recording;
  const buttons = won.map((i) => {
    const sample = shown.samples[i] ?? i;
    const index = isRecording ? samples.placeOf(sample) : null;
    if (index === null) return element("span", {}, [names?.[i] ?? `sample ${sample + 1}`]);
    const play = () => {
      samples.choose(index, true);
      onPlay();
    };
    return element("button", { type: "button", onclick: play }, [`▶ ${samples.names[index] ?? ""}`]);
  });
  return [element("p", { class: "small" }, [words]), element("div", { class: "won-list" }, buttons)];
}

const kHint = "Select a neuron to see the samples it wins, and to mark it in all maps.";
