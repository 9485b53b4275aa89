// The present values of channels: a bar for each of few elements in the range that they have had, or
// the samples of a fast channel as a line. Elements with a unit share their range.

import type { ChannelData, NumberOrNull } from "../../parts/data";
import { element, fill, write } from "../../parts/dom";
import { digits, withUnit } from "../../parts/numbers";
import type { Frame } from "../data";
import { Plotter } from "../systems/plotter";

const kMostBars = 12;

export class Senses {
  readonly root = element("div", { class: "senses" });
  private shown: { channel: string; show: (values: readonly NumberOrNull[]) => void }[] = [];

  build(channels: readonly ChannelData[]): void {
    const all = channels.map((channel) => ({ channel: channel.name, ...senseOf(channel) }));
    this.shown = all;
    this.root.hidden = all.length === 0;
    fill(
      this.root,
      all.map(({ root }) => root),
    );
  }

  show(frame: Frame): void {
    for (const { channel, show } of this.shown) show(frame.channels[channel] ?? []);
  }
}

interface Sense {
  root: HTMLElement;
  show: (values: readonly NumberOrNull[]) => void;
}

/** A fast channel with one element is sent as its latest samples. */
function senseOf(channel: ChannelData): Sense {
  const bars = barsOf(channel);
  const plotter = new Plotter(`${channel.name}: the latest samples`);
  plotter.root.hidden = true;
  const title = element("h3", {}, [channel.name]);
  const root = element("div", { class: "sense" }, [title, bars.root, plotter.root]);
  return {
    root,
    show: (values) => {
      const isFast = values.length > channel.elements.length;
      plotter.root.hidden = !isFast;
      bars.root.hidden = isFast;
      if (isFast) plotter.show(values, null);
      else bars.show(values);
    },
  };
}

function barsOf(channel: ChannelData): Sense {
  const shown = channel.elements.slice(0, kMostBars);
  const common = emptyRange();
  const ranges = shown.map(() => (channel.unit === "" ? emptyRange() : common));
  const fills = shown.map(() => element("span", { class: "bar-fill" }));
  const numbers = shown.map(() => element("span", { class: "number" }));
  const rows = shown.map((name, i) =>
    element("li", { class: "sense-row" }, [
      element("span", { class: "candidate-name", title: name }, [shown.length === 1 ? "" : name]),
      element("span", { class: "bar" }, [fills[i]!]),
      numbers[i]!,
    ]),
  );
  const show = (values: readonly NumberOrNull[]) =>
    shown.forEach((_, i) => {
      const value = values[i] ?? null;
      write(numbers[i]!, withUnit(digits(value), channel.unit));
      fills[i]!.style.width = `${shareIn(ranges[i]!, value) * 100}%`;
    });
  const further = channel.elements.length - shown.length;
  const more = further > 0 ? [element("li", { class: "note" }, [`and ${further} more`])] : [];
  return {
    root: element("ul", { class: "sense-rows" }, [...rows, ...more]),
    show: (values) => {
      shown.forEach((_, i) => widen(ranges[i]!, values[i] ?? null));
      show(values);
    },
  };
}

type Range = [number, number];

function emptyRange(): Range {
  return [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
}

function widen(range: Range, value: NumberOrNull): void {
  if (value === null) return;
  range[0] = Math.min(range[0], value);
  range[1] = Math.max(range[1], value);
}

/** The place of a value in the range, 0 to 1; 0 if the range is not known. */
function shareIn(range: Range, value: NumberOrNull): number {
  return value !== null && range[1] > range[0] ? (value - range[0]) / (range[1] - range[0]) : 0;
}
