// The places of elements, which the report holds once for each channel, at every mention of it.

import type { ChannelData } from "../../parts/data";

/** The report with the `layout` of its channels. */
export function withLayouts(report: unknown): unknown {
  const { placed } = (report ?? {}) as { placed?: ChannelData[] };
  if (!Array.isArray(placed) || placed.length === 0) return report;
  const layouts = new Map(placed.map((channel) => [keyOf(channel), channel.layout]));
  return withThem(report, layouts);
}

const keyOf = ({ name, elements }: ChannelData) => JSON.stringify([name, elements]);

function withThem(value: unknown, layouts: ReadonlyMap<string, ChannelData["layout"]>): unknown {
  if (Array.isArray(value)) return value.some((one) => typeof one === "object") ? value.map((one) => withThem(one, layouts)) : value;
  if (typeof value !== "object" || value === null) return value;
  const made = Object.fromEntries(Object.entries(value).map(([name, one]) => [name, withThem(one, layouts)]));
  if (!isChannel(value)) return made;
  const layout = layouts.get(keyOf(value));
  return layout === undefined ? made : { ...made, layout };
}

function isChannel(value: object): value is ChannelData {
  return "name" in value && "elements" in value && Array.isArray(value.elements) && "shape" in value;
}
