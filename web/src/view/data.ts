// What `somato view` tells the page; docs/formats/view.md says the same in words. Whoever wants
// another page can build it on this.
//
//   GET  /api/state                the State
//   GET  /api/scene                the Scene of what plays now, or null
//   GET  /api/neuron?map=M&neuron=N  a NeuronAnswer: what a neuron stands for
//   GET  /api/taxel?element=E      a TaxelAnswer: where on the map an element of `touch` matters
//   GET  /api/strips               the Strips of the exploration that is shown, or null
//   GET  /api/events               server-sent events: "state" (State; first, and when it changes),
//                                  "scene" (Scene | null; when the scene changes), "frame" (Frame),
//                                  "training" (Training), "ping" ({}; every 2 seconds)
//   POST /api/command              a Command as JSON; answers {"ok":true} or {"error":"..."}
//
// Every request carries the token of the start address, as ?token= or in the header X-Somato-Token;
// a POST must come from the page's own origin.

import type { ChannelData, ChannelPlanes, GraphData, GridData, ThingData } from "../parts/data";

export interface State {
  version: 1;
  source: "recording" | "body";
  name: string; // the file's name, or the body's
  // Of a recording: its explorations by their labels. Of a body: those explored so far.
  explorations: { index: number; labels: Record<string, string> }[];
  exploration: number | null; // the one that plays
  frame: number; // the next to come
  frames: number | null; // of this exploration; null while it is not over
  duration: number | null; // seconds
  playing: boolean;
  speed: number; // 1: as fast as it was
  live: boolean; // a body that explores now
  channels: ChannelData[];
  things: ThingData[]; // what a body can be given; [] for a recording
  thing: string | null;
  placement: { x: number; y: number; turn: number } | null; // mm, mm, deg; of a body
  systems: { name: string; text: string; learns: boolean }[]; // those to choose from; can it be trained here?
  system: string | null;
  system_problem: string | null; // why there is no reading, in a sentence
  graph: GraphData | null;
  maps: { module: string; grid: GridData; classes: string[]; neuron_classes: (number | null)[] }[];
  label: string | null; // what the reading says, such as "object"
  training: boolean;
  clients: number;
  problem: string | null; // what went wrong last, in a sentence
}

/** What is drawn in three dimensions. Metres; quaternions w, x, y, z. */
export interface Scene {
  bodies: string[]; // names; a frame brings a pose for each
  geoms: Geom[];
  camera: { position: [number, number, number]; target: [number, number, number] };
}

export interface Geom {
  body: number; // it moves with; -1: stands still
  name: string;
  type: "box" | "sphere" | "capsule" | "cylinder" | "ellipsoid" | "mesh";
  size: [number, number, number]; // half sizes, as MuJoCo: radius, half length, ...
  position: [number, number, number];
  quaternion: [number, number, number, number];
  colour: [number, number, number, number]; // 0 to 1
  role: "hand" | "object" | "table";
  taxel: number | null; // element of the channel `touch`
  vertices?: number[];
  faces?: number[];
}

export interface Frame {
  exploration: number;
  frame: number; // index
  frames: number | null;
  time: number; // seconds
  last: boolean; // of the exploration
  channels: Record<string, number[]>; // sound: the last stretch, at most 512 samples
  poses: number[]; // 7 a body: x, y, z, w, qx, qy, qz; [] without a scene
  // What goes through the system, by module: at most 4096 numbers, row-major in `shape`; what has
  // more is summed over its leading axes, and says so.
  modules: Record<string, { shape: number[]; values: number[]; folded: boolean }>;
  maps: Record<string, { winner: number; activity: number[] }>; // activity 0 to 1
  reading: Reading | null;
}

/** What the channels told over an exploration: at each moment, or at evenly chosen ones. */
export interface Strips {
  exploration: number;
  frames: number | null; // of the exploration; null while it is not over
  frame: number[]; // index of each moment, as its frame has it
  time: number[]; // of each moment, seconds
  // For each moment what its frame tells; without channels of which frames tell a stretch.
  channels: Record<string, number[][]>;
}

/** What the system would say if this frame were the last. */
export interface Reading {
  answer: string;
  // How much nearer its nearest neuron is than that of the next class: 0 equally near, 1 far.
  confidence: number;
  candidates: { name: string; distance: number }[]; // by distance, the nearest first
}

/** A map that is being trained before one's eyes. */
export interface Training {
  system: string;
  module: string;
  step: number;
  steps: number;
  radius: number;
  learning_rate: number;
  winners: { sample: number; winner: number; class: string }[];
  u_matrix: number[];
  done: boolean;
}

export interface NeuronAnswer {
  map: string;
  neuron: number;
  answer: string | null; // the class it is labelled with
  planes: ChannelPlanes[]; // values[0] alone: of this neuron
  nearest: { exploration: number; labels: Record<string, string>; distance: number }[];
}

export interface TaxelAnswer {
  element: number;
  name: string;
  maps: Record<string, number[]>; // for each neuron its weight for this element
}

export type Command =
  | { command: "play" }
  | { command: "pause" }
  | { command: "step"; frames: number } // negative: back
  | { command: "seek"; exploration: number; frame: number }
  | { command: "speed"; speed: number } // 0.05 to 100
  | { command: "thing"; name: string }
  | { command: "placement"; x: number; y: number; turn: number }
  | { command: "explore" } // a body: once more, as chosen
  | { command: "system"; name: string }
  | { command: "train" }
  | { command: "stop_training" };
