// Markers: the shape and the colour of a class. With more than eight classes the next
// eight have other shapes, as in src/maps/svg/colours.cc.
//
//   marker(3, x, y, radius)   the marker of class 3, an SVG path

import { classColour } from "./colour_maps";
import { rounded, shape } from "../svg";

type Corner = readonly [number, number];

// Outlines around (0, 0) in radii; the first, a circle, has none.
const kOutlines: readonly (readonly Corner[])[] = [
  [],
  [
    [-0.89, -0.89],
    [0.89, -0.89],
    [0.89, 0.89],
    [-0.89, 0.89],
  ],
  [
    [0, -1.3],
    [1.2, 0.8],
    [-1.2, 0.8],
  ],
  [
    [0, -1.3],
    [1.2, 0],
    [0, 1.3],
    [-1.2, 0],
  ],
  [
    [0, 1.3],
    [-1.2, -0.8],
    [1.2, -0.8],
  ],
  [
    [-0.42, -1.2],
    [0.42, -1.2],
    [0.42, -0.42],
    [1.2, -0.42],
    [1.2, 0.42],
    [0.42, 0.42],
    [0.42, 1.2],
    [-0.42, 1.2],
    [-0.42, 0.42],
    [-1.2, 0.42],
    [-1.2, -0.42],
    [-0.42, -0.42],
  ],
  [
    [0, -0.59],
    [0.55, -1.14],
    [1.14, -0.55],
    [0.59, 0],
    [1.14, 0.55],
    [0.55, 1.14],
    [0, 0.59],
    [-0.55, 1.14],
    [-1.14, 0.55],
    [-0.59, 0],
    [-1.14, -0.55],
    [-0.55, -1.14],
  ],
  [
    [0, -1.4],
    [0.33, -0.45],
    [1.33, -0.43],
    [0.53, 0.17],
    [0.82, 1.13],
    [0, 0.56],
    [-0.82, 1.13],
    [-0.53, 0.17],
    [-1.33, -0.43],
    [-0.33, -0.45],
  ],
];

/** The index of the shape of class `number`. */
export function markerShape(number: number): number {
  return (number + Math.floor(number / kOutlines.length)) % kOutlines.length;
}

export function marker(number: number, x: number, y: number, radius: number): SVGPathElement {
  const d = markerPath(markerShape(number), x, y, radius);
  return shape("path", { d, fill: classColour(number), class: "marker" });
}

export function markerPath(which: number, x: number, y: number, radius: number): string {
  const outline = kOutlines[which] ?? [];
  if (outline.length === 0) return circle(x, y, radius);
  const corners = outline.map(([dx, dy]) => `${rounded(x + dx * radius)} ${rounded(y + dy * radius)}`);
  return `M${corners.join("L")}Z`;
}

/** The markers of classes as symbols of Observable Plot. */
export function plotSymbol(which: number): { draw(context: CanvasPath, size: number): void } {
  const outline = kOutlines[which % kOutlines.length] ?? [];
  return {
    draw: (context, size) => {
      const radius = Math.sqrt(size / Math.PI);
      if (outline.length === 0) context.arc(0, 0, radius, 0, 2 * Math.PI);
      outline.forEach(([x, y], i) =>
        i === 0 ? context.moveTo(x * radius, y * radius) : context.lineTo(x * radius, y * radius),
      );
      context.closePath();
    },
  };
}

function circle(x: number, y: number, radius: number): string {
  const r = rounded(radius);
  const arc = `a${r} ${r} 0 1 0`;
  return `M${rounded(x - radius)} ${rounded(y)}${arc} ${2 * r} 0${arc} ${-2 * r} 0Z`;
}
