// The view page while things move: a demonstration, a training, the transparent hand, and the strips under
// the pointer.

import { describe, expect, it } from "vitest";

import type { Strips } from "../../src/view/data";
import { digits } from "../../src/parts/numbers";
import { bodyState, fakeFrame, fakeTraining, kFrames, kRate } from "./fake_frames";
import { kTaxels } from "./fake_hand";
import { frameShown, words } from "./view_browser";
import { soon, ViewedPage } from "./viewed_page";

const view = new ViewedPage();

/** A moment of an exploration that the body has not completed. */
const explored = (exploration: number, frame: number) => ({
  ...fakeFrame(exploration, frame),
  frames: null,
  last: false,
});

describe("a demonstration", () => {
  const demonstrated = () => ({
    ...bodyState(),
    demonstrated: 0,
    playing: true,
    live: true,
    exploration: 0,
    frames: null,
    duration: null,
  });

  it("shows the body at once, though its system is still trained", async () => {
    await view.open({ ...demonstrated(), maps: [], training: true, system_problem: "Not trained yet." });
    await soon(() => {
      view.server.send("frame", { ...explored(0, 10), maps: {}, reading: null });
      return view.page.locator(".scene[data-drawn]").count();
    }).toBe(1);
    expect(await words(view.page, ".panel-name .empty")).toContain("is being trained");
    expect(await view.page.getByRole("radio", { name: "activity" }).isChecked()).toBe(true);
  });

  it("names what the hand touches while it touches, and invites afterwards", async () => {
    await view.open(demonstrated());
    const answer = view.page.locator(".reading-answer");
    await soon(() => {
      view.server.send("frame", explored(0, 45));
      return answer.innerText();
    }).toBe(fakeFrame(0, 45).reading!.answer);
    await soon(() => view.page.locator(".skin-place .lit").count()).toBeGreaterThan(3);
    const invitation = view.page.getByRole("complementary", { name: "Invitation" });
    expect(await invitation.isVisible()).toBe(false);
    const explorations = [0, 1, 2].map((index) => ({ index, id: index, labels: { object: "boule" } }));
    view.server.change({ demonstrated: 1, live: false, explorations });
    await invitation.getByRole("button", { name: "Train another system" }).waitFor({ state: "hidden" });
    view.server.change({ systems: view.server.state.systems.map((one) => ({ ...one, learns: true })) });
    await invitation.getByRole("button", { name: "Train another system" }).click();
    await view.received({ command: "system", name: "shape_and_size" });
    await view.received({ command: "train" });
    await soon(() => invitation.isVisible()).toBe(false);
  });
});

it("shows the body and the skin of the same frame", async () => {
  await view.open();
  const scene = view.page.locator(".scene[data-drawn]");
  await soon(() => scene.count()).toBe(1);
  await view.page.evaluate(() => {
    const [whole, place] = [document.documentElement, document.querySelector<HTMLElement>(".scene")!];
    const pairs: [string, string][] = [];
    Object.assign(globalThis, { pairs });
    // Called after the frame is drawn and before the browser shows anything of it.
    new MutationObserver(() => {
      pairs.push([whole.dataset["shown"] ?? "", place.dataset["frame"] ?? ""]);
    }).observe(whole, { attributeFilter: ["data-shown"] });
  });
  for (const frame of [10, 11, 45, 46]) {
    view.server.show(1, frame);
    await frameShown(view.page, frame);
  }
  const pairs = await view.page.evaluate(() => (globalThis as unknown as { pairs: [string, string][] }).pairs);
  expect(pairs).toEqual(["1:10", "1:11", "1:45", "1:46"].map((frame) => [frame, frame]));
});

it("goes back through a training with its slider", async () => {
  await view.open();
  view.server.change({ training: true });
  for (const step of [100, 200, 300]) {
    view.server.send("training", fakeTraining(step, 1000));
    await view.page.getByText(`map: step ${step} of 1000`).waitFor();
  }
  const slider = view.page.getByRole("slider", { name: "Moment of the training" });
  await slider.fill("0");
  await view.page.getByText("map: step 100 of 1000").waitFor();
  view.server.send("training", fakeTraining(400, 1000));
  await soon(() => slider.getAttribute("max")).toBe("3");
  expect(await words(view.page, ".training-words")).toContain("step 100 of 1000"); // it stays there
  await slider.fill("3");
  await view.page.getByText("map: step 400 of 1000").waitFor();
});

const scene = () => view.page.locator(".scene");
const drawn = async () => Number(await scene().getAttribute("data-drawn"));

/** After the page's own timer of a resting picture, and what it then draws. */
function rested(): Promise<unknown> {
  return view.page.evaluate(
    () => new Promise((done) => setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(done)), 400)),
  );
}

/** The picture once nothing is drawn any more. */
async function settled(): Promise<Buffer> {
  let before = -1;
  while (before !== (await drawn())) {
    before = await drawn();
    await rested();
  }
  return scene().screenshot();
}

async function openScene(): Promise<void> {
  await view.open();
  view.server.show(1, 50);
  await frameShown(view.page, 50);
  await soon(drawn).toBeGreaterThan(0);
}

