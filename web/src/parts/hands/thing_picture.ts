// A small isometric picture of an object at true proportions, seen from above.
//
//   thingPicture(thing, 0.6)   0.6 pixels per mm; the same for all objects of a table
//
// Without a size only the shape is true; without a shape a piece of material is drawn.

import type { ThingData } from "../data";
import { uniqueId } from "../dom";
import { rounded, shape, svg } from "../svg";

type Point3 = readonly [number, number, number];
type Point2 = readonly [number, number];

const kCos30 = Math.sqrt(3) / 2;
const kNoColour = [0.72, 0.7, 0.66] as const;

export function thingPicture(thing: ThingData, scale: number): SVGSVGElement {
  const [w, d, h] = sizeOf(thing).map((length) => length * scale) as [number, number, number];
  const top = (thing.top_diameter || 0) * scale;
  const colour = cssColour(thing, 1);
  const kind = thing.shape ?? "block";
  const points = pointsOf(kind, w, d, h, top);
  const isRound = kRound.has(kind);
  const faces = isRound ? roundFaces(thing, points, w, d, h, top) : blockFaces(w, d, h, thing);
  const [left, up, right, down] = boundsOf(hull(points));
  const label = `${thing.name}: ${thing.shape ?? "a sample of material"}`;
  const picture = svg(right - left + 4, down - up + 4, label, faces);
  picture.setAttribute("viewBox", [left - 2, up - 2, right - left + 4, down - up + 4].map(rounded).join(" "));
  picture.setAttribute("data-colour", colour);
  return picture;
}

/** Whether the appearance is known: the shape, or the colour of a material that has none. */
export function hasPicture({ shape, colour }: ThingData): boolean {
  return shape === null ? colour !== null : kShapes.has(shape);
}

const kShapes = new Set(["sphere", "ellipsoid", "capsule", "cylinder", "cone", "block", "mesh"]);
const kRound = new Set(["sphere", "ellipsoid", "capsule", "cylinder", "cone"]);
const kPiece = [50, 50, 10] as const;
const kAround60 = [60, 60, 60] as const;
const kUpright = [50, 50, 80] as const;

function sizeOf({ size, shape }: ThingData): readonly [number, number, number] {
  if (size !== null) return size;
  if (shape === null) return kPiece;
  return shape === "sphere" ? kAround60 : kUpright;
}

/** Pixels per mm such that the largest of `things` is `size` tall or wide. */
export function commonScale(things: readonly ThingData[], size: number): number {
  const largest = things.map((thing) => {
    const [width, depth, height] = sizeOf(thing);
    return Math.max((width + depth) * kCos30, (width + depth) / 2 + height);
  });
  return size / Math.max(1, ...largest);
}

function project([x, y, z]: Point3): Point2 {
  return [(x - y) * kCos30, (x + y) / 2 - z];
}

/** Points of the surface whose convex hull is the outline. */
function pointsOf(kind: string, w: number, d: number, h: number, top: number): Point2[] {
  if (kind === "sphere" || kind === "ellipsoid") return ball(w / 2, d / 2, h / 2, h / 2).map(project);
  if (kind === "capsule") {
    const radius = Math.min(w, d, h) / 2;
    const ends = [radius, h - radius].flatMap((z) => ball(radius, radius, radius, z));
    return ends.map(project);
  }
  if (kind === "cylinder") return [...ring(w / 2, d / 2, 0), ...ring(w / 2, d / 2, h)].map(project);
  if (kind === "cone") return [...ring(w / 2, d / 2, 0), ...ring(top / 2, top / 2, h)].map(project);
  return corners(w, d, h).map(project);
}

const kAround = 48;

function ring(a: number, b: number, z: number): Point3[] {
  return Array.from({ length: kAround }, (_, i) => {
    const angle = (2 * Math.PI * i) / kAround;
    return [a * Math.cos(angle), b * Math.sin(angle), z];
  });
}

