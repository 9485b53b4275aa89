// Made-up things of the report's fixture, and what was felt of them.

import type { ChannelData, ThingData } from "../../src/parts/data";
import type { MomentData } from "../../src/report/page/unpacked";
import { kShapeOf, randomNumbers, range, round } from "./report_runs";

export function touchElements(): string[] {
  return [1, 2, 3].flatMap((finger) =>
    [
      ["proximal", 7],
      ["distal", 8],
    ].flatMap(([segment, count]) => range(Number(count)).map((i) => `finger${finger}_${segment}_${i + 1}`)),
  );
}

export const kTouch: ChannelData = { name: "touch", unit: "N", elements: touchElements(), shape: [45] };

export const kJoints: ChannelData = {
  name: "joints",
  unit: "deg",
  elements: [1, 2, 3].flatMap((finger) => [`finger${finger}_proximal`, `finger${finger}_distal`]),
  shape: [6],
};

const kNoThing = { top_diameter: 0, material: "wood", hardness: "", colour: null, mass: null };

export function things(): ThingData[] {
  return [
    {
      ...kNoThing,
      name: "boccia",
      shape: "sphere",
      size: [80, 80, 80],
      material: "plastic",
      hardness: "hard",
      colour: [0.75, 0.2, 0.18],
      mass: 0.28,
    },
    {
      ...kNoThing,
      name: "boule",
      shape: "sphere",
      size: [74, 74, 74],
      material: "steel",
      hardness: "hard",
      colour: [0.62, 0.64, 0.67],
      mass: 0.7,
    },
    {
      ...kNoThing,
      name: "cylinder",
      shape: "cylinder",
      size: [70, 70, 150],
      colour: [0.76, 0.6, 0.38],
      mass: 0.4,
    },
    {
      ...kNoThing,
      name: "block_1",
      shape: "block",
      size: [90, 60, 150],
      colour: [0.35, 0.5, 0.62],
      mass: 0.6,
    },
    {
      ...kNoThing,
      name: "cone",
      shape: "cone",
      size: [80, 80, 120],
      top_diameter: 30,
      colour: [0.45, 0.6, 0.4],
    },
    { ...kNoThing, name: "egg", shape: "ellipsoid", size: [60, 60, 90] },
    { ...kNoThing, name: "pill", shape: "capsule", size: [50, 50, 120], colour: [0.85, 0.75, 0.3] },
    { ...kNoThing, name: "a mesh", shape: "mesh", size: [70, 50, 60] },
    { ...kNoThing, name: "sandpaper", shape: null, size: null, material: "sandpaper", hardness: "rough" },
  ];
}

export function moment(name: string, seed: number, trial: number): MomentData {
  const random = randomNumbers(seed);
  const times = range(60).map((i) => round(i * 0.1));
  const peaks = kTouch.elements.map(() => (random() < 0.35 ? 1 + 4 * random() : 0));
  const touch = times.map((time) => peaks.map((peak) => round(peak / (1 + Math.exp(-(time - 3.5) * 3)))));
  const joints = times.map((time) =>
    kJoints.elements.map((_, i) => round(30 * Math.min(1, time / 4) - (i % 2) * 70 * (1 - time / 6))),
  );
  return {
    labels: { object: name, shape: kShapeOf[name] ?? "", trial: String(trial) },
    channels: [
      { channel: kTouch, rate: 10, frame: 50, time: 5, values: touch[50] ?? [], times, series: touch },
      { channel: kJoints, rate: 10, frame: 50, time: 5, values: joints[50] ?? [], times, series: joints },
      {
        channel: { name: "height", unit: "mm", elements: ["1"], shape: [1] },
        rate: 10,
        frame: 50,
        time: 5,
        values: [148],
        times,
        series: times.map((_, i) => [i < 30 ? 126 : 148]),
      },
      {
        channel: { name: "spectrum", unit: "", elements: range(100).map((i) => String(i + 1)), shape: [100] },
        rate: 10,
        frame: 50,
        time: 5,
        values: range(100).map((i) => round(1 / (1 + i))),
        times: [],
        series: [],
      },
    ],
  };
}
