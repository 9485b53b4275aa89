// Pictures and films that `somato view --render` saves without a window: what they show is the page.

import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { afterAll, beforeAll, expect, it } from "vitest";

import { output, somato } from "../program";

const folder = mkdtempSync(join(tmpdir(), "somato-render-"));
const recording = join(folder, "pressed.mcap");

beforeAll(() => somato(["explore", "--body", "hardness", "--explorations", "1", "-o", recording]));
afterAll(() => rmSync(folder, { recursive: true }));

it("saves a picture of the view", async () => {
  const path = join(folder, "view.png");
  expect(await somato(["view", recording, "--render", path])).toContain("view.png: frame 1");
  const bytes = readFileSync(path);
  expect(bytes.subarray(1, 4).toString()).toBe("PNG");
  expect([bytes.readUInt32BE(16), bytes.readUInt32BE(20)]).toEqual([1600, 900]);
  expect(bytes.length).toBeGreaterThan(30_000); // an empty page has less
});

it("saves a picture of a demonstration", async () => {
  const path = join(folder, "demo.png");
  const words = ["view", "--demo", "--body", "hardness", "--exploration", "2", "--render", path];
  expect(await somato(words)).toContain("demo.png: frame 1");
  expect(readFileSync(path).length).toBeGreaterThan(30_000);
});

// The one moment of this recording is shown for a second. The head of the page is white, its panels are not black.
it("saves a film of the view", async () => {
  const [film, raw] = [join(folder, "view.webm"), join(folder, "view.i420")];
  expect(await somato(["view", recording, "--exploration", "2", "--render", film])).toContain("20 pictures at 20 a second");
  await output("vpxdec", ["--i420", "-o", raw, film]);
  const frame = (1600 * 900 * 3) / 2;
  const pixels = readFileSync(raw);
  expect(pixels.length).toBe(20 * frame);
  for (const first of [0, 19 * frame]) {
    expect(Math.abs(pixels[first + 1600 * 5 + 800]! - 235)).toBeLessThan(3);
    const luminance = pixels.subarray(first, first + 1600 * 900);
    expect(luminance.reduce((sum, value) => sum + value, 0) / luminance.length).toBeGreaterThan(150);
    expect(Math.min(...luminance.filter((_, i) => i % 97 === 0))).toBeLessThan(80);
  }
});

it("leaves no film behind if the encoder is missing", async () => {
  const film = join(folder, "none.webm");
  const only = { PATH: "/nowhere" };
  await expect(somato(["view", recording, "--render", film], { env: only })).rejects.toThrow(/chromium/);
  expect(existsSync(film)).toBe(false);
});
