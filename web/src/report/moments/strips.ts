// Distributions as strips: for each metric the values of all runs, those of wrong groupings below,
// and marks for the paper and the nearest neighbour.

import { countOf, median, rangeOf, readable } from "../../parts/numbers";
import { rounded, shape, shortened, svg, text } from "../../parts/svg";

export interface Strip {
  metric: string;
  name: string;
  values: (number | null)[];
  chance: (number | null)[];
  baseline: number | null;
  published: number | null;
  range: [number, number] | null; // null: as far as the values go
}

const kNames = 312;
const kWidth = 530;
const kRight = 40;
const kRow = 54;
const kHead = 34;

export function stripsPicture(strips: readonly Strip[], label: string): SVGSVGElement {
  const rows = strips.map((strip, i) => row(strip, kHead + i * kRow));
  return svg(kNames + kWidth + kRight, kHead + strips.length * kRow, label, [legend(strips), ...rows]);
}

/** The legend of the signs in the picture. */
function legend(strips: readonly Strip[]): SVGGElement {
  const entries: [string, SVGElement, (strip: Strip) => boolean][] = [
    ["run", dot(0, 0, 4.5, "run"), () => true],
    ["median", shape("path", { d: "M0 -8V8", class: "median" }), () => true],
    ["wrong groupings", dot(0, 0, 3.5, "chance"), ({ chance }) => chance.length > 0],
    ["paper", shape("path", { d: diamond(0, 0), class: "published" }), ({ published }) => published !== null],
    [
      "nearest neighbour",
      shape("path", { d: "M0 -8V8", class: "baseline" }),
      ({ baseline }) => baseline !== null,
    ],
  ];
  let x = kNames;
  const shown = entries.filter(([, , isDrawn]) => strips.some(isDrawn));
  const drawn = shown.map(([name, sign]) => {
    const at = x;
    x += 26 + name.length * 6.4;
    const group = shape("g", { transform: `translate(${rounded(at + 5)} 10)` }, [
      sign,
      text(11, 4, name, { class: "muted note" }),
    ]);
    return group;
  });
  return shape("g", { class: "strip-legend" }, drawn);
}

function row(strip: Strip, y: number): SVGGElement {
  const [low, high] = domainOf(strip);
  const x = (value: number) => kNames + ((value - low) / (high - low || 1)) * kWidth;
  const middle = median(numbers(strip.values).sort((one, other) => one - other));
  const group = shape("g", { transform: `translate(0 ${y})`, class: "strip" }, [
    shape("title", {}, [strip.metric]),
    text(0, 15, shortened(strip.name, kNames - 16, 12)),
    text(0, 31, middle === null ? "no value" : `median ${readable(middle)}`, { class: "muted note" }),
    shape("path", { d: `M${kNames} 14H${kNames + kWidth}`, class: "axis" }),
    text(kNames, 46, readable(low), { class: "muted note" }),
    text(kNames + kWidth, 46, readable(high), { class: "muted note end" }),
  ]);
  group.append(...dots(strip.chance, x, 27, 3, "chance"), ...dots(strip.values, x, 14, 3.2, "run"));
  if (middle !== null) group.append(shape("path", { d: `M${rounded(x(middle))} 2V26`, class: "median" }));
  if (strip.baseline !== null)
    group.append(shape("path", { d: `M${rounded(x(strip.baseline))} -1V29`, class: "baseline" }));
  if (strip.published !== null)
    group.append(shape("path", { d: diamond(x(strip.published), 1), class: "published" }));
  return group;
}

function numbers(values: (number | null)[]): number[] {
  return values.filter((value): value is number => value !== null && Number.isFinite(value));
}

function domainOf(strip: Strip): [number, number] {
  const marks = [strip.baseline, strip.published];
  const seen = rangeOf([...strip.values, ...strip.chance, ...marks, ...(strip.range ?? [0])]) ?? [0, 1];
  return seen[0] === seen[1] ? [seen[0], seen[0] + 1] : seen;
}

const kBins = 125; // runs that come within 4 pixels are one dot

function dots(
  values: (number | null)[],
  x: (value: number) => number,
  y: number,
  radius: number,
  kind: string,
): SVGElement[] {
  const bins = new Map<number, number[]>();
  for (const value of numbers(values)) {
    const bin = Math.round(((x(value) - kNames) / kWidth) * kBins);
    bins.set(bin, [...(bins.get(bin) ?? []), value]);
  }
  return [...bins.values()].map((together) => {
    const mean = together.reduce((sum, value) => sum + value, 0) / together.length;
    const made = dot(x(mean), y, radiusFor(radius, together.length), kind);
    made.append(shape("title", {}, [`${readable(mean)}: ${countOf(together.length, "run")}`]));
    return made;
  });
}

const kLargest = 10.5;

/** Areas are proportional to the numbers, but no dot exceeds its row. */
function radiusFor(radius: number, count: number): number {
  return Math.min(kLargest, radius * Math.sqrt(1 + (count - 1) * 0.22));
}

function dot(x: number, y: number, radius: number, kind: string): SVGCircleElement {
  return shape("circle", { cx: rounded(x), cy: y, r: rounded(radius), class: `dot ${kind}` });
}

function diamond(x: number, y: number): string {
  return `M${rounded(x)} ${y - 5}l5 5l-5 5l-5 -5Z`;
}
