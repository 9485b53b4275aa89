// The direction out of the skin at each touch sensor, in the frame of its body: the scene does not
// contain it. The sensors of a segment lie in a plane; its outer side is the one away from the
// other parts of the segment.

import type { Geom, Vector3 } from "../data";

const kFlat = 0.35; // share of the extent along another axis up to which sensors lie in a plane

export function padNormals(geoms: readonly Geom[]): Map<number, Vector3> {
  const normals = new Map<number, Vector3>();
  for (const body of new Set(geoms.map((geom) => geom.body))) {
    const own = geoms.filter((geom) => geom.body === body);
    const pads = own.filter(({ taxel }) => taxel !== null);
    const rest = own.filter(({ taxel }) => taxel === null);
    const middle = meanOf(rest.length > 0 ? rest : pads);
    const plane = planeOf(pads, middle);
    for (const pad of pads) normals.set(pad.taxel!, plane ?? away(pad.position, middle));
  }
  return normals;
}

function planeOf(pads: readonly Geom[], middle: Vector3): Vector3 | null {
  if (pads.length < 3) return null;
  const extents = [0, 1, 2].map((axis) => {
    const places = pads.map(({ position }) => position[axis]!);
    return Math.max(...places) - Math.min(...places);
  });
  const thin = extents.indexOf(Math.min(...extents));
  const next = Math.min(...extents.filter((_, axis) => axis !== thin));
  if (extents[thin]! > kFlat * next) return null;
  const normal: Vector3 = [0, 0, 0];
  normal[thin] = meanOf(pads)[thin]! < middle[thin]! ? -1 : 1;
  return normal;
}

function meanOf(geoms: readonly Geom[]): Vector3 {
  const mean = (axis: number) =>
    geoms.reduce((sum, { position }) => sum + position[axis]!, 0) / Math.max(1, geoms.length);
  return [mean(0), mean(1), mean(2)];
}

function away(from: Vector3, middle: Vector3): Vector3 {
  const [x, y, z] = [from[0] - middle[0], from[1] - middle[1], from[2] - middle[2]];
  const length = Math.hypot(x, y, z);
  return length > 0 ? [x / length, y / length, z / length] : [0, 0, 1];
}
