// The view page before a server that speaks its protocol, as each test of it has it.

import type { Browser, Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, expect, vi } from "vitest";

import type { State } from "../src/view/data";
import { FakeServer } from "./fake_server";
import { complaints, firstFrame, kPages, launchBrowser } from "./view_browser";

interface Look {
  colorScheme?: "dark" | "light";
  width?: number;
}

export class ViewedPage {
  browser!: Browser;
  server!: FakeServer;
  page!: Page;
  private problems: string[] = [];

  /**
   * A browser for a file of tests; a test fails when its page complains. Drawing in three dimensions takes
   * most of a test's time: tests that do not look at the scene launch a browser without.
   */
  constructor(launch = launchBrowser) {
    vi.setConfig({ testTimeout: 60_000, hookTimeout: 60_000 });
    beforeAll(async () => {
      this.browser = await launch();
    });
    afterAll(() => this.browser.close());
    afterEach(async () => {
      await this.page.close();
      await this.server.stop();
      expect(this.problems).toEqual([]);
    });
  }

  async open(state?: State, look: Look = {}): Promise<void> {
    await this.serve(state);
    const { colorScheme = "light", width = 1280 } = look;
    await this.visit({ viewport: { width, height: 800 }, colorScheme, reducedMotion: "reduce" });
    await this.page.goto(this.server.address);
    if (this.server.state.explorations.length > 0) await firstFrame(this.page);
  }

  async serve(state?: State): Promise<void> {
    this.server = new FakeServer(kPages, state);
    await this.server.start();
  }

  /** A new page that has not gone anywhere. */
  async visit(options: Parameters<Browser["newPage"]>[0], browser = this.browser): Promise<void> {
    this.page = await browser.newPage(options);
    this.problems = complaints(this.page);
  }

  async received(command: object): Promise<void> {
    await soon(() => this.server.commands).toContainEqual(command);
  }
}

/** Expected before long: how soon depends on the machine. */
export const soon = <T>(read: () => T) => expect.poll(read, { timeout: 60_000 });
