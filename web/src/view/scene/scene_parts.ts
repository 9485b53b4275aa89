// The bodies of a scene, as groups moved by poses, and its touch sensors. What moves together and
// looks alike is one mesh, because each mesh costs the time of a drawing call.

import {
  type BufferGeometry,
  Color,
  Float32BufferAttribute,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  type MeshLambertMaterial,
  type MeshStandardMaterial,
  Quaternion,
  Vector3,
} from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";

import type { NumberOrNull } from "../../parts/data";
import type { Geom, Scene } from "../data";
import { geometryOf } from "./geometry";
import { materialOf } from "./look";
import { Pads } from "./pads";

const kPoseLength = 7;
const kSeenThrough = 0.22; // opacity of the hand on demand

type Look = MeshLambertMaterial | MeshStandardMaterial;
type Role = Geom["role"];

export class SceneParts {
  readonly root = new Group();
  readonly bodies: Group[];
  readonly pads: Pads;
  private readonly looks: Record<Role, Look>;

  constructor(
    scene: Scene,
    private readonly simple: boolean,
  ) {
    this.bodies = scene.bodies.map(() => new Group());
    this.looks = { hand: materialOf(simple), object: materialOf(simple), table: materialOf(simple) };
    this.root.add(...this.bodies);
    for (let body = -1; body < scene.bodies.length; body += 1)
      for (const role of ["hand", "object", "table"] as const) this.add(scene.geoms, body, role);
    this.pads = new Pads(scene.geoms);
    this.root.add(this.pads.root);
  }

  move(poses: readonly NumberOrNull[]): void {
    this.bodies.forEach((body, i) => {
      const at = (k: number) => poses[i * kPoseLength + k] ?? 0;
      if (poses.length < (i + 1) * kPoseLength) return;
      body.position.set(at(0), at(1), at(2));
      body.quaternion.set(at(4), at(5), at(6), at(3));
    });
    this.root.updateMatrixWorld();
  }

  colourTable(colour: string): void {
    this.looks.table.color.set(colour);
  }

  seeThrough(transparent: boolean): void {
    const look = this.looks.hand;
    look.opacity = transparent ? kSeenThrough : 1;
    look.depthWrite = !transparent;
    look.transparent = transparent;
    look.needsUpdate = true;
  }

  dispose(): void {
    this.root.traverse((part) => {
      if (!(part instanceof Mesh)) return;
      if (part instanceof InstancedMesh) part.dispose();
      part.geometry.dispose();
      part.material.dispose();
    });
  }

  private add(all: readonly Geom[], body: number, role: Role): void {
    const geoms = all.filter((geom) => geom.body === body && geom.role === role && geom.taxel === null);
    if (geoms.length === 0) return;
    const mesh = new Mesh(
      mergeGeometries(geoms.map((geom) => placed(geom, this.simple, role !== "table"))),
      this.looks[role],
    );
    mesh.castShadow = !this.simple && role !== "table";
    mesh.receiveShadow = !this.simple;
    (this.bodies[body] ?? this.root).add(mesh);
  }
}

/** In the frame of its body, with the colour of the geom unless the material has one. */
function placed(geom: Geom, simple: boolean, isColoured: boolean): BufferGeometry {
  const [w, x, y, z] = geom.quaternion;
  const place = new Matrix4().compose(
    new Vector3(...geom.position),
    new Quaternion(x, y, z, w),
    new Vector3(1, 1, 1),
  );
  const made = geometryOf(geom, simple).applyMatrix4(place);
  const shape = made.index === null ? made : made.toNonIndexed();
  for (const name of Object.keys(shape.attributes))
    if (name !== "position" && name !== "normal") shape.deleteAttribute(name);
  const [red, green, blue] = geom.colour;
  const { r, g, b } = isColoured ? new Color().setRGB(red, green, blue, "srgb") : new Color("white");
  const count = shape.getAttribute("position").count;
  const colours = Array.from({ length: count }, () => [r, g, b]).flat();
  shape.setAttribute("color", new Float32BufferAttribute(colours, 3));
  return shape;
}
