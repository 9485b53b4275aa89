// The hand in three dimensions. It is drawn only after a frame, a camera movement, or a change of
// size or theme.

import {
  type Mesh,
  MeshBasicMaterial,
  Mesh as ThreeMesh,
  PCFSoftShadowMap,
  PerspectiveCamera,
  Raycaster,
  Scene as ThreeScene,
  SphereGeometry,
  Vector2,
  WebGLRenderer,
} from "three";

import type { NumberOrNull } from "../parts/data";
import type { Scene } from "./data";
import { drawingClock } from "./frame_loop";
import { drawsAtAll, drawsInSoftware } from "./graphics";
import { lamps, type Surroundings, tableLines } from "./look";
import { Orbit } from "./orbit";
import { SceneParts } from "./scene_parts";

/** The taxel under the pointer, and the clicked one. */
export interface Pointing {
  pointed: (taxel: number | null) => void;
  picked: (taxel: number) => void;
}

const kClick = 4; // pixels that a click may stray

export class SceneView {
  readonly orbit: Orbit;
  private readonly scene = new ThreeScene();
  private readonly camera = new PerspectiveCamera(38, 1, 0.01, 20);
  private readonly simple: boolean;
  private readonly ring = new ThreeMesh(
    new SphereGeometry(0.0078, 20, 12),
    new MeshBasicMaterial({ wireframe: true }),
  );
  private readonly lines = tableLines();
  private readonly retired: SceneParts[] = [];
  private parts: SceneParts | null = null;
  private chosen: number | null = null;
  private requested = false;
  private ready = false; // its shaders are compiled

  constructor(
    private readonly host: HTMLElement,
    private readonly renderer: WebGLRenderer,
    private readonly pointing: Pointing,
  ) {
    this.simple = drawsInSoftware();
    renderer.setPixelRatio(this.simple ? 1 : Math.min(window.devicePixelRatio, 2));
    renderer.debug.checkShaderErrors = false; // asking waits for the compiler
    renderer.shadowMap.enabled = !this.simple;
    renderer.shadowMap.type = PCFSoftShadowMap;
    this.scene.add(lamps(this.simple), this.lines);
    this.orbit = new Orbit(this.camera, host, () => this.request());
    host.append(renderer.domElement);
    new ResizeObserver(() => this.resize()).observe(host);
    this.watchClicks();
  }

  show(scene: Scene | null, surroundings: Surroundings): void {
    if (this.parts !== null) this.scene.remove(this.parts.root);
    this.ring.removeFromParent();
    this.retire(this.parts);
    this.parts = scene === null ? null : new SceneParts(scene, this.simple);
    if (this.parts !== null) this.scene.add(this.parts.root);
    if (scene !== null) this.orbit.begin(scene.camera);
    this.dress(surroundings);
    this.choose(this.chosen);
    void this.prepare();
  }

  /** Shaders are compiled asynchronously, because the first picture would otherwise block the page. */
  private async prepare(): Promise<void> {
    if (this.ready) return;
    if (this.renderer.extensions.has("KHR_parallel_shader_compile"))
      await this.renderer.compileAsync(this.scene, this.camera);
    else await new Promise((done) => window.setTimeout(done)); // everything else is drawn first
    this.ready = true;
    this.retire(null);
    this.request();
  }

  /** Materials must not be disposed of during compilation. */
  private retire(parts: SceneParts | null): void {
    if (parts !== null) this.retired.push(parts);
    if (this.ready) for (const old of this.retired.splice(0)) old.dispose();
  }

  dress({ table, line }: Surroundings): void {
    this.parts?.colourTable(table);
    this.lines.material.color.set(line);
    this.request();
  }

  /** Shows a frame immediately. */
  draw(poses: readonly NumberOrNull[], share: (element: number) => number): void {
    this.parts?.move(poses);
    this.parts?.colour(share);
    this.render();
  }

  choose(taxel: number | null): void {
    this.chosen = taxel;
    const mesh = taxel === null ? undefined : this.parts?.taxels.get(taxel);
    if (mesh === undefined) this.ring.removeFromParent();
    else mesh.add(this.ring);
    this.request();
  }

  colourRing(colour: string): void {
    (this.ring.material as MeshBasicMaterial).color.set(colour);
  }

  private request(): void {
    if (this.requested) return;
    this.requested = true;
    window.requestAnimationFrame(() => {
      if (this.requested) this.render();
    });
  }

  private render(): void {
    this.requested = false;
    if (!this.ready) return;
    const begin = performance.now();
    this.renderer.render(this.scene, this.camera);
    drawingClock.time += performance.now() - begin;
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.host;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.render(); // a new size empties the picture
  }

  private watchClicks(): void {
    let x = 0;
    let y = 0;
    this.host.addEventListener("pointerdown", (event) => ([x, y] = [event.clientX, event.clientY]));
    this.host.addEventListener("pointerup", (event) => {
      if (Math.hypot(event.clientX - x, event.clientY - y) > kClick) return;
      const taxel = this.taxelAt(event.clientX, event.clientY);
      if (taxel !== null) this.pointing.picked(taxel);
    });
    this.host.addEventListener("pointerleave", () => this.pointing.pointed(null));
    this.host.addEventListener("pointermove", (event) => {
      if (event.buttons === 0) this.pointing.pointed(this.taxelAt(event.clientX, event.clientY));
    });
  }

  private taxelAt(x: number, y: number): number | null {
    const box = this.host.getBoundingClientRect();
    const place = new Vector2(((x - box.left) / box.width) * 2 - 1, 1 - ((y - box.top) / box.height) * 2);
    const ray = new Raycaster();
    ray.setFromCamera(place, this.camera);
    const taxels = [...(this.parts?.taxels ?? [])];
    const hit = ray.intersectObjects(
      taxels.map(([, mesh]) => mesh),
      false,
    )[0]?.object;
    return taxels.find(([, mesh]) => mesh === (hit as Mesh | undefined))?.[0] ?? null;
  }
}

/** null if the browser does not support WebGL. */
export function makeRenderer(): WebGLRenderer | null {
  try {
    if (!drawsAtAll()) return null;
    const canvas = document.createElement("canvas");
    return new WebGLRenderer({ canvas, antialias: !drawsInSoftware(), alpha: true });
  } catch {
    return null;
  }
}