function ball(a: number, b: number, c: number, middle: number): Point3[] {
  return Array.from({ length: 25 }, (_, i) => -Math.PI / 2 + (Math.PI * i) / 24).flatMap((latitude) =>
    ring(a * Math.cos(latitude), b * Math.cos(latitude), middle + c * Math.sin(latitude)),
  );
}

function corners(w: number, d: number, h: number): Point3[] {
  return [0, h].flatMap((z) =>
    [-1, 1].flatMap((x) => [-1, 1].map((y): Point3 => [(x * w) / 2, (y * d) / 2, z])),
  );
}

function blockFaces(w: number, d: number, h: number, thing: ThingData): SVGElement[] {
  const [x, y] = [w / 2, d / 2];
  const top: Point3[] = [
    [-x, -y, h],
    [x, -y, h],
    [x, y, h],
    [-x, y, h],
  ];
  const left: Point3[] = [
    [-x, y, h],
    [x, y, h],
    [x, y, 0],
    [-x, y, 0],
  ];
  const right: Point3[] = [
    [x, -y, h],
    [x, y, h],
    [x, y, 0],
    [x, -y, 0],
  ];
  return [
    face(top.map(project), cssColour(thing, 1.12)),
    face(left.map(project), cssColour(thing, 0.92)),
    face(right.map(project), cssColour(thing, 0.74)),
  ];
}

function roundFaces(
  thing: ThingData,
  points: Point2[],
  w: number,
  d: number,
  h: number,
  top: number,
): SVGElement[] {
  const id = uniqueId("light");
  const stops = [
    [0, 1.12],
    [0.35, 1.04],
    [1, 0.66],
  ].map(([offset, light]) =>
    shape("stop", { offset: offset ?? 0, "stop-color": cssColour(thing, light ?? 1) }),
  );
  const isBall = thing.shape === "sphere" || thing.shape === "ellipsoid";
  const gradient = isBall
    ? shape("radialGradient", { id, cx: 0.36, cy: 0.3, r: 0.8 }, stops)
    : shape("linearGradient", { id }, stops);
  const faces: SVGElement[] = [shape("defs", {}, [gradient]), face(hull(points), `url(#${id})`)];
  const [a, b] = thing.shape === "cone" ? [top / 2, top / 2] : [w / 2, d / 2];
  const hasTop = thing.shape === "cylinder" || (thing.shape === "cone" && top > 0);
  if (hasTop) faces.push(face(ring(a, b, h).map(project), cssColour(thing, 1.16)));
  return faces;
}

function face(points: readonly Point2[], fill: string): SVGPathElement {
  const d = `M${points.map(([x, y]) => `${rounded(x)} ${rounded(y)}`).join("L")}Z`;
  return shape("path", { d, fill, class: "thing-face" });
}

function cssColour(thing: ThingData, light: number): string {
  const parts = (thing.colour ?? kNoColour).map((part) =>
    Math.round(Math.min(1, Math.max(0, part * light)) * 255),
  );
  return `rgb(${parts.join(" ")})`;
}

function boundsOf(points: readonly Point2[]): [number, number, number, number] {
  const xs = points.map(([x]) => x);
  const ys = points.map(([, y]) => y);
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

/** The convex hull, by Andrew's monotone chain. */
export function hull(points: readonly Point2[]): Point2[] {
  const sorted = [...points].sort((one, other) => one[0] - other[0] || one[1] - other[1]);
  return [...half(sorted), ...half([...sorted].reverse())];
}

function half(sorted: readonly Point2[]): Point2[] {
  const chain: Point2[] = [];
  for (const point of sorted) {
    while (chain.length > 1 && turn(chain.at(-2)!, chain.at(-1)!, point) <= 0) chain.pop();
    chain.push(point);
  }
  return chain.slice(0, -1);
}

function turn(a: Point2, b: Point2, c: Point2): number {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
