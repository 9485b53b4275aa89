// The bodies of a scene, as groups moved by the poses of the frames, and its taxels.

import { Group, Mesh, MeshBasicMaterial, type MeshStandardMaterial } from "three";

import type { NumberOrNull } from "../parts/data";
import type { Geom, Scene } from "./data";
import { geometryOf } from "./geometry";
import { forceColour, materialOf } from "./look";

const kPoseLength = 7;
const kSeenThrough = 0.02; // share of the scale from which a taxel shines through what hides it

export class SceneParts {
  readonly root = new Group();
  private readonly bodies: Group[];
  readonly taxels = new Map<number, Mesh>();
  private readonly tables: Mesh[] = [];

  constructor(
    scene: Scene,
    private readonly simple: boolean,
  ) {
    this.bodies = scene.bodies.map(() => new Group());
    this.root.add(...this.bodies);
    for (const geom of scene.geoms) this.add(geom);
  }

  move(poses: readonly NumberOrNull[]): void {
    this.bodies.forEach((body, i) => {
      const at = (k: number) => poses[i * kPoseLength + k] ?? 0;
      if (poses.length < (i + 1) * kPoseLength) return;
      body.position.set(at(0), at(1), at(2));
      body.quaternion.set(at(4), at(5), at(6), at(3));
    });
  }

  /** `share` gives the strength of each element of the touch channel, 0 to 1. */
  colour(share: (element: number) => number): void {
    for (const [element, mesh] of this.taxels) {
      const strength = share(element);
      (mesh.material as MeshBasicMaterial).color.copy(forceColour(strength));
      mesh.scale.setScalar(1 + 0.35 * strength); // colour is not the only sign
      const ghost = mesh.children[0] as Mesh;
      (ghost.material as MeshBasicMaterial).color.copy(forceColour(strength));
      ghost.visible = strength > kSeenThrough;
    }
  }

  colourTable(colour: string): void {
    for (const table of this.tables) (table.material as MeshStandardMaterial).color.set(colour);
  }

  dispose(): void {
    this.root.traverse((part) => {
      if (!(part instanceof Mesh)) return;
      part.geometry.dispose();
      part.material.dispose();
    });
  }

  private add(geom: Geom): void {
    const mesh = new Mesh(geometryOf(geom), materialOf(geom, this.simple));
    const [w, x, y, z] = geom.quaternion;
    mesh.position.set(...geom.position);
    mesh.quaternion.set(x, y, z, w);
    mesh.castShadow = geom.role !== "table" && geom.taxel === null;
    mesh.receiveShadow = geom.taxel === null;
    mesh.renderOrder = geom.role === "object" ? 1 : 0;
    (this.bodies[geom.body] ?? this.root).add(mesh);
    if (geom.role === "table") this.tables.push(mesh);
    if (geom.taxel !== null) this.addTaxel(geom.taxel, mesh);
  }

  /** Most taxels face the object and are hidden: translucent copies are drawn in front. */
  private addTaxel(taxel: number, mesh: Mesh): void {
    const look = { transparent: true, opacity: 0.45, depthTest: false, depthWrite: false };
    const ghost = new Mesh(mesh.geometry, new MeshBasicMaterial(look));
    ghost.renderOrder = 2;
    ghost.visible = false;
    mesh.add(ghost);
    this.taxels.set(taxel, mesh);
  }
}
