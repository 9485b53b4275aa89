import { describe, expect, test } from "vitest";

import {
  classHex,
  divergingColour,
  kClassColours,
  lightness,
  parsed,
  sequenceColour,
  type Colour,
} from "../../src/parts/maps/colour_maps";
import { markerPath, markerShape } from "../../src/parts/maps/markers";

const shares = Array.from({ length: 101 }, (_, i) => i / 100);
const lightnessOf = (text: string) => lightness(parsed(text));

/** As people without the green (or the red) cones see it: Viénot, Brettel and Mollon 1999. */
function seenBy(colour: Colour, kind: "deuteranope" | "protanope"): number[] {
  const [r, g, b] = colour.map((part) => (part / 255) ** 2.2) as [number, number, number];
  const rows = {
    protanope: [
      [0.11238, 0.88762, 0],
      [0.11238, 0.88762, 0],
      [0.00401, -0.00401, 1],
    ],
    deuteranope: [
      [0.29275, 0.70725, 0],
      [0.29275, 0.70725, 0],
      [-0.02234, 0.02234, 1],
    ],
  }[kind];
  return rows.map(([x, y, z]) => Math.max(0, (x ?? 0) * r + (y ?? 0) * g + (z ?? 0) * b) ** (1 / 2.2) * 255);
}

describe("colours for numbers", () => {
  test("get lighter evenly along the sequence", () => {
    const steps = shares.map((share) => lightnessOf(sequenceColour(share)));
    const rises = steps.slice(1).map((step, i) => step - steps[i]!);
    expect(Math.min(...rises)).toBeGreaterThan(0);
    expect(steps.at(-1)! - steps[0]!).toBeGreaterThan(75);
    // No stretch of a tenth rises more than twice as much as another.
    const tenths = Array.from({ length: 10 }, (_, i) => steps[10 * (i + 1)]! - steps[10 * i]!);
    expect(Math.max(...tenths) / Math.min(...tenths)).toBeLessThan(2);
  });

  test("get lighter to the middle of the diverging ones, and darker again", () => {
    const steps = shares.map((share) => lightnessOf(divergingColour(share)));
    for (let i = 1; i <= 50; i += 1) expect(steps[i]!).toBeGreaterThan(steps[i - 1]!);
    for (let i = 51; i <= 100; i += 1) expect(steps[i]!).toBeLessThan(steps[i - 1]!);
    expect(Math.abs(steps[0]! - steps[100]!)).toBeLessThan(5);
  });

  test("keep both ends of the diverging ones apart for those without red or green", () => {
    for (const kind of ["deuteranope", "protanope"] as const) {
      const [one, other] = [0.1, 0.9].map((share) => seenBy(parsed(divergingColour(share)), kind));
      expect(Math.hypot(...one!.map((part, i) => part - other![i]!))).toBeGreaterThan(60);
    }
  });

  test("take what is out of range, or no number, as an end", () => {
    expect(sequenceColour(-3)).toBe(sequenceColour(0));
    expect(sequenceColour(7)).toBe(sequenceColour(1));
    expect(sequenceColour(Number.NaN)).toBe(sequenceColour(0));
  });
});

describe("signs of classes", () => {
  test("are 64 different pairs of colour and shape", () => {
    const pairs = Array.from({ length: 64 }, (_, i) => `${classHex(i)} ${markerShape(i)}`);
    expect(new Set(pairs).size).toBe(64);
  });

  test("have eight colours and eight shapes among the first eight", () => {
    expect(kClassColours).toBe(8);
    const first = Array.from({ length: 8 }, (_, i) => i);
    expect(new Set(first.map(classHex)).size).toBe(8);
    expect(new Set(first.map((i) => markerPath(markerShape(i), 0, 0, 1))).size).toBe(8);
  });
});
