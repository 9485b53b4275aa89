// The hand in three dimensions. It is drawn only after a frame, a camera movement, or a change of
// size or theme, and between frames while its bodies move. A frame is drawn at once, so that it is seen
// together with the skin of this frame.

import {
  MeshBasicMaterial,
  Mesh,
  PCFSoftShadowMap,
  PerspectiveCamera,
  Raycaster,
  Scene as ThreeScene,
  SphereGeometry,
  Vector2,
  WebGLRenderer,
} from "three";

import type { Frame, Scene } from "../data";
import type { DrawingBudget } from "../session/drawing_budget";
import { drawingClock } from "../session/frame_loop";
import { drawsAtAll, drawsInSoftware } from "./graphics";
import { lamps, type Surroundings, tableLines } from "./look";
import { Orbit } from "./orbit";
import { padCamera } from "./pad_camera";
import type { Share } from "./pads";
import { isPicture } from "../page/picture";
import { PoseMotion } from "./pose_motion";
import { SceneParts } from "./scene_parts";

/** The taxel under the pointer, and the clicked one. */
export interface Pointing {
  pointed: (taxel: number | null) => void;
  picked: (taxel: number) => void;
}

const kClick = 4; // pixels that a click may stray
const kRest = 350; // ms without movement, after which the picture is drawn finely

export class SceneView {
  readonly orbit: Orbit;
  private readonly scene = new ThreeScene();
  private readonly camera = new PerspectiveCamera(38, 1, 0.01, 20);
  private readonly simple: boolean;
  private readonly ring = new Mesh(
    new SphereGeometry(0.0095, 16, 10),
    new MeshBasicMaterial({ wireframe: true }),
  );
  private readonly lines = tableLines();
  private readonly retired: SceneParts[] = [];
  private readonly motion = new PoseMotion(isPicture() ? 0 : undefined);
  private readonly finest: number; // pixels per CSS pixel
  private parts: SceneParts | null = null;
  private described: Scene | null = null;
  private share: Share = () => null;
  private frame = ""; // that is to be drawn
  private chosen: number | null = null;
  private isTransparent = false;
  private isAimed = false; // at the pads, once
  private requested = 0; // the animation frame; 0: none
  private resting = 0;
  private ready = false; // its shaders are compiled
  private size: [number, number] = [0, 0];

  constructor(
    private readonly host: HTMLElement,
    private readonly renderer: WebGLRenderer,
    private readonly budget: DrawingBudget,
    private readonly pointing: Pointing,
  ) {
    this.simple = drawsInSoftware();
    this.finest = this.simple ? 1 : Math.min(window.devicePixelRatio, 2);
    renderer.debug.checkShaderErrors = false; // asking waits for the compiler
    renderer.shadowMap.enabled = !this.simple;
    renderer.shadowMap.type = PCFSoftShadowMap;
    this.scene.add(lamps(this.simple), this.lines);
    this.orbit = new Orbit(this.camera, host, () => this.move());
    host.append(renderer.domElement);
    new ResizeObserver(([entry]) => this.resize(entry!.contentRect)).observe(host);
    this.watchClicks();
  }

  show(scene: Scene | null, surroundings: Surroundings): void {
    if (this.parts !== null) this.scene.remove(this.parts.root);
    this.ring.removeFromParent();
    this.retire(this.parts);
    this.described = scene;
    this.parts = scene === null ? null : new SceneParts(scene, this.simple);
    if (this.parts !== null) this.scene.add(this.parts.root);
    if (scene !== null) this.orbit.begin(scene.camera);
    this.parts?.seeThrough(this.isTransparent);
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

  colourRing(colour: string): void {
    this.ring.material.color.set(colour);
    this.request();
  }

  draw(frame: Frame, share: Share): void {
    this.share = share;
    this.frame = `${frame.exploration}:${frame.frame}`;
    this.motion.take(frame, performance.now());
    if (!this.isAimed) this.aim();
    this.awaitRest();
    this.render();
  }

  /** To where the pads are seen. */
  aim(): void {
    if (this.parts === null || this.described === null) return;
    this.parts.move(this.motion.at(performance.now()));
    const camera = padCamera(this.parts, this.described);
    this.isAimed = true;
    if (camera !== null) this.orbit.look(camera);
  }

  seeThrough(transparent: boolean): void {
    this.isTransparent = transparent;
    this.parts?.seeThrough(transparent);
    this.request();
  }

  /** Marks a taxel, or none. */
  choose(taxel: number | null): void {
    this.chosen = taxel;
    this.ring.removeFromParent();
    const pad = this.parts?.pads.all.find((one) => one.taxel === taxel);
    if (pad === undefined) return this.request();
    this.ring.position.copy(pad.place);
    (this.parts?.bodies[pad.body] ?? this.scene).add(this.ring);
    this.request();
  }

  /** Draws now with the resolution of a movement, and finely once it rests. */
  private move(): void {
    this.awaitRest();
    this.request();
  }

  private awaitRest(): void {
    window.clearTimeout(this.resting);
    this.resting = window.setTimeout(() => this.settle(), kRest);
  }

  private settle(): void {
    this.budget.rest();
    if (this.resolve(this.finest)) this.request();
  }

  /** The pixels per CSS pixel; true if they change. */
  private resolve(pixels: number): boolean {
    if (this.renderer.getPixelRatio() === pixels) return false;
    this.renderer.setPixelRatio(pixels);
    return true;
  }

  private request(): void {
    if (this.requested === 0) this.requested = window.requestAnimationFrame(() => this.render());
  }

  private render(): void {
    window.cancelAnimationFrame(this.requested);
    this.requested = 0;
    if (!this.ready || this.size[0] === 0) return;
    const begin = performance.now();
    if (this.motion.isMoving(begin)) this.keepUp(begin);
    this.parts?.move(this.motion.at(begin + this.seenFor));
    this.parts?.pads.show(this.parts.bodies, this.share);
    this.renderer.render(this.scene, this.camera);
    const time = performance.now() - begin;
    drawingClock.time += time;
    drawingClock.drawn += 1;
    this.host.dataset["drawn"] = String(drawingClock.drawn);
    this.host.dataset["frame"] = this.frame;
  }

  /** ms for which a picture is seen: it shows the poses of the end of this time. Software is slow until measured. */
  private get seenFor(): number {
    return this.budget.interval ?? (this.simple ? Number.POSITIVE_INFINITY : 0);
  }

  private keepUp(now: number): void {
    this.budget.follow(now);
    this.resolve(this.finest * this.budget.resolution);
    this.move();
  }

  private resize({ width, height }: DOMRectReadOnly): void {
    this.size = [width, height];
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
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
    const { parts } = this;
    if (parts === null) return null;
    const box = this.host.getBoundingClientRect();
    const place = new Vector2(((x - box.left) / box.width) * 2 - 1, 1 - ((y - box.top) / box.height) * 2);
    const ray = new Raycaster();
    ray.setFromCamera(place, this.camera);
    const hit = ray.intersectObject(parts.pads.mesh, false)[0]?.instanceId;
    return hit === undefined ? null : (parts.pads.all[hit]?.taxel ?? null);
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
