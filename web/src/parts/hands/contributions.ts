// Contributions of sensors to a decision between two classes: positive where the input is more similar
// to the nearest neuron of the first class. Lightness rises from the other class to the first one, so
// that pictures are readable in grey.

import type { ChannelData } from "../data";
import { readable, withUnit } from "../numbers";
import { handMap, type HandOptions, type HandPicture } from "./hand_map";

type Values = readonly (number | null)[];

/** The contributions of the elements of a channel, or of the output of a module. */
export interface Contributed {
  name: string;
  elements: readonly string[]; // missing names are numbers
  values: Values;
}

export interface ContributionPicture extends HandPicture {
  /** `end` is that of the scale in both directions. */
  show(values: Values, end: number): void;
}

export function contributionPicture(channel: ChannelData, options: Omit<HandOptions, "label">): ContributionPicture {
  const picture = handMap(channel, { ...options, label: `Contributions of ${channel.name}` });
  return { ...picture, show: (values, end) => picture.setValues(values, [-end, end]) };
}

/** The greatest magnitude; 1 if all are 0, so that it can be the end of a scale. */
export function greatestOf(all: readonly Values[]): number {
  return all.flat().reduce<number>((most, value) => Math.max(most, Math.abs(value ?? 0)), 0) || 1;
}

export interface ElementContribution {
  name: string;
  element: string;
  value: number;
}

/** The elements that contribute most, for either class. */
export function strongestOf(all: readonly Contributed[], most: number): ElementContribution[] {
  return all
    .flatMap(({ name, elements, values }) =>
      values.map((value, i) => ({ name, element: elements[i] ?? String(i + 1), value: value ?? 0 })),
    )
    .filter(({ value }) => value !== 0)
    .sort((one, other) => Math.abs(other.value) - Math.abs(one.value))
    .slice(0, most);
}

/** With a sign. */
export function signed(value: number, unit: string): string {
  return `${value > 0 ? "+" : ""}${withUnit(readable(value), unit)}`;
}

export function coloursInWords(nearest: string, other: string): string {
  return `Bright: closer to ${nearest} than to ${other}. Dark: the reverse.`;
}
