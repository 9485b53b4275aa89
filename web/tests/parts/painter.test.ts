import { describe, expect, test } from "vitest";

import { parsed, sequenceColour } from "../../src/parts/maps/colour_maps";
import { painter, pixel, pixelRamp, pixelsOf, ramp, scaled } from "../../src/parts/maps/painter";

describe("a ramp", () => {
  test("takes the nearest of its steps; shares outside count as the ends, no number as 0", () => {
    const quarters = ramp((share) => share, 4);
    const shares = [0, 0.12, 0.13, 0.6, 1, -3, 7, Number.NaN];
    expect(shares.map(quarters)).toEqual([0, 0, 0.25, 0.5, 1, 0, 1, 0]);
  });

  test("is that of the range of the values; without a range all are at its low end", () => {
    const share = scaled((value) => value, -2, 2);
    expect([-2, 0, 1, 2].map(share)).toEqual([0, 0.5, 0.75, 1]);
    expect(scaled((value) => value, 3, 3)(3)).toBe(0);
  });

  test("has nothing for values that are missing", () => {
    const share = scaled((value) => value, 0, 1);
    expect([null, undefined, Number.NaN, Number.NEGATIVE_INFINITY].map(share)).toEqual([
      null,
      null,
      null,
      null,
    ]);
  });
});

/** A cell that counts how often it is touched. */
class FakeCell {
  fill = "";
  touched = 0;

  setAttribute(_: "fill", value: string): void {
    this.fill = value;
    this.touched += 1;
  }
}

test("cells whose colours stay are not touched again", () => {
  const cells = [new FakeCell(), new FakeCell(), new FakeCell()];
  const paint = painter(cells as unknown as SVGPathElement[], (share) => `share ${share}`);
  paint([0, 5, null], 0, 10);
  expect(cells.map(({ fill }) => fill)).toEqual(["share 0", "share 0.5", "none"]);
  paint([0.001, 10, null], 0, 10);
  expect(cells.map(({ fill }) => fill)).toEqual(["share 0", "share 1", "none"]);
  expect(cells.map(({ touched }) => touched)).toEqual([1, 2, 1]);
});

describe("pixels", () => {
  const bytes = (pixels: Uint32Array) => [...new Uint8Array(pixels.buffer)];

  test("stand row after row as red, green, blue and opacity; one without a colour is transparent", () => {
    const at = (x: number, y: number) => (x === 1 && y === 0 ? null : pixel([16 * x, y, 255]));
    expect(bytes(pixelsOf(2, 2, at))).toEqual([
      ...[0, 0, 255, 255],
      ...[0, 0, 0, 0],
      ...[0, 1, 255, 255],
      ...[16, 1, 255, 255],
    ]);
  });

  test("have the colours of the sequence, in so many steps", () => {
    for (const [share, step] of [
      [0, 0],
      [0.5, 128 / 255],
      [1, 1],
    ] as const)
      expect(pixelRamp(sequenceColour)(share)).toBe(pixel(parsed(sequenceColour(step))));
    expect(pixelRamp(sequenceColour, 256)(0.5)).toBe(pixel(parsed(sequenceColour(0.5))));
  });
});
