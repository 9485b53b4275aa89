// The appearance of the three-dimensional picture: lights, table, materials. Without a graphics
// processor, simpler materials and no shadows are used.

import {
  DirectionalLight,
  GridHelper,
  Group,
  HemisphereLight,
  MeshLambertMaterial,
  MeshStandardMaterial,
} from "three";

const kGrid = 0.05; // m

export interface Surroundings {
  table: string; // CSS colours
  line: string;
}

/** The material of geoms whose colours are in their geometry. */
export function materialOf(simple: boolean): MeshLambertMaterial | MeshStandardMaterial {
  const look = { vertexColors: true };
  if (simple) return new MeshLambertMaterial(look);
  return new MeshStandardMaterial({ ...look, roughness: 0.55, metalness: 0.05 });
}

export function lamps(simple: boolean): Group {
  const group = new Group();
  const sky = new HemisphereLight(0xffffff, 0x8a8f98, simple ? 2.0 : 1.6);
  sky.position.set(0, 0, 1);
  const sun = new DirectionalLight(0xffffff, 1.9);
  sun.position.set(0.25, -0.35, 0.6);
  if (!simple) castShadows(sun);
  group.add(sky, sun, sun.target);
  return group;
}

function castShadows(sun: DirectionalLight): void {
  sun.castShadow = true;
  sun.shadow.mapSize.set(1024, 1024);
  sun.shadow.radius = 5;
  sun.shadow.bias = -0.0004;
  const view = sun.shadow.camera;
  Object.assign(view, { left: -0.25, right: 0.25, top: 0.3, bottom: -0.2, near: 0.1, far: 1.6 });
  view.updateProjectionMatrix();
}

/** Lines every 5 cm on the table as a scale. */
export function tableLines(): GridHelper {
  const lines = new GridHelper(16 * kGrid, 16, "white", "white"); // times the material's colour
  lines.rotateX(Math.PI / 2);
  lines.position.z = 0.0006;
  lines.material.transparent = true;
  lines.material.opacity = 0.55;
  return lines;
}
