// Saved figures: pixels that are the data, fonts, width, caption and metadata.

import { inflateSync } from "node:zlib";

import type { Locator, Page } from "playwright-core";
import { beforeAll, expect, test } from "vitest";

import { between, kSequence, type Colour } from "../src/parts/colour_maps";
import { checksum } from "../src/parts/png_text";
import { screenshotPath } from "./browser";
import { figureOf, goTo, ReportBrowser, saved } from "./report_browser";
import { reportFixture } from "./report_fixture";

const report = new ReportBrowser();
const data = reportFixture();
const hand = data.systems[0]!;
let page: Page;
let section: Locator;

beforeAll(async () => {
  ({ page } = await report.open(data, { colorScheme: "dark" }));
  section = await goTo(page, "t_mpsom_multiplied");
});

/** The colours of points of a saved SVG, given in its own coordinates, in a page without the report. */
async function coloursOf(svg: string, points: [number, number][]): Promise<Colour[]> {
  const other = await report.browser.newPage();
  const colours = await other.evaluate(
    async ([text, places]) => {
      const image = new Image();
      image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
      await image.decode();
      const [left, top, width] = /viewBox="([^"]+)"/.exec(text)![1]!.split(" ").map(Number) as [number, number, number];
      const scale = (3 * image.naturalWidth) / width;
      const canvas = document.createElement("canvas");
      [canvas.width, canvas.height] = [3 * image.naturalWidth, 3 * image.naturalHeight];
      const context = canvas.getContext("2d")!;
      context.drawImage(image, 0, 0, canvas.width, canvas.height);
      return places.map(([x, y]) => [...context.getImageData((x - left) * scale, (y - top) * scale, 1, 1).data.slice(0, 3)]);
    },
    [svg, points] as const,
  );
  await other.close();
  return colours as unknown as Colour[];
}

function differsBy(one: Colour, other: Colour): number {
  return Math.max(...one.map((part, i) => Math.abs(part - other[i]!)));
}

test("the pixels of a saved heat map are the data, without smoothing", async () => {
  const touch = hand.moments[0]!.channels[0]!;
  const { bytes } = await saved(figureOf(section, "Touch over time"), "SVG");
  const svg = bytes.toString("utf8");
  expect(svg).not.toContain("<image");
  const values = touch.series.flat().map((value) => value ?? 0);
  const [low, high] = [Math.min(...values), Math.max(...values)];
  // The rectangle of the matrix: 34, 8, 460 wide and 7 pixels for each of 45 elements.
  const cells = touch.series.flatMap((row, frame) => row.map((value, i) => ({ value: value ?? 0, frame, i })));
  const some = cells.filter((_, i) => i % 97 === 0);
  const columns = touch.series.length;
  // Points near two corners of each cell, which smoothing would mix with its neighbours.
  const near = (share: number) =>
    some.map(({ frame, i }): [number, number] => [34 + ((frame + share) * 460) / columns, 8 + ((i + share) * 315) / 45]);
  for (const share of [0.25, 0.75]) {
    const colours = await coloursOf(svg, near(share));
    some.forEach(({ value }, k) => {
      // 256 steps of colours, each of which differs by a few units from the next.
      const expected = between(kSequence, (value - low) / (high - low));
      expect(differsBy(colours[k]!, expected)).toBeLessThanOrEqual(3);
    });
  }
});

test("the pixels of all planes are the weights", async () => {
  const planes = hand.trained!.planes[0]!;
  const { bytes } = await saved(figureOf(section, "Component planes of touch, arranged on the hand"), "SVG");
  const svg = bytes.toString("utf8");
  expect(svg).not.toContain("<image");
  const all = planes.values.flat().map((value) => value ?? 0);
  const [low, high] = [Math.min(...all), Math.max(...all)];
  // Where the pixels of the first two elements lie: 15 x 15 neurons in a box of the page's picture.
  const boxes = await figureOf(section, "Component planes of touch, arranged on the hand")
    .locator("image")
    .evaluateAll((images) => images.slice(0, 2).map((one) => ["x", "y", "width"].map((name) => Number(one.getAttribute(name)))));
  for (const [element, [x, y, side]] of boxes.entries()) {
    const points = planes.values.map((_, neuron): [number, number] => [
      x! + (((neuron % 15) + 0.3) * side!) / 15,
      y! + ((Math.floor(neuron / 15) + 0.3) * side!) / 15,
    ]);
    const colours = await coloursOf(svg, points);
    planes.values.forEach((values, neuron) => {
      const expected = between(kSequence, ((values[element] ?? 0) - low) / (high - low));
      expect(differsBy(colours[neuron]!, expected)).toBeLessThanOrEqual(3);
    });
  }
});

