// Saved figures: pixels that are the data, fonts, width, caption and metadata.

import { readFileSync } from "node:fs";
import { inflateSync } from "node:zlib";

import type { Locator, Page } from "playwright-core";
import { beforeAll, expect, test } from "vitest";

import { between, kSequence, parsed, type Colour } from "../../src/parts/maps/colour_maps";
import { checksum } from "../../src/parts/png_text";
import { kRest, touchColour } from "../../src/parts/hands/touch_colours";
import { screenshotPath } from "../browser";
import { figureOf, goTo, ReportBrowser, saved } from "./report_browser";
import { reportFixture } from "./report_fixture";

const report = new ReportBrowser();
const data = reportFixture();
const hand = data.systems[0]!;
const run = hand.protocols[0]!.runs[0]!;
let page: Page;
let section: Locator;

beforeAll(async () => {
  ({ page } = await report.open(data, { colorScheme: "dark" }));
  section = await goTo(page, "t_mpsom_multiplied");
});

interface Cell {
  box: [x: number, y: number, width: number, height: number]; // in the coordinates of the picture
  colour: Colour;
}

/** A message for each cell of a saved file in which any pixel has another colour than it demands. */
async function wrongCells(figure: Locator, cells: Cell[]): Promise<string[]> {
  const svg = (await saved(figure, "SVG")).bytes;
  const png = (await saved(figure, "PNG")).bytes;
  expect(svg.toString("utf8")).not.toContain("<image");
  const view = /viewBox="([^"]+)"/.exec(svg.toString("utf8"))![1]!.split(" ").map(Number);
  const files = [
    `data:image/svg+xml;base64,${svg.toString("base64")}`,
    `data:image/png;base64,${png.toString("base64")}`,
  ];
  const wrong = await Promise.all(files.map((file) => wrongPixels(file, view, cells)));
  return wrong.flat();
}

/** Opens the file in a page without the report. Pixels at the border of a cell may be mixed with those beside it. */
async function wrongPixels(file: string, view: number[], cells: Cell[]): Promise<string[]> {
  const other = await report.browser.newPage();
  const wrong = await other.evaluate(
    async ([address, [left, top, width], all]) => {
      const image = new Image();
      image.src = address;
      await image.decode();
      const canvas = document.createElement("canvas");
      const times = address.startsWith("data:image/svg") ? 3 : 1;
      [canvas.width, canvas.height] = [times * image.naturalWidth, times * image.naturalHeight];
      const context = canvas.getContext("2d")!;
      context.drawImage(image, 0, 0, canvas.width, canvas.height);
      const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
      const scale = canvas.width / width!;
      return all.flatMap(({ box: [x, y, wide, tall], colour }, cell) => {
        const [from, to] = [(x - left!) * scale, (x + wide - left!) * scale].map(Math.round);
        for (let row = Math.round((y - top!) * scale) + 2; row < Math.round((y + tall - top!) * scale) - 2; row += 1)
          for (let column = from! + 2; column < to! - 2; column += 1) {
            const at = 4 * (row * canvas.width + column);
            if (data[at] === colour[0] && data[at + 1] === colour[1] && data[at + 2] === colour[2]) continue;
            const shown = [...data.slice(at, at + 3)].join(" ");
            return [`${address.slice(0, 14)}, cell ${cell}: ${shown} instead of ${colour.join(" ")}`];
          }
        return [];
      });
    },
    [file, view, cells] as const,
  );
  await other.close();
  return wrong;
}

const kTallestOfTouch = 315; // 7 pixels for each of 45 elements

/** The nearest of `steps` colours of the scale. */
const stepped = (share: number, steps: number) => Math.round(Math.min(1, share) * steps) / steps;

