// Made-up systems that have learned, for the report's fixture: their graph, what their maps hold.

import type { ChannelData, ChannelPlanes, GraphData, GridData, ModuleData } from "../../src/parts/data";
import type { DecidingData, ReceptiveFields, TrainedData } from "../../src/report/page/unpacked";
import { randomNumbers, range, round, uMatrixOf } from "./report_runs";

function module(
  name: string,
  type: string,
  inputs: string[],
  shape: number[],
  more: Partial<ModuleData> = {},
): ModuleData {
  return {
    name,
    type,
    text: `What a ${type} does.`,
    inputs: inputs.map((one, i) => ({ port: String(i), module: one })),
    shape,
    sparse: false,
    rate: "frame",
    learns: false,
    parameters: {},
    not_given: [],
    ...more,
  };
}

export function handGraph(): GraphData {
  return {
    modules: [
      module("height_mm", "channel", [], [1], { channel: "height" }),
      module("height", "one_hot", ["height_mm"], [10]),
      module("wrist_deg", "channel", [], [1], { channel: "wrist" }),
      module("wrist", "one_hot", ["wrist_deg"], [10]),
      module("joints_deg", "channel", [], [6], { channel: "joints" }),
      module("joints", "one_hot", ["joints_deg"], [6, 10]),
      module("touch", "channel", [], [45], { channel: "touch" }),
      module("hand", "t_mpsom", ["wrist", "height"], [5, 5], {
        learns: true,
        parameters: { arbor_sigma: "1.0", combination: '"multiplied"' },
        not_given: ["arbor_sigma"],
      }),
      module("posture", "t_mpsom", ["hand", "joints"], [6, 15], { learns: true }),
      module("felt", "t_mpsom", ["posture", "touch"], [46, 23], { learns: true }),
      module("before", "delay", ["sum"], [46, 23]),
      module("sum", "addition", ["felt", "before"], [46, 23]),
      module("memory", "accumulate", ["sum"], [46, 23], { rate: "exploration" }),
      module("map", "som", ["memory"], [15, 15], {
        learns: true,
        rate: "exploration",
        parameters: { rows: "15", columns: "15" },
      }),
    ],
    map: "map",
    phases: [
      { learn: ["hand", "posture", "felt"], draws: 5000, of: "frames" },
      { learn: ["map"], draws: 1000, of: "explorations" },
    ],
  };
}

export function planes(grid: GridData, channel: ChannelData, unit: string, seed: number): ChannelPlanes {
  const random = randomNumbers(seed);
  const peaks = channel.elements.map(() => [random() * grid.rows, random() * grid.columns]);
  const value = (neuron: number, [row, column]: number[]) => {
    const square =
      (Math.floor(neuron / grid.columns) - (row ?? 0)) ** 2 + ((neuron % grid.columns) - (column ?? 0)) ** 2;
    return round(Math.exp(-square / 18));
  };
  return {
    channel,
    unit,
    values: range(grid.rows * grid.columns).map((neuron) => peaks.map((peak) => value(neuron, peak))),
  };
}

export function fields(
  name: string,
  shape: [number, number],
  input: string,
  axis: 0 | 1,
  elements: number,
): ReceptiveFields {
  const neurons = range(shape[0] * shape[1]);
  const place = (neuron: number) =>
    axis === 0 ? Math.floor(neuron / shape[1]) / shape[0] : (neuron % shape[1]) / shape[1];
  const weights = neurons.map((neuron) =>
    range(elements).map((one) =>
      round(Math.exp(-((one - (place(neuron) + 0.5 / shape[axis]) * elements) ** 2) / 4)),
    ),
  );
  return { module: name, shape, input, axis, elements, neurons, weights };
}

export function trained(
  grid: GridData,
  classes: string[],
  allPlanes: ChannelPlanes[],
  receptive: ReceptiveFields[],
): TrainedData {
  const random = randomNumbers(9);
  const neurons = range(grid.rows * grid.columns);
  return {
    file: "out/system.somato",
    seed: 1,
    classes,
    neuron_classes: neurons.map(() => (random() < 0.15 ? Math.floor(random() * classes.length) : null)),
    u_matrix: uMatrixOf(grid, 1),
    winners: [],
    hits: neurons.map(() => (random() < 0.12 ? 1 + Math.floor(random() * 3) : 0)),
    planes: allPlanes,
    receptive_fields: receptive,
  };
}

/** Contributions of two channels and of a module, which has too many elements for a list, to three decisions. */
export function deciding(channels: ChannelData[], classes: string[]): DecidingData {
  const random = randomNumbers(31);
  const kinds = [
    { sample: 2, tests: 20, predicted: classes[1]!, confused: 7 },
    { sample: 8, tests: 20, predicted: classes[3]!, confused: 1 },
    { sample: 11, tests: 20, predicted: "", confused: 0 },
  ];
  const sources = channels.map((channel) => ({
    channel,
    is_channel: true,
    values: kinds.map(() => channel.elements.map((_, i) => (i === 1 ? null : round(random() - 0.45)))),
  }));
  const module = { channel: { name: "felt", unit: "", elements: [], shape: [46, 23] }, is_channel: false, values: [] };
  const decisions = kinds.map((kind, i) => {
    const sums = [...sources.map(({ values }) => values[i]!.reduce<number>((sum, value) => sum + (value ?? 0), 0)), 0.25];
    const [nearest, other] = i === 2 ? [classes[2]!, classes[4]!] : [classes[0]!, kind.predicted];
    const of_nearest = 1.5 + i;
    const of_other = of_nearest + sums.reduce((sum, one) => sum + one, 0);
    return { ...kind, label: i === 2 ? classes[4]! : classes[0]!, answer: nearest, nearest, other, of_nearest, of_other, sums };
  });
  return { label: "object", unit: "N", products: false, sources: [...sources, module], decisions };
}
