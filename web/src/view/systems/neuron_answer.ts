// The class of a neuron, its weights projected onto the hand, and the nearest explorations.

import type { ChannelData, ChannelPlanes } from "../../parts/data";
import { element } from "../../parts/dom";
import { neuronWords } from "../../parts/maps/grid";
import { handMap } from "../../parts/hands/hand_map";
import { capital, readable, withUnit } from "../../parts/numbers";
import type { NeuronAnswer, State } from "../data";
import { describe } from "../page/labels";
import type { Model } from "../session/model";

const kWidth = 230;
const kMostNear = 5;

export function neuronAnswer(answer: NeuronAnswer, state: State, model: Model): HTMLElement[] {
  const map = state.maps.find(({ module }) => module === answer.map);
  const where = map === undefined ? `neuron ${answer.neuron + 1}` : neuronWords(map.grid, answer.neuron);
  const head = element("h3", {}, [capital(where)]);
  const says =
    answer.answer === null ? "Class: none" : `Class: ${answer.answer}`;
  const planes = [...answer.planes]
    .sort((one, other) => rank(one) - rank(other))
    .map(({ channel, ...rest }) => plane({ ...rest, channel: placedAs(channel, state) }))
    .filter((one) => one !== null);
  return [head, element("p", { class: "closer-answer" }, [says]), ...nearest(answer, state.label, model), ...planes];
}

function nearest({ nearest: near }: NeuronAnswer, label: string | null, model: Model): HTMLElement[] {
  if (near.length === 0) return [];
  const items = near.slice(0, kMostNear).map(({ exploration, labels, distance }) => {
    const go = () => void model.send({ command: "seek", exploration, frame: 0 });
    const words = describe(labels, label) || `exploration ${exploration + 1}`;
    const button = element(
      "button",
      { type: "button", class: "quiet link-button", title: "Play it", onclick: go },
      [words],
    );
    return element("li", {}, [button, element("span", { class: "number muted" }, [readable(distance)])]);
  });
  const list = element("ol", { class: "nearest" }, items);
  return [element("div", { class: "near" }, [element("h4", {}, ["Nearest explorations"]), list])];
}

/** Touch first, then the channel with most elements. */
function rank({ channel }: ChannelPlanes): number {
  return channel.name.startsWith("touch") ? Number.NEGATIVE_INFINITY : -channel.elements.length;
}

/** The channel with the places that the state has for it. */
function placedAs(channel: ChannelData, state: State): ChannelData {
  const layout = state.channels.find(({ name }) => name === channel.name)?.layout;
  return layout === undefined ? channel : { ...channel, layout };
}

function plane({ channel, unit, values }: ChannelPlanes): HTMLElement | null {
  const own = values[0];
  if (own === undefined || own.length === 0) return null;
  if (own.length === 1)
    return element("p", { class: "small" }, [`${channel.name}: ${withUnit(readable(own[0]), unit)}`]);
  const label = `Weights for ${channel.name}`;
  const picture = handMap(channel, { label, unit, size: kWidth });
  picture.setValues(own);
  return element("div", { class: "plane" }, [element("h4", {}, [channel.name]), picture.element]);
}
