// A hand for the fake server: LUCS Haptic Hand II as models/lucs_haptic_hand_2.xml measures it.

import type { Geom, Scene } from "../../src/view/data";

type Point = [number, number, number];
type Turn = [number, number, number, number]; // w, x, y, z

const kHandColour: Geom["colour"] = [0.7, 0.75, 0.8, 1];
const kTaxelRows: Record<string, number[][]> = {
  proximal: [
    [-8, 8],
    [-15, 0, 15],
    [-8, 8],
  ],
  distal: [
    [-15, 0, 15],
    [-8, 8],
    [-15, 0, 15],
  ],
};
const kSegment = 0.06;
const kPivot = 0.065;

export const kFingers = ["finger1", "finger2", "finger3"];
export const kSegments = ["proximal", "distal"];

/** Names of the 45 taxels in their order. */
export const kTaxels = kFingers.flatMap((finger) =>
  kSegments.flatMap((segment) => kTaxelRows[segment]!.flat().map((_, i) => `${finger}_${segment}_${i + 1}`)),
);

const kBodies = [
  "lift",
  "palm",
  ...kFingers.flatMap((finger) => kSegments.map((segment) => `${finger}_${segment}`)),
  "object",
];

export interface FakeThing {
  name: string;
  type: Geom["type"];
  size: Point; // half sizes, m
  height: number; // m, of its middle
  colour: Geom["colour"];
}

export const kThings: FakeThing[] = [
  { name: "boccia boule", type: "sphere", size: [0.036, 0, 0], height: 0.036, colour: [0.62, 0.16, 0.18, 1] },
  {
    name: "boccia cylinder",
    type: "cylinder",
    size: [0.031, 0.05, 0],
    height: 0.05,
    colour: [0.76, 0.6, 0.38, 1],
  },
  { name: "block", type: "box", size: [0.025, 0.025, 0.05], height: 0.05, colour: [0.35, 0.45, 0.6, 1] },
];

export function fakeScene(thing: FakeThing): Scene {
  const geoms = [
    table(),
    ...palm(),
    ...kFingers.flatMap((_, finger) => kSegments.flatMap((_, segment) => segmentGeoms(finger, segment))),
  ];
  const object = geom(
    kBodies.indexOf("object"),
    "object",
    thing.type,
    thing.size,
    [0, 0, thing.height],
    thing.colour,
  );
  const camera: Scene["camera"] = { position: [0.27, -0.34, 0.27], target: [0, 0, 0.098] };
  return { bodies: kBodies, geoms: [...geoms, { ...object, role: "object" }], camera };
}

function geom(
  body: number,
  name: string,
  type: Geom["type"],
  size: Point,
  position: Point,
  colour = kHandColour,
): Geom {
  return { body, name, type, size, position, quaternion: [1, 0, 0, 0], colour, role: "hand", taxel: null };
}

function table(): Geom {
  const made = geom(-1, "table", "box", [0.4, 0.4, 0.02], [0, 0, -0.02], [0.9, 0.9, 0.88, 1]);
  return { ...made, role: "table" };
}

function palm(): Geom[] {
  const arms = [0, 1, 2].map((i) => {
    const angle = (i * 2 * Math.PI) / 3;
    const at: Point = [0.035 * Math.cos(angle), 0.035 * Math.sin(angle), 0.018];
    return { ...geom(1, `arm${i}`, "box", [0.035, 0.012, 0.004], at), quaternion: about([0, 0, 1], angle) };
  });
  return [
    geom(0, "stem", "cylinder", [0.018, 0.03, 0], [0, 0, 0.055], [0.3, 0.3, 0.33, 1]),
    geom(1, "palm", "cylinder", [0.055, 0.003, 0], [0, 0, 0.022]),
    ...arms,
  ];
}

function segmentGeoms(finger: number, segment: number): Geom[] {
  const body = 2 + finger * 2 + segment;
  const name = `${kFingers[finger]}_${kSegments[segment]}`;
  const rows = kTaxelRows[kSegments[segment]!]!;
  const places = rows.flatMap((row, i) => row.map((y): Point => [-0.012, y / 1000, -0.018 * (i + 1)]));
  const first = finger * 15 + segment * 7;
  const taxels = places.map((at, i) => ({
    ...geom(body, `taxel_${name}_${i + 1}`, "sphere", [0.005, 0, 0], at, [0.85, 0.45, 0.1, 1]),
    taxel: first + i,
  }));
  return [
    geom(body, `${name}_servo`, "box", [0.01, 0.02, 0.012], [0, 0, -0.014], [0.15, 0.15, 0.17, 1]),
    geom(body, `${name}_bracket`, "box", [0.003, 0.012, 0.016], [0, 0, -0.044], [0.75, 0.76, 0.78, 1]),
    geom(body, `${name}_plate`, "box", [0.002, 0.018, 0.019], [-0.012, 0, -0.036], [0.85, 0.85, 0.8, 1]),
    ...taxels,
  ];
}

/** 7 numbers a body. Degrees; height in m. */
export function fakePoses(height: number, wrist: number, joints: readonly number[]): number[] {
  const palmTurn = about([0, 0, 1], radians(wrist));
  const poses = [pose([0, 0, height], [1, 0, 0, 0]), pose([0, 0, height], palmTurn)];
  kFingers.forEach((_, finger) => poses.push(...fingerPoses(height, palmTurn, finger, joints)));
  return [...poses, pose([0, 0, 0], [1, 0, 0, 0])].flat();
}

function fingerPoses(height: number, palm: Turn, finger: number, joints: readonly number[]): number[][] {
  const angle = (finger * 2 * Math.PI) / 3;
  const base = times(palm, about([0, 0, 1], angle));
  const pivot = add([0, 0, height], turned(base, [kPivot, 0, 0]));
  const proximal = times(base, about([0, 1, 0], radians(joints[finger * 2] ?? 0)));
  const knee = add(pivot, turned(proximal, [0, 0, -kSegment]));
  const distal = times(proximal, about([0, 1, 0], radians(joints[finger * 2 + 1] ?? 0)));
  return [pose(pivot, proximal), pose(knee, distal)];
}

const pose = (at: Point, turn: Turn): number[] => [...at, ...turn];
const radians = (degrees: number) => (degrees * Math.PI) / 180;
const add = (a: Point, b: Point): Point => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];

function about(axis: Point, angle: number): Turn {
  const s = Math.sin(angle / 2);
  return [Math.cos(angle / 2), axis[0] * s, axis[1] * s, axis[2] * s];
}

function times([aw, ax, ay, az]: Turn, [bw, bx, by, bz]: Turn): Turn {
  return [
    aw * bw - ax * bx - ay * by - az * bz,
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
  ];
}

function turned(turn: Turn, point: Point): Point {
  const [w, x, y, z] = turn;
  const [, rx, ry, rz] = times(times(turn, [0, ...point]), [w, -x, -y, -z]);
  return [rx, ry, rz];
}
