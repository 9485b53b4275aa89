// Where on each map a touch sensor matters: the neurons' weights for it.

import { element, fill } from "../parts/dom";
import { valuesPicture } from "../parts/map_picture";
import type { ChannelData } from "../parts/data";
import type { State, TaxelAnswer } from "./data";
import type { Model } from "./model";

const kWidth = 220;

export function taxelAnswer(answer: TaxelAnswer, state: State, model: Model): HTMLElement[] {
  const head = element("h3", {}, [`Touch sensor ${answer.name}`]);
  const maps = state.maps.flatMap(({ module, grid, classes, neuron_classes }) => {
    const weights = answer.maps[module];
    if (weights === undefined || weights.length === 0) return [];
    const onChoose = (neuron: number) => void model.askNeuron(module, neuron);
    const label = `Where on ${module} ${answer.name} matters`;
    const picture = valuesPicture(grid, { label, size: kWidth, onChoose });
    picture.setValues(weights);
    picture.setMarks(neuron_classes, classes);
    return [element("p", { class: "small muted" }, [`Its weight for each neuron of ${module}: light where it matters.`]), picture.element];
  });
  const none = element("p", { class: "empty" }, ["No map listens to it."]);
  return maps.length === 0 ? [head, none] : [head, ...maps];
}

/** For those who cannot click on the hand. */
export function taxelChoice(model: Model): HTMLElement {
  const list = element("select", { "aria-label": "Touch sensor", class: "taxel-choice" });
  let listed = "";
  list.addEventListener("change", () => list.value !== "" && void model.askTaxel(Number(list.value)));
  model.shownState.watch((state) => {
    const channel = state?.channels.find(({ name }) => name === "touch");
    const text = JSON.stringify(channel ?? null);
    if (text !== listed) fill(list, options(channel));
    listed = text;
    list.hidden = channel === undefined;
  });
  model.question.watch((question) => (list.value = question?.about === "taxel" ? String(question.element) : ""));
  return list;
}

function options(channel: ChannelData | undefined): HTMLOptionElement[] {
  const none = element("option", { value: "" }, ["touch sensor …"]);
  return [none, ...(channel?.elements ?? []).map((name, i) => element("option", { value: i }, [name]))];
}
