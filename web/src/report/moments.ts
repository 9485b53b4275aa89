// The sensor readings during an exploration: touch on the hand at one moment, and joints and
// touch over time.

import { choice } from "../parts/controls";
import { element, fill, uniqueId, type Child } from "../parts/dom";
import { figure } from "../parts/figure";
import { handLayout } from "../parts/hand_layout";
import { handMap } from "../parts/hand_map";
import { rangeOf, readable } from "../parts/numbers";
import { courseFigure } from "./courses";
import type { MomentChannel, MomentData, SystemReport } from "./data";
import { capital } from "./groups";
import { momentIndex, momentTime } from "./moment_time";
import { valuesFigure, valuesTable } from "./moment_values";
import { systemName } from "./words";

export function momentFigures(system: SystemReport): Child[] {
  const names = system.moments.map((moment, i) => momentName(system, moment, i));
  const place = element("div", { class: "figures" });
  const show = (index: number) => {
    const moment = system.moments[index];
    if (moment) fill(place, figuresOf(system, moment, names[index] ?? ""));
  };
  show(0);
  return [element("div", { class: "controls" }, [choice("Exploration of", names, 0, show).element]), place];
}

/** The label of the study if it is known, because explorations may have many labels. */
function momentName(system: SystemReport, { labels }: MomentData, index: number): string {
  const own =
    labels[system.protocols[0]?.label ?? ""] ?? Object.values(labels)[0] ?? `exploration ${index + 1}`;
  return labels["trial"] === undefined ? own : `${own}, trial ${labels["trial"]}`;
}

function figuresOf(system: SystemReport, moment: MomentData, name: string): Child[] {
  const isHand = (one: MomentChannel) => handLayout(one.channel.elements) !== null;
  const size = (one: MomentChannel) => (isHand(one) ? one.channel.elements.length : 0);
  // Channels on the hand come first, touch before joints.
  const channels = [...moment.channels].sort((one, other) => size(other) - size(one));
  return channels.flatMap((one) => {
    const isOnHand = isHand(one);
    const hasCourse = one.series.length > 1;
    return [
      isOnHand ? handFigure(system, one, name) : null,
      hasCourse ? courseFigure(system, moment, one, name) : null,
      isOnHand || hasCourse ? null : valuesFigure(system, one, name),
    ];
  });
}

/** The hand at a moment, selected by a slider if there is more than one. */
function handFigure(system: SystemReport, of: MomentChannel, name: string): Child {
  const { channel, series, times } = of;
  const picture = handMap(channel, {
    label: `${channel.name} while exploring ${name}`,
    unit: channel.unit,
    size: 380,
  });
  const range = rangeOf(series.flatMap((values) => rangeOf(values) ?? [])) ?? rangeOf(of.values) ?? [0, 1];
  const frames = [...series.map((values, i) => ({ time: times[i] ?? 0, values }))];
  let shown = { time: momentTime(of), values: of.values };
  const title = element("p", { class: "small what" });
  const show = () => {
    picture.setValues(shown.values, [Math.min(0, range[0]), range[1]]);
    title.textContent = `${name}, at ${readable(shown.time)} s`;
  };
  show();
  const slider =
    frames.length < 2 ? [] : [timeSlider(of, (index) => ((shown = frames[index] ?? shown), show()))];
  return figure({
    title: `${capital(channel.name)} at a moment`,
    file: `${systemName(system)}-${channel.name}-moment`,
    controls: slider,
    body: element("div", {}, [title, picture.element]),
    picture: () => picture.svg,
    numbers: () => valuesTable({ ...of, values: shown.values }),
    note: "Initially the moment of maximum touch is shown.",
  });
}

function timeSlider(of: MomentChannel, onChange: (index: number) => void): HTMLElement {
  const id = uniqueId("time");
  const slider = element("input", { type: "range", id, min: 0, max: of.times.length - 1, step: 1 });
  slider.value = String(momentIndex(of));
  const say = () => slider.setAttribute("aria-valuetext", `${readable(of.times[Number(slider.value)])} s`);
  say();
  slider.addEventListener("input", () => {
    say();
    onChange(Number(slider.value));
  });
  return element("span", { class: "control" }, [element("label", { for: id }, ["Time"]), slider]);
}