it("shows what a transparent hand hides", async () => {
  await openScene();
  const button = view.page.getByRole("button", { name: "See through" });
  const picture = await settled();
  await button.click();
  expect(await button.getAttribute("aria-pressed")).toBe("true");
  await soon(async () => (await settled()).equals(picture)).toBe(false);
  await button.click();
  await soon(async () => (await settled()).equals(picture)).toBe(true);
});

it("turns, moves and zooms the scene by keys, mouse and wheel", async () => {
  await openScene();
  await scene().evaluate((element) => (element.style.outline = "none")); // of the focus
  await scene().focus();
  const press = (key: string) => view.page.keyboard.press(key);
  const same = async (picture: Buffer) => (await settled()).equals(picture);
  await press("0");
  const front = await settled();
  const box = (await scene().boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const drag = async () => {
    await view.page.mouse.down();
    await view.page.mouse.move(x + 60, y + 20, { steps: 4 });
    await view.page.mouse.up();
  };
  const wheel = () => view.page.mouse.wheel(0, 100);
  const moves = [drag, wheel, ...["ArrowUp", "Shift+ArrowRight", "+"].map((key) => () => press(key))];
  const seen = [front];
  for (const move of moves) {
    await view.page.mouse.move(x, y);
    await move();
    await view.page.mouse.move(5, 5); // points at no sensor
    await soon(() => same(front)).toBe(false);
    seen.push(await settled());
    await press("0");
    await soon(() => same(front)).toBe(true);
  }
  expect(new Set(seen.map((picture) => picture.toString("base64"))).size).toBe(1 + moves.length);
  for (let i = 0; i < 48; i += 1) await press("ArrowRight"); // a whole turn
  for (const key of ["Shift+ArrowUp", "Shift+ArrowDown", "-", "+"]) await press(key);
  await soon(() => same(front)).toBe(true);
});

describe("the strips", () => {
  it("name their lines, and show the values of the moment under the pointer", async () => {
    await view.open();
    view.server.show(1, kFrames - 1);
    await frameShown(view.page, kFrames - 1);
    const names = view.page.locator("[data-channel=joints] .strip-name");
    expect(await names.allInnerTexts()).toEqual(
      [1, 2, 3].flatMap((i) => [`finger${i}_proximal`, `finger${i}_distal`]),
    );
    await view.page.waitForSelector("[data-channel=touch][data-whole=true] .u-over");
    const over = view.page.locator("[data-channel=touch] .u-over");
    const box = (await over.boundingBox())!;
    const [frame, taxel] = [40, 20];
    const duration = (kFrames - 1) / kRate;
    const x = box.x + ((frame + 0.3) / kRate / duration) * box.width;
    await view.page.mouse.move(x, box.y + ((taxel + 0.5) / kTaxels.length) * box.height);
    const felt = fakeFrame(1, frame).channels;
    await soon(() => words(view.page, "[data-channel=touch] .strip-values")).toContain(
      `${kTaxels[taxel]}: ${digits(felt["touch"]![taxel]!)} N at 4.0 s`,
    );
    await soon(() => view.page.locator("[data-channel=joints] .strip-value .number").allInnerTexts()).toEqual(
      felt["joints"]!.map(digits),
    );
  });

  it("have no holes after the page was in the background", async () => {
    const state = { ...bodyState(), live: true, exploration: 0, frames: null, duration: null };
    await view.open(state);
    let release = () => {};
    const missed = new Promise<void>((resolve) => (release = resolve));
    let requests = 0;
    // The first answer is from before the frames that the page misses, and arrives after them.
    await view.page.route("**/api/strips*", async (route) => {
      requests += 1;
      const known = requests === 1 ? 5 : kFrames;
      if (requests === 1) await missed;
      await route.fulfill({ json: soFar(known) });
    });
    await soon(() => {
      view.server.send("frame", explored(0, 4));
      return requests;
    }).toBe(1);
    await soon(async () => {
      view.server.send("frame", explored(0, kFrames - 1));
      return (await view.page.locator("[data-channel=touch] canvas").count()) > 0 && (await holes()) > 0;
    }).toBe(true);
    release();
    await soon(holes).toBe(0);

    function soFar(frames: number): Strips {
      const all = Array.from({ length: frames }, (_, i) => explored(0, i));
      const channels = Object.keys(all[0]!.channels);
      return {
        exploration: 0,
        frames: null,
        frame: all.map(({ frame }) => frame),
        time: all.map(({ time }) => time),
        channels: Object.fromEntries(channels.map((name) => [name, all.map((one) => one.channels[name]!)])),
      };
    }

    /** Columns of the bands without a colour, in the middle of the time. */
    function holes(): Promise<number> {
      return view.page.evaluate(() => {
        const strip = document.querySelector("[data-channel=touch]")!;
        const canvas = strip.querySelector("canvas")!;
        const [plot, whole] = [strip.querySelector(".u-over")!, canvas].map((one) => one.getBoundingClientRect());
        const at = (share: number) => plot!.left - whole!.left + share * plot!.width;
        const row = plot!.top - whole!.top + 0.5 * plot!.height;
        const { data } = canvas.getContext("2d")!.getImageData(0, row, canvas.width, 1);
        let empty = 0;
        for (let x = Math.ceil(at(0.05)); x < at(0.9); x += 1) if (data[4 * x + 3] === 0) empty += 1;
        return empty;
      });
    }
  });
});
