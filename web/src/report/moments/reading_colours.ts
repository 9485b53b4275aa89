// The colours of a channel's readings: those of touch for the touch sensors of a skin, else the
// sequence of all numbers.

import { sequenceColour } from "../../parts/maps/colour_maps";
import { rangeOf, readable, withUnit } from "../../parts/numbers";
import { isSkin } from "../../parts/hands/skin_layout";
import { touchColour, touchEnd } from "../../parts/hands/touch_colours";
import type { MomentChannel } from "../page/unpacked";

export interface ReadingColours {
  colour: (share: number) => string;
  range: readonly [number, number]; // of the whole exploration, so that its moments can be compared
}

export function readingColours(of: MomentChannel): ReadingColours {
  if (isTouch(of)) return { colour: touchColour, range: [0, endOf(of)] };
  const [low, high] = rangeOf(of.series.flatMap((row) => rangeOf(row) ?? [])) ?? rangeOf(of.values) ?? [0, 1];
  return { colour: sequenceColour, range: [low, high] };
}

/** A sentence if some readings are stronger than the end of the scale; begins with a space. */
export function colourNote(of: MomentChannel): string {
  const end = isTouch(of) ? endOf(of) : Number.POSITIVE_INFINITY;
  if (!mostOf(of).some((most) => most > end)) return "";
  return ` Stronger touch has the colour of ${withUnit(readable(end), of.channel.unit)}.`;
}

/** Touch of a skin, or a change of it that is counted upwards only. */
function isTouch({ channel, series, values }: MomentChannel): boolean {
  const isOfSensors = channel.name.startsWith("touch") && isSkin(channel);
  return isOfSensors && [values, ...series].every((frame) => frame.every((value) => (value ?? 0) >= 0));
}

const endOf = (of: MomentChannel) => touchEnd(mostOf(of), of.channel.unit);

/** The strongest reading of each element. */
function mostOf({ channel, series, values }: MomentChannel): number[] {
  const frames = series.length > 0 ? series : [values];
  return channel.elements.map((_, i) => Math.max(0, ...frames.map((frame) => Math.abs(frame[i] ?? 0))));
}
