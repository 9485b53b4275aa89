// A made-up grasp for the fake server: frames that anyone can work out again.

import type { GraphData, ModuleData } from "../../src/parts/data";
import type { Frame, Reading, Scene, State, Strips, Training } from "../../src/view/data";
import { fakePoses, fakeScene, kTaxels, kThings } from "./fake_hand";

export const kFrames = 60;
export const kRate = 10; // frames a second
export const kGrid = { rows: 15, columns: 15, lattice: "rectangular", topology: "plane" } as const;
export const kExplorations = [0, 1, 2, 3, 4, 5];
/** Unlike their indices, as after explorations that were discarded. */
export const idOf = (exploration: number) => 100 + exploration;
const kNeurons = kGrid.rows * kGrid.columns;

export const thingOf = (exploration: number) => kThings[exploration % kThings.length]!;
export const sceneOf = (exploration: number): Scene => fakeScene(thingOf(exploration));

export function fakeFrame(exploration: number, frame: number): Frame {
  const { joints, touch, height, wrist } = felt(exploration, frame);
  const share = Math.min(1, frame / (kFrames - 1));
  return {
    exploration,
    frame,
    frames: kFrames,
    time: frame / kRate,
    last: frame === kFrames - 1,
    channels: {
      height: [height * 1000],
      wrist: [wrist],
      joints,
      touch,
      touch_change: touch.map((value) => value / 2),
    },
    poses: fakePoses(height, wrist, joints),
    modules: modulesOf(joints, touch, share),
    maps: { map: answerOf(exploration, share) },
    reading: readingOf(exploration, share, touch),
  };
}

/** The end of an exploration that is not recognized. */
export function unknownFrame(exploration: number, novelty = 1.43): Frame {
  const frame = fakeFrame(exploration, kFrames - 1);
  return { ...frame, reading: { ...frame.reading!, answer: "unknown", novelty } };
}

export function fakeStrips(exploration: number): Strips {
  const frames = Array.from({ length: kFrames }, (_, i) => fakeFrame(exploration, i));
  const names = Object.keys(frames[0]!.channels);
  return {
    exploration,
    frames: kFrames,
    frame: frames.map(({ frame }) => frame),
    time: frames.map(({ time }) => time),
    channels: Object.fromEntries(
      names.map((name) => [name, frames.map(({ channels }) => channels[name]!)]),
    ),
  };
}

function felt(exploration: number, frame: number) {
  const closing = Math.min(1, frame / 40);
  const joints = [0, 1, 2].flatMap((finger) => [
    24 * closing - finger,
    -72 + (70 + 4 * (exploration % 3)) * closing,
  ]);
  const touch = kTaxels.map((_, i) => {
    const begins = 24 + ((i * 7) % 23) + (exploration % 3) * 2;
    const strength = ((i * 5 + exploration * 3) % 11) / 4;
    return round(Math.max(0, strength * Math.min(1, (frame - begins) / 10)));
  });
  return {
    joints: joints.map(round),
    touch,
    height: round(0.2 - 0.074 * Math.min(1, frame / 12)),
    wrist: round(-48 + 12 * (exploration % 3)),
  };
}

const round = (value: number) => Math.round(value * 1000) / 1000;

function modulesOf(joints: number[], touch: number[], share: number): Frame["modules"] {
  const code = joints.flatMap((joint, i) =>
    Array.from({ length: 10 }, (_, k) =>
      k === Math.min(9, Math.max(0, Math.floor((joint + (i % 2 ? 75 : 0)) / (i % 2 ? 10.5 : 3)))) ? 1 : 0,
    ),
  );
  const crossed = code.flatMap((one) => touch.map((value) => one * value));
  return {
    joints_deg: { shape: [6], values: joints, folded: false },
    joints: { shape: [60], values: code, folded: false },
    touch: { shape: [45], values: touch, folded: false },
    crossed: { shape: [60, 45], values: crossed, folded: true },
    memory: {
      shape: [60, 45],
      values: crossed.map((value, i) => round(value * 2 + ((i * 13) % 97 < 3 ? share : 0))),
      folded: true,
    },
  };
}

const kHomes = [32, 101, 190]; // of the three things on the map

function answerOf(exploration: number, share: number): Frame["maps"][string] {
  const home = kHomes[exploration % 3]!;
  const [row, column] = [Math.floor(home / 15), home % 15];
  const at = { row: Math.round(7 + (row - 7) * share), column: Math.round(7 + (column - 7) * share) };
  const activity = Array.from({ length: kNeurons }, (_, i) => {
    const away = (Math.floor(i / 15) - at.row) ** 2 + ((i % 15) - at.column) ** 2;
    return round(Math.exp(-away / (24 - 12 * share)));
  });
  return { winner: at.row * 15 + at.column, activity };
}

function readingOf(exploration: number, share: number, touch: number[]): Reading {
  const right = exploration % 3;
  const candidates = kThings.map(({ name }, i) => ({
    name,
    distance: round(
      i === right ? 0.9 - 0.7 * share : 0.8 + 0.11 * i - (i === (right + 1) % 3 ? 0.2 * (1 - share) : 0),
    ),
  }));
  candidates.sort((a, b) => a.distance - b.distance);
  return {
    answer: candidates[0]!.name,
    confidence: round(1 - candidates[0]!.distance / candidates[1]!.distance),
    novelty: null,
    candidates,
    contributions: {
      other: candidates[1]!.name,
      unit: "N",
      // The fifth sensor is not read; sensors with odd numbers speak for the other class.
      channels: { touch: touch.map((value, i) => (i === 4 ? null : round((i % 2 ? -0.1 : 0.1) * value))) },
    },
  };
}

