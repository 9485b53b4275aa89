// The weights of a touch sensor in each neuron of each map.

import { element, fill } from "../../parts/dom";
import { valuesPicture } from "../../parts/maps/map_picture";
import type { ChannelData } from "../../parts/data";
import type { State, TaxelAnswer } from "../data";
import type { Model } from "../session/model";

const kWidth = 220;

export function taxelAnswer(answer: TaxelAnswer, state: State, model: Model): HTMLElement[] {
  const head = element("h3", {}, [`Touch sensor ${answer.name}`]);
  const maps = state.maps.flatMap(({ module, grid, classes, neuron_classes }) => {
    const weights = answer.maps[module];
    if (weights === undefined || weights.length === 0) return [];
    const onChoose = (neuron: number) => void model.askNeuron(module, neuron);
    const label = `Weight of ${answer.name} in ${module}`;
    const picture = valuesPicture(grid, { label, size: kWidth, onChoose });
    picture.setValues(weights);
    picture.setMarks(neuron_classes, classes);
    return [
      element("p", { class: "small muted" }, [
        `How much each neuron of ${module} depends on this sensor (bright: strongly)`,
      ]),
      picture.element,
    ];
  });
  const none = element("p", { class: "empty" }, ["It is not an input of any map."]);
  return maps.length === 0 ? [head, none] : [head, ...maps];
}

/** An alternative to clicking on the hand. */
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
  model.question.watch(
    (question) => (list.value = question?.about === "taxel" ? String(question.element) : ""),
  );
  return list;
}

function options(channel: ChannelData | undefined): HTMLOptionElement[] {
  const none = element("option", { value: "" }, ["touch sensor …"]);
  return [none, ...(channel?.elements ?? []).map((name, i) => element("option", { value: i }, [name]))];
}
