// Shapes as MuJoCo measures them (half sizes, long axis z) as three.js draws them.

import {
  BoxGeometry,
  BufferGeometry,
  CapsuleGeometry,
  CylinderGeometry,
  Float32BufferAttribute,
  SphereGeometry,
} from "three";
import { RoundedBoxGeometry } from "three/examples/jsm/geometries/RoundedBoxGeometry.js";

import type { Geom } from "../data";

/** With few faces if it is drawn without a graphics processor. */
export function geometryOf(geom: Geom, simple = false): BufferGeometry {
  const [x, y, z] = geom.size;
  const around = simple ? 20 : 48;
  switch (geom.type) {
    case "box":
      return box(x, y, z, geom.role === "hand" && !simple);
    case "sphere":
      return new SphereGeometry(x, ...roundness(x, around));
    case "ellipsoid":
      return new SphereGeometry(1, ...roundness(1, around)).scale(x, y, z);
    case "cylinder":
      return new CylinderGeometry(x, x, 2 * y, around).rotateX(Math.PI / 2);
    case "capsule":
      return new CapsuleGeometry(x, 2 * y, simple ? 4 : 8, simple ? 12 : 20).rotateX(Math.PI / 2);
    case "mesh":
      return mesh(geom.vertices ?? [], geom.faces ?? []);
  }
}

/** Edges of the hand's parts are slightly rounded, as on machined parts. */
function box(x: number, y: number, z: number, broken: boolean): BufferGeometry {
  if (!broken) return new BoxGeometry(2 * x, 2 * y, 2 * z);
  return new RoundedBoxGeometry(2 * x, 2 * y, 2 * z, 2, Math.min(x, y, z) * 0.4);
}

function roundness(radius: number, around: number): [number, number] {
  return radius < 0.01 ? [16, 10] : [around, Math.round(around * 0.65)];
}

/** Few faces are shaded flat, many are shaded as a curve. */
function mesh(vertices: number[], faces: number[]): BufferGeometry {
  const made = new BufferGeometry();
  made.setAttribute("position", new Float32BufferAttribute(vertices, 3));
  made.setIndex(faces);
  const shown = faces.length < 600 ? made.toNonIndexed() : made;
  shown.computeVertexNormals();
  return shown;
}