export function fakeTraining(step: number, steps: number): Training {
  const share = step / steps;
  const winners = Array.from({ length: 30 }, (_, sample) => {
    const home = kHomes[sample % 3]!;
    const spread = 7 * (1 - share);
    const row = clamp(Math.round(Math.floor(home / 15) + (((sample * 5) % 7) - 3) * (0.5 + spread / 7)));
    const column = clamp(Math.round((home % 15) + (((sample * 3) % 7) - 3) * (0.5 + spread / 7)));
    return { sample, winner: row * 15 + column, class: kThings[sample % 3]!.name };
  });
  const u_matrix = Array.from({ length: kNeurons }, (_, i) =>
    round(0.2 + share * Math.abs(Math.sin(i / 15 / 2.6) * Math.cos((i % 15) / 3.1)) + 0.05 * ((i * 7) % 5)),
  );
  return {
    system: "tensor_chain",
    module: "map",
    step,
    steps,
    radius: 15 - 14 * share,
    learning_rate: 0.3 - 0.28 * share,
    winners,
    u_matrix,
    done: step >= steps,
  };
}

const clamp = (value: number) => Math.min(14, Math.max(0, value));

const kModule = {
  inputs: [],
  sparse: false,
  rate: "frame",
  learns: false,
  parameters: {},
  not_given: [],
} as const;

function module(
  name: string,
  type: string,
  text: string,
  shape: number[],
  inputs: string[],
  more: Partial<ModuleData> = {},
): ModuleData {
  const ports = inputs.map((input, i) => ({ port: `input_${i + 1}`, module: input }));
  return { ...kModule, not_given: [], parameters: {}, name, type, text, shape, inputs: ports, ...more };
}

const kGraph: GraphData = {
  modules: [
    module("joints_deg", "channel", "A channel of the recording", [6], [], { channel: "joints" }),
    module("joints", "one_hot", "A place for each interval of each value", [60], ["joints_deg"]),
    module("touch", "channel", "A channel of the recording", [45], [], { channel: "touch" }),
    module(
      "crossed",
      "tensor_product",
      "A place for every pair of values",
      [10, 10, 60, 45],
      ["joints", "touch"],
      { sparse: true },
    ),
    module(
      "memory",
      "accumulate",
      "The sum of the inputs of an exploration",
      [10, 10, 60, 45],
      ["crossed"],
      { sparse: true },
    ),
    module("map", "som", "A self-organizing map", [225], ["memory"], { learns: true, rate: "exploration" }),
  ],
  map: "map",
  phases: [{ learn: ["map"], draws: 1000, of: "explorations" }],
};

export function fakeState(): State {
  return {
    version: 1,
    source: "recording",
    name: "hand2.mcap",
    explorations: kExplorations.map((index) => ({
      id: idOf(index),
      index,
      labels: { object: thingOf(index).name, trial: String(1 + Math.floor(index / 3)) },
    })),
    exploration: 0,
    labels: { object: thingOf(0).name, trial: "1" },
    frame: 1,
    frames: kFrames,
    duration: (kFrames - 1) / kRate,
    playing: false,
    speed: 1,
    live: false,
    channels: [
      { name: "height", unit: "mm", elements: ["1"], shape: [1] },
      { name: "wrist", unit: "deg", elements: ["1"], shape: [1] },
      {
        name: "joints",
        unit: "deg",
        elements: [1, 2, 3].flatMap((i) => [`finger${i}_proximal`, `finger${i}_distal`]),
        shape: [6],
      },
      { name: "touch", unit: "N", elements: kTaxels, shape: [45] },
      { name: "touch_change", unit: "N", elements: kTaxels, shape: [45] },
    ],
    rates: {},
    things: [],
    thing: null,
    placement: null,
    systems: [
      { name: "tensor_chain", text: "Tensor products", learns: true },
      { name: "shape_and_size", text: "Joints only", learns: false },
    ],
    system: "tensor_chain",
    system_problem: null,
    graph: structuredClone(kGraph),
    maps: [
      {
        module: "map",
        grid: kGrid,
        classes: kThings.map(({ name }) => name),
        neuron_classes: Array.from({ length: kNeurons }, (_, i) => (i % 3 === 0 ? null : nearestHome(i))),
      },
    ],
    label: "object",
    teaches: false,
    taught: [],
    training: false,
    demonstrated: null,
    naming: { names: [], each: null, next: null, id: idOf(0), given: null, last: null },
    dropped: 0,
    first_frame: 0,
    losses: { failed: 0, unsaved: 0, viewers: 0 },
    saved: null,
    clients: 1,
    awaits_start: false,
    problem: null,
  };
}

function nearestHome(neuron: number): number {
  const away = kHomes.map(
    (home) => (Math.floor(home / 15) - Math.floor(neuron / 15)) ** 2 + ((home % 15) - (neuron % 15)) ** 2,
  );
  return away.indexOf(Math.min(...away));
}

export function bodyState(): State {
  const things = kThings.map(({ name, size, colour }) => ({
    name,
    shape: "sphere" as const,
    size,
    top_diameter: 0,
    material: "wood",
    hardness: "hard",
    colour: colour.slice(0, 3) as [number, number, number],
    mass: null,
  }));
  return {
    ...fakeState(),
    source: "body",
    name: "lucs2",
    explorations: [],
    things,
    thing: kThings[0]!.name,
    placement: { x: 0, y: 0, turn: 0 },
  };
}
