// The view page of the real program: what stands on it is what the recording holds and what the
// study found. SOMATO_PROGRAM is the program, SOMATO_MCAP_SCRIPTS where tests/mcap has put the
// official reader of MCAP files.

import { type ChildProcess, spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";

import { parsed, sequenceColour } from "../../src/parts/maps/colour_maps";
import { digits } from "../../src/parts/numbers";
import { output, somato } from "../program";
import {
  bandColour,
  complaints,
  firstFrame,
  frameShown,
  sceneBrowser,
  screenshot,
  words,
} from "./view_browser";

interface Message {
  topic: string;
  value: { event?: string; index?: number; values: number[] };
}

const program = process.env["SOMATO_PROGRAM"] ?? "";
const scripts = process.env["SOMATO_MCAP_SCRIPTS"] ?? "";
const folder = mkdtempSync(join(tmpdir(), "somato-view-"));
const recording = join(folder, "hand2.mcap");
const source = process.env["SOMATO_SOURCE"] ?? new URL("../../..", import.meta.url).pathname;
const systems = join(source, "systems");

let page: Page;
let problems: string[];
let view: ChildProcess;
let messages: Message[];
let predictions: string[];

beforeAll(async () => {
  expect(program, "SOMATO_PROGRAM names the program").not.toBe("");
  expect(scripts, "SOMATO_MCAP_SCRIPTS names where the MCAP reader is").not.toBe("");
  await somato(["explore", "--body", "lucs2", "--explorations", "2", "-o", recording]);
  const study = join(systems, "tensor_chain.toml");
  await somato(["run", study, "--data", recording, "--out", folder, "--seeds", "1"]);
  messages = await recorded();
  predictions = predicted();
  view = spawn(program, ["view", recording, "--model", join(folder, "system.somato")], {
    stdio: ["ignore", "pipe", "inherit"],
  });
  const address = await startAddress(view);
  page = await (await sceneBrowser()).newPage({ viewport: { width: 1280, height: 800 } });
  problems = complaints(page);
  await page.goto(address);
  await firstFrame(page);
  await page.getByRole("button", { name: "Pause", exact: true }).click(); // it plays when somebody looks
  await page.getByRole("button", { name: "Play", exact: true }).waitFor();
});

afterAll(async () => {
  await page?.close();
  view?.kill();
  rmSync(folder, { recursive: true });
  expect(problems ?? []).toEqual([]);
});

async function recorded(): Promise<Message[]> {
  const text = await output(process.execPath, [join(scripts, "read.mjs"), recording]);
  return (JSON.parse(text) as { stream: Message[] }).stream;
}

function predicted(): string[] {
  interface Results {
    parts: { protocols: { protocol: string; runs: { predictions: string[] }[] }[] }[];
  }
  const { parts } = JSON.parse(readFileSync(join(folder, "results.json"), "utf8")) as Results;
  return parts[0]!.protocols.find(({ protocol }) => protocol === "train_is_test")!.runs[0]!.predictions;
}

function startAddress(program: ChildProcess): Promise<string> {
  return new Promise((found, failed) => {
    let said = "";
    program.on("exit", () => failed(new Error(`somato view has ended: ${said}`)));
    program.stdout!.on("data", (part: Buffer) => {
      said += String(part);
      const address = /http:\/\/\S+token=\w+/.exec(said)?.[0];
      if (address !== undefined) found(address);
    });
  });
}

const soon = <T>(read: () => T) => expect.poll(read, { timeout: 120_000 });

/** The values of a channel in an exploration, frame by frame. */
function framesOf(exploration: number, channel: string): number[][] {
  const begin = messages.findIndex(({ value }) => value.event === "begin" && value.index === exploration);
  const end = messages.findIndex(({ value }) => value.event === "end" && value.index === exploration);
  return messages
    .slice(begin, end)
    .filter(({ topic }) => topic === `/${channel}`)
    .map(({ value }) => value.values);
}

async function go(exploration: number, frame: number): Promise<void> {
  await page.getByLabel("Exploration", { exact: true }).selectOption(String(exploration));
  await frameShown(page, 0);
  await page.getByRole("slider", { name: "Frame" }).fill(String(frame));
  await frameShown(page, frame);
}

it("shows what the recording holds", async () => {
  await page.getByRole("button", { name: "height", exact: true }).click();
  for (const [exploration, frame] of [
    [0, 100],
    [3, 150],
  ] as const) {
    await go(exploration, frame);
    const degrees = framesOf(exploration, "joints")[frame]!.map((angle) => (angle * 180) / Math.PI);
    await soon(() => page.locator("[data-channel=joints] .strip-value .number").allInnerTexts()).toEqual(
      degrees.map(digits),
    );
    const touch = framesOf(exploration, "touch")[frame]!;
    await soon(() => words(page, "[data-channel=touch] .strip-values")).toContain(
      `max ${digits(Math.max(...touch))} at`,
    );
    await soon(() => words(page, "[data-channel=height] .strip-value .number")).toBe(
      digits(framesOf(exploration, "height")[frame]![0]!),
    );
  }
  await screenshot(page, "view-program");
});

it("shows all that was felt over an exploration after a jump into it", async () => {
  for (const channel of ["height", "joints"])
    await page.getByRole("button", { name: channel, exact: true }).click();
  const felt = framesOf(2, "touch");
  await go(2, felt.length - 1);
  const most = Math.max(...felt.flat());
  const frame = felt.findIndex((touch) => Math.max(...touch) === most);
  const taxel = felt[frame]!.indexOf(most);
  const height = (taxel + 0.5) / felt[0]!.length;
  // Frames are not quite evenly spaced.
  const times = [-1, -0.5, 0, 0.5, 1, 1.5].map((step) => (frame + step) / (felt.length - 1));
  const around = () => Promise.all(times.map((time) => bandColour(page, "touch", time, height)));
  await soon(around).toContainEqual(parsed(sequenceColour(1)));
  expect(await bandColour(page, "touch", 0.01, height)).toEqual(parsed(sequenceColour(0)));
});

it("reads at the end what the study has read", async () => {
  for (let exploration = 0; exploration < predictions.length; exploration += 1) {
    await go(exploration, framesOf(exploration, "touch").length - 1);
    await soon(() => words(page, ".reading-answer")).toBe(predictions[exploration]);
  }
});

it("plays and pauses", async () => {
  await go(0, 10);
  await page.keyboard.press("Space");
  await page.waitForFunction(
    () => Number(document.querySelector<HTMLInputElement>(".transport input[type=range]")!.value) > 14,
  );
  await page.keyboard.press("Space");
  await soon(() => page.getByRole("button", { name: "Play", exact: true }).count()).toBe(1);
});

it("shows what neurons and touch sensors represent", async () => {
  await page.locator(".panel-map [data-cell='112']").click();
  await page.waitForSelector(".nearest li");
  await page.getByLabel("Touch sensor", { exact: true }).selectOption("20");
  await page.waitForSelector(".closer .map-picture");
});

it("says that the program has ended", async () => {
  view.kill();
  await page
    .locator(".link-banner", { hasText: "The program has ended or the connection is lost" })
    .waitFor();
});
