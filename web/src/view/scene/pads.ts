// The touch sensors in three dimensions: a pad for each, grey at rest and bright when it is
// touched, and an arrow towards each touched one; small and dark where the value is missing. What
// hides a touched pad does not cover it. All pads are drawn at once, and so are all arrows.

import {
  Color,
  ConeGeometry,
  CylinderGeometry,
  Group,
  IcosahedronGeometry,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  Quaternion,
  type Object3D,
  Vector3,
} from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";

import { ramp } from "../../parts/maps/painter";
import { isTouched, touchColour } from "../../parts/hands/touch_colours";
import type { Geom } from "../data";
import { padNormals } from "./pad_normals";

const kSize = 1.25; // times the sensor, so that pads are seen
const kGrowth = 0.5; // of the strongest
const kMissing = { size: 0.6, colour: new Color(0x2c3136) };
const kArrow = 0.034; // m, of the strongest
const kUp = new Vector3(0, 0, 1);
const colourOf = ramp((share) => new Color(touchColour(share)), 255);

/** The strength of the touch of a taxel, 0 to 1; null if it is missing. */
export type Share = (taxel: number) => number | null;

export interface Pad {
  taxel: number;
  body: number;
  radius: number;
  place: Vector3;
  normal: Vector3; // out of the skin
}

export class Pads {
  readonly root = new Group();
  readonly all: Pad[];
  private readonly pads: InstancedMesh;
  private readonly shining: InstancedMesh;
  private readonly arrows: InstancedMesh;

  constructor(geoms: readonly Geom[]) {
    this.all = padsOf(geoms);
    const ball = new IcosahedronGeometry(1, 1);
    const seenThrough = { transparent: true, opacity: 0.6, depthTest: false, depthWrite: false };
    this.pads = this.instances(ball, {});
    this.shining = this.instances(ball, seenThrough);
    this.arrows = this.instances(arrowGeometry(), { ...seenThrough, opacity: 0.95 });
    this.shining.renderOrder = 2;
    this.arrows.renderOrder = 3;
    this.root.add(this.pads, this.shining, this.arrows);
  }

  /** Draws each pad where its body is. */
  show(bodies: readonly Object3D[], share: Share): void {
    let touched = 0;
    this.all.forEach((pad, i) => {
      const strength = share(pad.taxel);
      const frame = bodies[pad.body]?.matrixWorld ?? kNoMotion;
      const size = strength === null ? kMissing.size : kSize * (1 + kGrowth * strength);
      const at = placed(frame, pad, pad.radius * size);
      this.pads.setMatrixAt(i, at);
      this.pads.setColorAt(i, strength === null ? kMissing.colour : colourOf(strength));
      if (strength === null || !isTouched(strength)) return;
      this.shining.setMatrixAt(touched, at);
      this.shining.setColorAt(touched, colourOf(strength));
      this.arrows.setMatrixAt(touched, arrowTo(frame, pad, strength));
      this.arrows.setColorAt(touched, colourOf(strength));
      touched += 1;
    });
    this.shining.count = this.arrows.count = touched;
    for (const mesh of [this.pads, this.shining, this.arrows]) changed(mesh);
  }

  get mesh(): InstancedMesh {
    return this.pads;
  }

  private instances(geometry: InstancedMesh["geometry"], look: object): InstancedMesh {
    const mesh = new InstancedMesh(geometry, new MeshBasicMaterial(look), Math.max(1, this.all.length));
    mesh.count = this.all.length;
    mesh.frustumCulled = false;
    return mesh;
  }
}

const kNoMotion = new Matrix4();

function padsOf(geoms: readonly Geom[]): Pad[] {
  const normals = padNormals(geoms);
  return geoms.flatMap((geom) =>
    geom.taxel === null
      ? []
      : {
          taxel: geom.taxel,
          body: geom.body,
          radius: Math.max(geom.size[0], geom.size[1]),
          place: new Vector3(...geom.position),
          normal: new Vector3(...(normals.get(geom.taxel) ?? [0, 0, 1])),
        },
  );
}

function placed(frame: Matrix4, pad: Pad, size: number): Matrix4 {
  const at = pad.place.clone().applyMatrix4(frame);
  return new Matrix4().compose(at, new Quaternion(), new Vector3(size, size, size));
}

/** From outside to the pad. */
function arrowTo(frame: Matrix4, pad: Pad, strength: number): Matrix4 {
  const length = kArrow * (0.35 + 0.65 * strength);
  const out = pad.normal.clone().transformDirection(frame);
  const at = pad.place.clone().applyMatrix4(frame).addScaledVector(out, pad.radius * kSize + length);
  const turn = new Quaternion().setFromUnitVectors(kUp, out.negate());
  return new Matrix4().compose(at, turn, new Vector3(length, length, length));
}

/** One unit long, from the origin along z. */
function arrowGeometry(): InstancedMesh["geometry"] {
  const shaft = new CylinderGeometry(0.06, 0.06, 0.6, 6).rotateX(Math.PI / 2).translate(0, 0, 0.3);
  const head = new ConeGeometry(0.18, 0.4, 8).rotateX(Math.PI / 2).translate(0, 0, 0.8);
  return mergeGeometries([shaft, head]);
}

function changed(mesh: InstancedMesh): void {
  mesh.instanceMatrix.needsUpdate = true;
  if (mesh.instanceColor !== null) mesh.instanceColor.needsUpdate = true;
  mesh.boundingSphere = null; // of its instances, for pointing at them
}
