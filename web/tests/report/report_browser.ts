// Common steps of the tests of the report's page.

import { readFileSync } from "node:fs";

import type { Browser, Download, Locator, Page } from "playwright-core";
import { afterAll, beforeAll } from "vitest";

import type { ReportData } from "../../src/report/page/unpacked";
import { asScriptText, flatBrowser, writeReport } from "../browser";

/** The report as a file has it: every exploration once, to which systems refer by number. */
export function fileText(data: ReportData): string {
  const moments: unknown[] = [];
  const systems = data.systems.map((system) => ({
    ...system,
    moments: system.moments.map((one) => (one === null ? null : moments.push(one) - 1)),
  }));
  return asScriptText({ ...data, systems, moments });
}

interface Look {
  colorScheme?: "dark" | "light";
  reducedMotion?: "reduce";
  width?: number;
  height?: number;
}

interface Opened {
  page: Page;
  problems: string[];
}

const kUsual = { colorScheme: "light", reducedMotion: "no-preference" } as const;

/** A page for a file of tests, and one report after the other in it. */
export class ReportBrowser {
  browser!: Browser;
  private page!: Page;
  private problems: string[] = [];

  constructor() {
    beforeAll(async () => {
      this.browser = await flatBrowser();
      this.page = await this.browser.newPage({ acceptDownloads: true });
      this.page.setDefaultTimeout(120_000);
      this.watch();
    });
    afterAll(() => this.page.close());
  }

  async open(of: ReportData | string, look: Look = {}): Promise<Opened> {
    const { width = 1280, height = 800, ...media } = look;
    await this.page.setViewportSize({ width, height });
    await this.page.emulateMedia({ ...kUsual, ...media, media: "screen" });
    await this.page.mouse.move(0, 0);
    this.problems = [];
    await this.page.goto(writeReport(typeof of === "string" ? of : fileText(of)));
    return { page: this.page, problems: this.problems };
  }

  private watch(): void {
    this.page.on("pageerror", (error) => this.problems.push(error.message));
    this.page.on("console", (message) => {
      if (message.type() === "error") this.problems.push(message.text());
    });
  }
}

/** Opens all parts of a section, and goes there as its link does, so that all of it is drawn. */
export async function goTo(page: Page, id: string): Promise<Locator> {
  const section = page.locator(`#${id}`);
  await page.evaluate((hash) => (location.hash = hash), id);
  await section.locator("details.block").evaluateAll((all) => all.forEach((one) => one.setAttribute("open", "")));
  await page.evaluate((hash) => (location.hash = hash), `${id}?`);
  await page.waitForFunction((of) => !document.querySelector(`[id="${of}"] .lazy:empty`), id);
  await waitForVisibleParts(page);
  return section;
}

/** Scrolls to a place, which then stays where it is: a part that is drawn above it while a button is pressed moves it away. */
export async function scrollTo(place: Locator): Promise<Locator> {
  await place.scrollIntoViewIfNeeded();
  await waitForVisibleParts(place.page());
  return place;
}

/** Waits until the parts in and near the visible area are drawn, whose heights differ from those reserved for them. */
async function waitForVisibleParts(page: Page): Promise<void> {
  await page.waitForFunction(() => {
    const pending = [...document.querySelectorAll(".lazy:empty")].filter((part) => part.checkVisibility());
    const areas = pending.map((part) => part.getBoundingClientRect());
    return !areas.some(({ top, bottom }) => bottom > -500 && top < innerHeight + 500);
  });
}

export function figureOf(section: Locator, title: string): Locator {
  return section.locator(`figure[aria-label="${title}"]`);
}

export async function saved(figure: Locator, kind: string): Promise<{ download: Download; bytes: Buffer }> {
  const waiting = figure.page().waitForEvent("download");
  await figure.getByRole("button", { name: new RegExp(`^${kind}:`) }).click();
  const download = await waiting;
  return { download, bytes: readFileSync(await download.path()) };
}

export async function savedRows(figure: Locator): Promise<string[][]> {
  const { bytes } = await saved(figure, "CSV");
  return bytes
    .toString("utf8")
    .trimEnd()
    .split("\r\n")
    .map((line) => line.split(","));
}

export async function readoutAt(figure: Locator, cell: number): Promise<string> {
  await figure.locator(`[data-cell="${cell}"]`).hover();
  return (await figure.locator(".readout").textContent()) ?? "";
}