test("a file has its fonts, its title and caption, and what made it", async () => {
  const figure = figureOf(section, "U-matrix");
  const { download, bytes } = await saved(figure, "SVG");
  expect(download.suggestedFilename()).toBe("t_mpsom_multiplied-u-matrix-train_is_test-object-seed-1.svg");
  const svg = bytes.toString("utf8");
  for (const part of [
    "<title>U-matrix</title>",
    "<desc>Train = test, by object, seed 1. The mean distance",
    `Software: Somato ${data.somato}<`,
    `Data: ${hand.data_hash}<`,
    "Selection: Train = test, by object, seed 1<",
    "font/woff2;base64,",
    "boccia", // the legend of the markers
  ])
    expect(svg).toContain(part);
  expect(svg).not.toMatch(/var\(|light-dark|class=|NaN|aria-/);
  const png = await saved(figure, "PNG");
  const texts = textsOf(png.bytes);
  expect(texts.get("Title")).toBe("U-matrix");
  expect(texts.get("Data")).toBe(hand.data_hash);
  expect(texts.get("Selection")).toBe("Train = test, by object, seed 1");
});

/** The texts of a PNG file, whose checksums must be right and whose pixels must be readable. */
function textsOf(png: Buffer): Map<string, string> {
  const texts = new Map<string, string>();
  const pixels: Buffer[] = [];
  for (let at = 8; at < png.length; ) {
    const length = png.readUInt32BE(at);
    const type = png.subarray(at + 4, at + 8).toString("latin1");
    const content = png.subarray(at + 8, at + 8 + length);
    expect(png.readUInt32BE(at + 8 + length)).toBe(checksum(png.subarray(at + 4, at + 8 + length)));
    if (type === "tEXt") texts.set(...(content.toString("latin1").split("\0") as [string, string]));
    if (type === "IDAT") pixels.push(content);
    at += length + 12;
  }
  expect(inflateSync(Buffer.concat(pixels)).length).toBeGreaterThan(1000);
  return texts;
}

test("a file is as wide as is chosen, without a caption if none is wanted", async () => {
  const figure = figureOf(section, "Winners");
  await page.getByRole("combobox", { name: "Width" }).selectOption({ label: "85 mm" });
  await page.getByRole("checkbox", { name: "Title and caption" }).uncheck();
  const svg = (await saved(figure, "SVG")).bytes.toString("utf8");
  expect(svg).toMatch(/<svg[^>]* width="85mm" height="[\d.]+mm"/);
  expect(svg.match(/Each marker is a sample/g)!.length).toBe(2); // description and metadata
  const png = (await saved(figure, "PNG")).bytes;
  expect(png.readUInt32BE(16)).toBe(Math.ceil((85 * 600) / 25.4));
  await page.getByRole("combobox", { name: "Width" }).selectOption({ label: "as shown" });
  await page.getByRole("checkbox", { name: "Title and caption" }).check();
  const whole = (await saved(figure, "SVG")).bytes;
  const separate = await report.browser.newPage();
  await separate.setContent(`<img src="data:image/svg+xml;base64,${whole.toString("base64")}">`);
  await separate.locator("img").evaluate((image: HTMLImageElement) => image.decode());
  await separate.locator("img").screenshot({ path: screenshotPath("report-saved-winners") });
  await separate.close();
});

test("tables are saved as LaTeX, and the program can be cited", async () => {
  const figure = figureOf(page.locator("#overview"), "Systems");
  const tex = (await saved(figure, "LaTeX")).bytes.toString("utf8");
  expect(tex).toContain("\\begin{tabular}{llr");
  expect(tex).toContain("t\\_mpsom\\_multiplied & ");
  expect(tex.match(/\\\\$/gm)!.length).toBe(4); // the head and three systems
  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "BibTeX" }).click();
  expect((await waiting).suggestedFilename()).toBe("somato.bib");
});