test("every pixel of saved touch over time has the colour of its value", async () => {
  const touch = hand.moments[0]!.channels[0]!;
  const columns = touch.series.length;
  // The scale ends at a round number that nine of ten touched sensors do not exceed.
  const most = touch.channel.elements.map((_, i) => Math.max(...touch.series.map((row) => row[i] ?? 0)));
  const touched = most.filter((one) => one > 0.02 * Math.max(...most)).sort((one, other) => one - other);
  const end = [1, 1.5, 2, 3, 4, 5, 6, 8, 10].find((one) => one >= touched[Math.ceil(0.9 * touched.length) - 1]!)!;
  const cells = touch.series.flatMap((row, frame) =>
    row.map((value, i): Cell => {
      const box: Cell["box"] = [34 + (frame * 460) / columns, 8 + 7 * i, 460 / columns, kTallestOfTouch / 45];
      return { box, colour: parsed(touchColour(stepped((value ?? 0) / end, 256))) };
    }),
  );
  expect(new Set(cells.map(({ colour }) => colour.join())).size).toBeGreaterThan(20);
  expect(cells.filter(({ colour }) => colour.join() === kRest.join()).length).toBeGreaterThan(100);
  expect(await wrongCells(figureOf(section, "Touch over time"), cells)).toEqual([]);
});

test("every pixel of saved component planes has the colour of its weight", async () => {
  const planes = hand.trained!.planes[0]!;
  const figure = figureOf(section, "Component planes of touch, arranged on the hand");
  const all = planes.values.flat().map((value) => value ?? 0);
  const [low, high] = [Math.min(...all), Math.max(...all)];
  // Where the pixels of each element lie: 15 x 15 neurons in a box of the picture.
  const boxes = await figure
    .locator("image")
    .evaluateAll((images) => images.map((one) => ["x", "y", "width"].map((name) => Number(one.getAttribute(name)))));
  expect(boxes.length).toBe(45);
  const cells = boxes.flatMap(([x, y, side], element) =>
    planes.values.map((values, neuron): Cell => {
      const [row, column] = [Math.floor(neuron / 15), neuron % 15];
      const box: Cell["box"] = [x! + (column * side!) / 15, y! + (row * side!) / 15, side! / 15, side! / 15];
      return { box, colour: between(kSequence, stepped(((values[element] ?? 0) - low) / (high - low), 255)) };
    }),
  );
  expect(await wrongCells(figure, cells)).toEqual([]);
});

test("every pixel of a saved U-matrix has the colour of its distance", async () => {
  const distances = run.map!.u_matrix;
  const [low, high] = [Math.min(...distances), Math.max(...distances)];
  const winners = new Set(run.winners); // markers hide the colours of these
  const figure = figureOf(section, "U-matrix");
  const outlines = await figure.locator("[data-cell]").evaluateAll((all) =>
    all.map((one) => {
      const { x, y, width, height } = (one as SVGGraphicsElement).getBBox();
      return [x, y, width, height] as const;
    }),
  );
  // The picture has a margin of 3, and white lines of 0.7 between the cells.
  const cells = outlines.flatMap(([x, y, width, height], neuron): Cell[] =>
    winners.has(neuron)
      ? []
      : [
          {
            box: [x + 3.5, y + 3.5, width - 1, height - 1],
            colour: between(kSequence, stepped((distances[neuron]! - low) / (high - low), 128)),
          },
        ],
  );
  expect(cells.length).toBeGreaterThan(180);
  expect(await wrongCells(figure, cells)).toEqual([]);
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
  expect(tex).toContain("t mpsom multiplied & training samples & ");
  expect(tex.match(/\\\\$/gm)!.length).toBe(5); // the head, one of two systems and two of one
  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "BibTeX" }).click();
  expect((await waiting).suggestedFilename()).toBe("references.bib");
  const methods = page.waitForEvent("download");
  await page.getByRole("button", { name: "Methods" }).click();
  expect(readFileSync(await (await methods).path(), "utf8")).toContain("The system t mpsom multiplied~\\cite{");
});
