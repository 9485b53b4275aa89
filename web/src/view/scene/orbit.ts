// Moves a camera around its target by mouse, touch and keys. z is up.

import { MathUtils, type PerspectiveCamera, Spherical, Vector3 } from "three";

import type { Scene } from "../data";

const kTurn = 0.008; // rad a pixel
const kKeyTurn = MathUtils.degToRad(7.5);
const kKeyPan = 24; // pixels
const kZoom = 1.12;
const kUp = new Vector3(0, 0, 1);

export class Orbit {
  private readonly target = new Vector3();
  private readonly place = new Spherical(0.5, 1, 0);
  private start: Scene["camera"] | null = null;
  private pointer: { id: number; x: number; y: number } | null = null;

  constructor(
    private readonly camera: PerspectiveCamera,
    private readonly host: HTMLElement,
    private readonly changed: () => void,
  ) {
    camera.up.copy(kUp);
    host.addEventListener("pointerdown", (event) => this.press(event));
    host.addEventListener("pointermove", (event) => this.drag(event));
    host.addEventListener("pointerup", () => (this.pointer = null));
    host.addEventListener("pointercancel", () => (this.pointer = null));
    host.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    host.addEventListener("contextmenu", (event) => event.preventDefault());
    host.addEventListener("keydown", (event) => this.key(event));
  }

  /** The initial position of the camera. */
  begin(camera: Scene["camera"]): void {
    const moved = this.start === null || this.start.position.join() !== camera.position.join();
    this.start = camera;
    if (moved) this.reset(); // else the user's own view stays
  }

  reset(): void {
    if (this.start === null) return;
    this.look(this.start);
  }

  /** Moves to another place. */
  look(camera: Scene["camera"]): void {
    this.target.set(...camera.target);
    this.place.setFromVector3(upright(new Vector3(...camera.position).sub(this.target)));
    this.apply();
  }

  turn(azimuth: number, polar: number): void {
    this.place.theta -= azimuth;
    this.place.phi = MathUtils.clamp(this.place.phi - polar, 0.02, Math.PI - 0.02);
    this.apply();
  }

  zoom(factor: number): void {
    this.place.radius = MathUtils.clamp(this.place.radius * factor, 0.03, 10);
    this.apply();
  }

  pan(x: number, y: number): void {
    const scale = (this.place.radius * 1.2) / Math.max(1, this.host.clientHeight);
    const right = new Vector3().setFromMatrixColumn(this.camera.matrix, 0);
    const up = new Vector3().setFromMatrixColumn(this.camera.matrix, 1);
    this.target.addScaledVector(right, -x * scale).addScaledVector(up, y * scale);
    this.apply();
  }

  private apply(): void {
    const away = new Vector3().setFromSpherical(this.place);
    this.camera.position.set(away.z, away.x, away.y).add(this.target);
    this.camera.lookAt(this.target);
    this.camera.updateMatrix();
    this.changed();
  }

  private press(event: PointerEvent): void {
    this.host.setPointerCapture(event.pointerId);
    this.pointer = { id: event.pointerId, x: event.clientX, y: event.clientY };
  }

  private drag(event: PointerEvent): void {
    if (this.pointer?.id !== event.pointerId) return;
    const x = event.clientX - this.pointer.x;
    const y = event.clientY - this.pointer.y;
    this.pointer = { id: event.pointerId, x: event.clientX, y: event.clientY };
    if (event.shiftKey || (event.buttons & 2) !== 0) this.pan(x, y);
    else this.turn(x * kTurn, y * kTurn);
  }

  /** On a scrolling page, the wheel scrolls until the pointer has entered the picture. */
  private wheel(event: WheelEvent): void {
    const scrolls = document.documentElement.scrollHeight > window.innerHeight;
    if (scrolls && document.activeElement !== this.host) return;
    event.preventDefault();
    this.zoom(kZoom ** Math.sign(event.deltaY));
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const direction = kArrows[event.key];
    if (direction !== undefined && event.shiftKey) this.pan(-direction[0] * kKeyPan, -direction[1] * kKeyPan);
    else if (direction !== undefined) this.turn(direction[0] * kKeyTurn, direction[1] * kKeyTurn);
    else if (event.key === "+" || event.key === "=") this.zoom(1 / kZoom);
    else if (event.key === "-") this.zoom(kZoom);
    else if (event.key === "0") this.reset();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}

const kArrows: Record<string, [number, number] | undefined> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** three.js's spherical coordinates have y up. */
function upright(vector: Vector3): Vector3 {
  return new Vector3(vector.y, vector.z, vector.x);
}
