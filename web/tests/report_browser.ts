// Common steps of the tests of the report's page.

import { readFileSync } from "node:fs";

import type { Browser, Download, Locator, Page } from "playwright-core";
import { afterAll, beforeAll } from "vitest";

import type { ReportData } from "../src/report/unpacked";
import { asScriptText, launchBrowser, writeReport } from "./browser";

/** The report as a file has it: every exploration once, to which systems refer by number. */
export function fileText(data: ReportData): string {
  const moments: unknown[] = [];
  const systems = data.systems.map((system) => ({
    ...system,
    moments: system.moments.map((one) => (one === null ? null : moments.push(one) - 1)),
  }));
  return asScriptText({ ...data, systems, moments });
}

interface Opened {
  page: Page;
  problems: string[];
}

/** A browser for a file of tests, and reports in it. */
export class ReportBrowser {
  browser!: Browser;

  constructor() {
    beforeAll(async () => {
      this.browser = await launchBrowser();
    });
    afterAll(() => this.browser.close());
  }

  async open(of: ReportData | string, options: Parameters<Browser["newPage"]>[0] = {}): Promise<Opened> {
    const viewport = { width: 1280, height: 800 };
    const page = await this.browser.newPage({ viewport, acceptDownloads: true, ...options });
    page.setDefaultTimeout(20_000);
    const problems: string[] = [];
    page.on("pageerror", (error) => problems.push(error.message));
    page.on("console", (message) => {
      if (message.type() === "error") problems.push(message.text());
    });
    await page.goto(writeReport(typeof of === "string" ? of : fileText(of)));
    return { page, problems };
  }
}

/** Opens all parts of a section, and goes there as its link does, so that all of it is drawn. */
export async function goTo(page: Page, id: string): Promise<Locator> {
  const section = page.locator(`#${id}`);
  await page.evaluate((hash) => (location.hash = hash), id);
  await section.locator("details.block").evaluateAll((all) => all.forEach((one) => one.setAttribute("open", "")));
  await page.evaluate((hash) => (location.hash = hash), `${id}?`);
  await page.waitForFunction((of) => !document.querySelector(`[id="${of}"] .lazy:empty`), id);
  return section;
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
