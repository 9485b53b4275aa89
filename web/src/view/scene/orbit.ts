// Moves a camera around its target by mouse, touch and keys, with the controls of three.js. z is up.

import type { PerspectiveCamera } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

import type { Scene } from "../data";

const kKeyTurns = 48; // presses of an arrow key for a whole turn
const kKeyPan = 24; // pixels
const kZoom = 1.12;
const kPolar = 0.02; // rad between the camera and the axis, at least
const kNearest = 0.03; // m
const kFarthest = 10;

export class Orbit {
  private readonly controls: OrbitControls;
  private readonly keys = document.createElement("div"); // whose key events the controls take
  private start: Scene["camera"] | null = null;

  constructor(
    private readonly camera: PerspectiveCamera,
    private readonly host: HTMLElement,
    changed: () => void,
  ) {
    camera.up.set(0, 0, 1); // before the controls, which read it
    this.controls = new OrbitControls(camera, host);
    host.style.touchAction = ""; // as the style sheet has it: a narrow page scrolls
    this.controls.minPolarAngle = kPolar;
    this.controls.maxPolarAngle = Math.PI - kPolar;
    this.controls.minDistance = kNearest;
    this.controls.maxDistance = kFarthest;
    this.controls.keyPanSpeed = kKeyPan;
    this.controls.listenToKeyEvents(this.keys);
    this.controls.addEventListener("change", () => {
      camera.updateMatrix(); // the controls move along its axes, else those of the picture drawn last
      changed();
    });
    host.addEventListener("wheel", () => (this.controls.enableZoom = this.takesWheel()), { capture: true });
    host.addEventListener("keydown", (event) => this.key(event));
  }

  /** The initial position of the camera. */
  begin(camera: Scene["camera"]): void {
    const moved = this.start === null || this.start.position.join() !== camera.position.join();
    this.start = camera;
    if (moved) this.reset(); // else the user's own view stays
  }

  reset(): void {
    if (this.start !== null) this.look(this.start);
  }

  /** Moves to another place. */
  look({ position, target }: Scene["camera"]): void {
    this.camera.position.set(...position);
    this.controls.target.set(...target);
    this.controls.update();
  }

  private zoom(factor: number): void {
    const { target } = this.controls;
    this.camera.position.sub(target).multiplyScalar(factor).add(target);
    this.controls.update();
  }

  /** On a scrolling page, the wheel scrolls until the pointer has entered the picture. */
  private takesWheel(): boolean {
    const scrolls = document.documentElement.scrollHeight > window.innerHeight;
    return !scrolls || document.activeElement === this.host;
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key.startsWith("Arrow")) this.arrow(event);
    else if (event.key === "+" || event.key === "=") this.zoom(1 / kZoom);
    else if (event.key === "-") this.zoom(kZoom);
    else if (event.key === "0") this.reset();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** The controls move the camera by arrow keys and turn it with Shift: here it is the reverse. */
  private arrow({ code, key, shiftKey }: KeyboardEvent): void {
    this.controls.keyRotateSpeed = this.host.clientHeight / kKeyTurns;
    this.keys.dispatchEvent(new KeyboardEvent("keydown", { code: code || key, shiftKey: !shiftKey }));
  }
}
