// The last part of a sound, sample by sample.

import type uPlot from "uplot";

import type { ChannelData } from "../../parts/data";
import type { Model } from "../session/model";
import { axes, tickWords, type Plot } from "./strip_axes";
import { themeColour } from "../page/theme_colours";

export function wavePlot(channel: ChannelData, model: Model): Plot {
  const wave: uPlot.Series = {
    label: channel.name,
    stroke: themeColour("accent"),
    width: 1,
    points: { show: false },
  };
  const options = {
    scales: { x: { time: false }, y: { range: even } },
    axes: axes({ values: tickWords }),
    series: [{}, wave],
    cursor: { show: false },
  };
  return { options, data: () => samples(channel, model) };
}

/** A range symmetric about 0 if there are negative values. */
function even(_: uPlot, low: number | null, high: number | null): [number, number] {
  const most = Math.max(Math.abs(low ?? 0), Math.abs(high ?? 0), 1e-9) * 1.1;
  return (low ?? 0) < 0 ? [-most, most] : [0, most];
}

function samples(channel: ChannelData, model: Model): uPlot.AlignedData {
  const values = model.frame.value?.channels[channel.name] ?? [];
  return [values.map((_, i) => i + 1 - values.length), values];
}
