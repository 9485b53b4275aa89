// The view page before a server that speaks its protocol, as each test of it has it.

import type { Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, expect } from "vitest";

import type { State } from "../../src/view/data";
import { FakeServer } from "./fake_server";
import { complaints, firstFrame, kPages, sceneBrowser } from "./view_browser";

const kPatience = 120_000; // ms, for machines of any speed
const kViewport = { width: 1280, height: 800 };

interface Look {
  colorScheme?: "dark" | "light";
  width?: number;
}

export class ViewedPage {
  server!: FakeServer;
  page!: Page;
  private problems: string[] = [];

  /**
   * A page for a file of tests, which go from server to server in it; a test fails when the page complains. Drawing
   * in three dimensions takes most of a test's time: tests that do not look at the scene use a browser without.
   */
  constructor(private readonly browser = sceneBrowser) {
    beforeAll(() => this.renew());
    afterAll(() => this.page.close());
    afterEach(() => this.leave());
  }

  /** Another page, which has not gone anywhere. */
  async renew(): Promise<void> {
    await (this.page as Page | undefined)?.close();
    const browser = await this.browser();
    this.page = await browser.newPage({ viewport: kViewport, reducedMotion: "reduce" });
    this.page.setDefaultTimeout(kPatience);
    this.problems = complaints(this.page);
  }

  async open(state?: State, look: Look = {}): Promise<void> {
    await this.serve(state);
    const { colorScheme = "light", width = kViewport.width } = look;
    await this.page.setViewportSize({ ...kViewport, width });
    await this.page.emulateMedia({ colorScheme });
    await this.page.goto(this.server.address);
    if (this.server.state.explorations.length > 0) await firstFrame(this.page);
  }

  async serve(state?: State): Promise<void> {
    this.server = new FakeServer(kPages, state);
    await this.server.start();
  }

  async leave(): Promise<void> {
    await this.page.goto("about:blank");
    await this.page.mouse.move(0, 0);
    await this.server.stop();
    expect(this.problems.splice(0)).toEqual([]);
  }

  async received(command: object): Promise<void> {
    await soon(() => this.server.commands).toContainEqual(command);
  }
}

/** Expected before long: how soon depends on the machine. */
export const soon = <T>(read: () => T) => expect.poll(read, { timeout: kPatience });
