// A place for the camera from which most touch sensors are seen: they face the object, so that from
// most sides the fingers hide them.

import { Vector3 } from "three";

import type { Scene } from "../data";
import type { SceneParts } from "./scene_parts";

const kAround = 36; // directions that are compared
const kHeights = [0.2, 0.45, 0.7]; // rad above the horizontal
const kBehind = 0.4; // of the weight of a pad that another part hides
const kNear = 0.9; // times the distance of the scene's camera

export function padCamera(parts: SceneParts, scene: Scene): Scene["camera"] | null {
  const pads = parts.pads.all.map(({ body, place, normal }) => {
    const frame = parts.bodies[body]?.matrixWorld;
    return frame === undefined
      ? { at: place.clone(), out: normal.clone() }
      : { at: place.clone().applyMatrix4(frame), out: normal.clone().transformDirection(frame) };
  });
  if (pads.length === 0) return null;
  const middle = pads.reduce((sum, { at }) => sum.add(at), new Vector3()).divideScalar(pads.length);
  middle.lerp(new Vector3(...scene.camera.target), 0.5);
  const distance = kNear * new Vector3(...scene.camera.position).distanceTo(new Vector3(...scene.camera.target));
  const seen = (direction: Vector3) =>
    pads.reduce((sum, pad) => {
      const facing = Math.max(0, pad.out.dot(direction));
      return sum + facing * (isHidden(pad.at, direction, pads) ? kBehind : 1);
    }, 0);
  const best = directions().reduce((one, other) => (seen(other) > seen(one) + 1e-9 ? other : one));
  const position = middle.clone().addScaledVector(best, distance);
  return { position: position.toArray(), target: middle.toArray() };
}

function directions(): Vector3[] {
  return kHeights.flatMap((height) =>
    Array.from({ length: kAround }, (_, i) => {
      const angle = (2 * Math.PI * i) / kAround;
      return new Vector3(Math.cos(angle) * Math.cos(height), Math.sin(angle) * Math.cos(height), Math.sin(height));
    }),
  );
}

const kWidth = 0.018; // m: half of a finger
const kClose = 0.025; // m: parts of the same finger

/** Whether another finger stands between the pad and the camera. */
function isHidden(at: Vector3, direction: Vector3, pads: readonly { at: Vector3 }[]): boolean {
  return pads.some((other) => {
    const [x, y, z] = [other.at.x - at.x, other.at.y - at.y, other.at.z - at.z];
    const along = x * direction.x + y * direction.y + z * direction.z;
    return along > kClose && x * x + y * y + z * z - along * along < kWidth * kWidth;
  });
}
