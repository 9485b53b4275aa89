// The sensor readings of an exploration: touch on the hand at one moment, and joints and touch over
// time. The exploration is that of a sample of the selected neuron, and plays.

import { choice } from "../../parts/controls";
import { element, fill, uniqueId, type Child } from "../../parts/dom";
import { figure } from "../../parts/figure";
import { handMap } from "../../parts/hands/hand_map";
import { isSkin } from "../../parts/hands/skin_layout";
import { capital, readable, seconds } from "../../parts/numbers";
import { courseFigure } from "./courses";
import { fitting } from "../page/fitting";
import { Exploration, frameAt, momentTime } from "./exploration";
import { valuesFigure, valuesTable } from "./moment_values";
import { shownOf } from "../page/origin";
import { colourNote, readingColours } from "./reading_colours";
import type { Samples } from "./samples";
import type { MomentChannel, SystemReport } from "../page/unpacked";
import { systemName } from "../page/words";

export function momentFigures(system: SystemReport, samples: Samples): Child[] {
  const place = element("div", { class: "figures" });
  const player = element("span", { class: "player" });
  let shown: Exploration | null = null;
  const list = choice("Exploration of", samples.names, 0, (index) => samples.choose(index));
  const show = () => {
    const moment = samples.moment;
    if (!moment) return;
    shown?.stop();
    shown = new Exploration(moment, samples.name);
    list.set(samples.index);
    fill(place, figuresOf(system, shown));
    fill(player, playerOf(shown));
    if (samples.plays) shown.playFromStart();
  };
  show();
  samples.listen(show);
  return [element("div", { class: "controls" }, [list.element, player]), place];
}

function playerOf(exploration: Exploration): Child[] {
  const [from, to] = exploration.times;
  if (to <= from) return [];
  const id = uniqueId("time");
  const slider = element("input", { type: "range", id, min: from, max: to, step: (to - from) / 200 });
  slider.addEventListener("input", () => {
    exploration.stop();
    exploration.setTime(Number(slider.value));
  });
  const button = element("button", { type: "button" });
  button.addEventListener("click", () => (exploration.plays ? exploration.stop() : exploration.play()));
  const words = element("output", { for: id, class: "run-words" });
  const show = () => {
    slider.value = String(exploration.time);
    words.textContent = seconds(exploration.time);
    slider.setAttribute("aria-valuetext", seconds(exploration.time));
    button.textContent = exploration.plays ? "Stop" : "Play";
  };
  show();
  exploration.listen(show);
  return [button, element("span", { class: "control" }, [element("label", { for: id }, ["Time"]), slider, words])];
}

function figuresOf(system: SystemReport, exploration: Exploration): Child[] {
  const size = ({ channel }: MomentChannel) => (isSkin(channel) ? channel.elements.length : 0);
  // Channels on the skin come first, touch before joints.
  const channels = [...exploration.moment.channels].sort((one, other) => size(other) - size(one));
  return channels.flatMap((one) => {
    const isOnSkin = isSkin(one.channel);
    const hasCourse = one.series.length > 1;
    return [
      isOnSkin ? skinFigure(system, one, exploration) : null,
      hasCourse ? courseFigure(system, one, exploration) : null,
      isOnSkin || hasCourse ? null : valuesFigure(system, one, exploration.name),
    ];
  });
}

/** The skin at the time of the exploration; at first at the moment of greatest contact. */
function skinFigure(system: SystemReport, of: MomentChannel, exploration: Exploration): Child {
  const { channel, series } = of;
  const { name } = exploration;
  const { colour, range } = readingColours(of);
  const picture = handMap(channel, {
    label: `${channel.name} while exploring ${name}`,
    unit: channel.unit,
    size: fitting(380),
    colour,
  });
  const values = () =>
    exploration.time === momentTime(of) ? of.values : (series[frameAt(of, exploration.time)] ?? of.values);
  const words = () => `${name}, at ${readable(Math.round(exploration.time * 100) / 100)} s`;
  const title = element("p", { class: "small what" });
  const show = () => {
    picture.setValues(values(), [Math.min(0, range[0]), range[1]]);
    title.textContent = words();
  };
  show();
  exploration.listen(show);
  return figure({
    title: `${capital(channel.name)} at a moment`,
    file: `${systemName(system)}-${channel.name}-moment`,
    body: element("div", {}, [title, picture.element]),
    picture: () => picture.svg,
    numbers: () => valuesTable({ ...of, values: values() }),
    about: () => shownOf(system, words()),
    note: colourNote(of).trim(),
    hint: "Starts at the moment of greatest contact.",
  });
}
