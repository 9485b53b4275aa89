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

import type { Geom } from "./data";

export function geometryOf(geom: Geom): BufferGeometry {
  const [x, y, z] = geom.size;
  switch (geom.type) {
    case "box":
      return box(x, y, z, geom.role === "hand");
    case "sphere":
      return new SphereGeometry(x, ...roundness(x));
    case "ellipsoid":
      return new SphereGeometry(1, 32, 20).scale(x, y, z);
    case "cylinder":
      return new CylinderGeometry(x, x, 2 * y, 48).rotateX(Math.PI / 2);
    case "capsule":
      return new CapsuleGeometry(x, 2 * y, 8, 20).rotateX(Math.PI / 2);
    case "mesh":
      return mesh(geom.vertices ?? [], geom.faces ?? []);
  }
}

/** Edges of the hand's parts are slightly rounded, as on machined parts. */
function box(x: number, y: number, z: number, broken: boolean): BufferGeometry {
  if (!broken) return new BoxGeometry(2 * x, 2 * y, 2 * z);
  return new RoundedBoxGeometry(2 * x, 2 * y, 2 * z, 2, Math.min(x, y, z) * 0.4);
}

function roundness(radius: number): [number, number] {
  return radius < 0.01 ? [16, 10] : [48, 32];
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
