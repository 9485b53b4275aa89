// The computations of the view that need no browser.

import { describe, expect, test } from "vitest";

import { hex, lightness, parsed } from "../../src/parts/maps/colour_maps";
import { kRest, roundNumber, touchColour } from "../../src/parts/hands/touch_colours";
import type { Frame, Strips } from "../../src/view/data";
import { DrawingBudget } from "../../src/view/session/drawing_budget";
import { ForceScale } from "../../src/view/scene/force_scale";
import { strongest } from "../../src/view/strips/strongest";
import { fingerGroups } from "../../src/view/scene/finger_groups";
import { gapsOf } from "../../src/view/strips/gaps";
import { geometryOf } from "../../src/view/scene/geometry";
import { History } from "../../src/view/strips/history";
import { describe as describeLabels } from "../../src/view/page/labels";
import { mostOften } from "../../src/view/systems/most_often";
import { padNormals } from "../../src/view/scene/pad_normals";
import { PoseMotion } from "../../src/view/scene/pose_motion";
import { spectrumAxis } from "../../src/view/strips/spectrum_axis";
import { TrainingPast } from "../../src/view/systems/training_past";
import { truthOf } from "../../src/view/naming/truth";
import { bodyState, fakeFrame, fakeState, fakeTraining, kFrames } from "../view/fake_frames";
import { fakePoses, fakeScene, kTaxels, kThings } from "../view/fake_hand";

function frame(exploration: number, index: number): Frame {
  return fakeFrame(exploration, index);
}

describe("the frames that have been seen", () => {
  test("stand in their order, each once", () => {
    const history = new History();
    for (const index of [3, 1, 2, 3, 0]) history.add(frame(0, index));
    expect(history.times).toEqual([0, 0.1, 0.2, 0.3]);
    expect(history.rows("joints")[2]).toEqual(frame(0, 2).channels["joints"]);
    expect(history.rows("nothing")).toEqual([[], [], [], []]);
  });

  test("are thinned out when a body explores for days", () => {
    const history = new History();
    const one = { ...frame(0, 0), frames: null, channels: { height: [1] } };
    for (let index = 0; index < 10_000; index += 1) history.add({ ...one, frame: index, time: index / 10 });
    const { times } = history;
    expect(times.length).toBeLessThanOrEqual(2000);
    expect(times.length).toBeGreaterThan(900);
    expect([times[0], times.at(-1)]).toEqual([0, 999.9]);
    expect(Math.max(...times.slice(1).map((time, i) => time - times[i]!))).toBeLessThan(2);
  });

  test("are those of one exploration", () => {
    const history = new History();
    history.add(frame(0, 5));
    history.add(frame(1, 7));
    expect(history.times).toEqual([0.7]);
  });
});

describe("the scale of touch", () => {
  test("ends at a round number not below the most that was seen", () => {
    expect([0, 0.03, 1, 1.01, 2, 4.2, 70, 5.000000001].map(roundNumber)).toEqual([
      1, 0.03, 1, 1.5, 2, 5, 80, 5,
    ]);
  });

  test("follows the exploration, unless it is held", () => {
    const scale = new ForceScale();
    scale.see(0, [3, Number.NaN, null, -4.1]);
    expect([scale.end, scale.share(2.5), scale.share(-9), scale.share(Number.NaN)]).toEqual([5, 0.5, 1, 0]);
    scale.see(1, [0.2]);
    expect(scale.end).toBe(0.2);
    scale.held = true;
    scale.see(1, [40]);
    expect(scale.end).toBe(0.2);
  });

  test("is not that of a single sensor among many", () => {
    const scale = new ForceScale();
    scale.see(0, [50, ...Array.from({ length: 19 }, () => 1.9), 0.001]);
    expect(scale.end).toBe(2);
  });

  test("does not show the noise of a force as if it were touch", () => {
    const scale = new ForceScale();
    scale.unit = "N";
    scale.see(0, [0.05]);
    expect(scale.end).toBe(1);
  });
});

test("a missing value is neither a touch nor a rest", () => {
  const scale = new ForceScale();
  scale.see(0, [null, 2]);
  expect([scale.share(null), scale.share(undefined), scale.share(0)]).toEqual([null, null, 0]);
  const moments = [
    [null, 3, 0],
    [null, null, -4],
  ];
  expect([0, 1, 2].map((i) => strongest(moments, i, i + 1))).toEqual([null, 3, 4]);
  expect(strongest([[0]], 0, 1)).toBe(0);
});

describe("the strips over an exploration", () => {
  const strips = (frames: number | null, shown: number[]): Strips => ({
    exploration: 0,
    frames,
    frame: shown,
    time: shown.map((index) => frame(0, index).time),
    channels: { touch: shown.map((index) => frame(0, index).channels["touch"]!) },
  });
  const live = (index: number) => ({ ...frame(0, index), frames: null });

  test("are requested once per exploration", () => {
    const history = new History();
    history.add(frame(0, 5));
    expect(history.isLacking).toBe(true);
    expect(history.take(strips(kFrames, [0, 30, 59]))).toBe(true);
    expect([history.isLacking, history.isWhole]).toEqual([false, true]);
    history.add(frame(0, 6)); // between what is known
    expect(history.times).toEqual([0, 3, 5.9]);
    expect(history.rows("touch")[1]).toEqual(frame(0, 30).channels["touch"]);
    history.add(frame(1, 6));
    expect([history.isLacking, history.isWhole, history.end]).toEqual([true, false, 0.6]);
  });

  test("is not that of another one", () => {
    const history = new History();
    history.add(frame(1, 5));
    expect(history.take(strips(kFrames, [0, 59]))).toBe(false);
    history.add(live(5));
    expect(history.take(strips(kFrames, [0, 59]))).toBe(false);
    expect(history.times).toEqual([0.5]);
  });

  test("continues while a body explores, until it begins anew", () => {
    const history = new History();
    history.add(live(3));
    history.add(live(4));
    history.take(strips(null, [0, 1, 2, 3]));
    history.add(live(5));
    expect(history.times).toEqual([0, 0.1, 0.2, 0.3, 0.4, 0.5]);
    history.add(live(2)); // it was gone back to
    expect(history.times.length).toBe(6);
    history.add({ ...live(4), channels: frame(1, 4).channels });
    expect([history.times, history.isLacking]).toEqual([[0.4], true]);
  });

  test("are requested again when frames were missed", () => {
    const history = new History();
    history.add(live(3));
    history.take(strips(null, [0, 1, 2, 3]));
    history.add(live(13));
    expect(history.isLacking).toBe(false); // a second
    history.add(live(24));
    expect(history.isLacking).toBe(true);
    history.take(strips(null, Array.from({ length: 26 }, (_, i) => i)));
    expect([history.times.length, history.isLacking]).toEqual([26, false]);
  });

  test("makes a gap where there was a jump, for a dropped frame none", () => {
    const seen = (indices: number[]) => {
      const history = new History();
      for (const index of indices) history.add(frame(0, index));
      return history;
    };
    const gaps = (history: History, end: number) => history.times.map((_, i) => gapsOf(history, end)(i));
    expect(gaps(seen([0, 1, 4, 30, 31]), 20)).toEqual([false, false, true, false, false]);
    expect(gaps(seen([0, 30]), 60)).toEqual([false, false]);
    const sparse = seen([0]);
    sparse.take(strips(kFrames, [0, 20, 40, 59])); // nothing lies between
    expect(gaps(sparse, 6)).toEqual([false, false, false, false]);
  });
});

describe("the poses between frames", () => {
  const at = (frame: number, x: number, turn: number[] = [1, 0, 0, 0]) => ({
    exploration: 0,
    frame,
    poses: [x, 0, 0, ...turn],
  });

  test("follow the newest frame within the time between frames", () => {
    const motion = new PoseMotion();
    motion.take(at(0, 0), 1000);
    motion.take(at(1, 1, [-Math.SQRT1_2, -Math.SQRT1_2, 0, 0]), 1100);
    expect(motion.at(1100)[0]).toBe(0);
    const [x, , , w, a] = motion.at(1150) as number[];
    expect(x).toBeCloseTo(0.5);
    expect([w, a]).toEqual([expect.closeTo(Math.cos(Math.PI / 8)), expect.closeTo(Math.sin(Math.PI / 8))]);
    expect([motion.isMoving(1150), motion.isMoving(1200)]).toEqual([true, false]);
    expect(motion.at(1200)[0]).toBe(1);
  });

  test("arrive at once for the eye, as the skin shows the newest frame already", () => {
    const motion = new PoseMotion();
    motion.take(at(0, 0), 1000);
    motion.take(at(1, 1), 1400);
    expect(motion.at(1450)[0]).toBeCloseTo(0.5);
    expect(motion.at(1500)[0]).toBe(1);
    expect(motion.isMoving(1700)).toBe(true); // pictures are still counted
  });

  test("jump with a jump", () => {
    const motion = new PoseMotion();
    motion.take(at(0, 0), 1000);
    motion.take(at(90, 1), 1100);
    expect(motion.at(1100)[0]).toBe(1);
  });
});

test("touch sensors face away from the other parts of their segment", () => {
  const normals = padNormals(fakeScene(kThings[0]!).geoms);
  expect(normals.size).toBe(45);
  for (const normal of normals.values()) expect(normal).toEqual([-1, 0, 0]);
});

test("sensors that touch nothing are grey, others bright", () => {
  expect([0, 0.03].map(touchColour)).toEqual([hex(kRest), hex(kRest)]);
  const [weak, strong] = [0.05, 1].map((share) => lightness(parsed(touchColour(share))));
  expect(strong!).toBeGreaterThan(weak! + 25);
});

test("rows of sensors are grouped by finger", () => {
  expect(fingerGroups(kTaxels).map(({ name, first, count }) => [name, first, count])).toEqual([
    ["finger1", 0, 15],
    ["finger2", 15, 15],
    ["finger3", 30, 15],
  ]);
  expect(fingerGroups(["1", "2"])).toEqual([]);
});

test("the truth is the label of the exploration, or that of the thing that is explored", () => {
  expect(truthOf(fakeState(), 1)).toBe("boccia cylinder");
  const live = { ...bodyState(), live: true };
  expect([truthOf(live, 0), truthOf({ ...live, label: "material" }, 0)]).toEqual(["boccia boule", "wood"]);
  expect(truthOf({ ...live, label: null }, 0)).toBe(null);
});

test("a spectrum has the frequencies of its channel's rate", () => {
  const state = fakeState();
  const [joints, code] = state.graph!.modules;
  const spectrum = { ...code!, type: "spectrum", shape: [1, 2049], parameters: { bands: "0", low: "0.0", high: '"automatic"' } };
  state.graph!.modules = [joints!, spectrum];
  state.rates = { joints: 8192 };
  expect(spectrumAxis(spectrum, state)).toEqual({ low: 0, high: 4096, unit: "Hz" });
  expect(spectrumAxis(joints!, state)).toBe(null);
});

test("a training can be gone back through", () => {
  const past = new TrainingPast();
  for (const step of [10, 20, 30]) past.take(fakeTraining(step, 30));
  past.goTo(1);
  past.take(fakeTraining(30, 30)); // sent again
  expect([past.count, past.shown?.step, past.isFollowing]).toEqual([3, 20, false]);
  past.goTo(2);
  expect([past.shown?.step, past.isFollowing]).toEqual([30, true]);
  past.take(fakeTraining(10, 30)); // another training
  expect(past.count).toBe(1);
});

test("a neuron's class is the one that it won most of", () => {
  const won = (winner: number, name: string) => ({ sample: 0, winner, class: name });
  const winners = [won(1, "ball"), won(1, "cup"), won(1, "cup"), won(3, "ball")];
  expect(mostOften(winners, ["ball", "cup"], 4)).toEqual([null, 1, null, 0]);
});

test("an exploration is called by its object and trial", () => {
  expect(describeLabels({ object: "cup", trial: "2", shape: "round" })).toBe("cup, trial 2");
  expect(describeLabels({ material: "cork" })).toBe("cork");
  expect(describeLabels({ hardness: "soft", material: "cork", trial: "1" }, "material")).toBe("cork, trial 1");
  expect(describeLabels({})).toBe("");
});

test("shapes are as large as MuJoCo says", () => {
  const scene = fakeScene(kThings[1]!);
  for (const geom of scene.geoms) {
    const geometry = geometryOf(geom);
    geometry.computeBoundingBox();
    const { x, y, z } = geometry.boundingBox!.max;
    const [a, b, c] = geom.size;
    const expected = { box: [a, b, c], sphere: [a, a, a], cylinder: [a, a, b] }[
      geom.type as "box" | "sphere" | "cylinder"
    ];
    [x, y, z].forEach((size, i) => expect(size, geom.name).toBeCloseTo(expected[i]!, 4));
  }
});

test("a mesh of few faces has flat ones", () => {
  const corner = {
    vertices: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1],
    faces: [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3],
  };
  const geometry = geometryOf({ ...fakeScene(kThings[0]!).geoms[0]!, type: "mesh", ...corner });
  expect(geometry.getAttribute("position").count).toBe(12);
  expect([0, 1, 2].map((i) => geometry.getAttribute("normal").getZ(i))).toEqual([-1, -1, -1]);
});

// The tests' own hand: straight fingers hang two segments below their pivots.
test("the made-up hand hangs together", () => {
  const poses = fakePoses(0.2, 0, [0, 0, 0, 0, 0, 0]);
  const at = (body: number) => poses.slice(body * 7, body * 7 + 3);
  [0.065, 0, 0.2].forEach((value, i) => expect(at(2)[i]).toBeCloseTo(value));
  [0.065, 0, 0.14].forEach((value, i) => expect(at(3)[i]).toBeCloseTo(value));
  expect(at(8)).toEqual([0, 0, 0]);
});

describe("the budget of drawing", () => {
  /** Pictures every so many ms for a time. */
  function pictures(budget: DrawingBudget, from: number, every: number, during: number): number {
    let now = from;
    for (; now < from + during; now += every) budget.follow(now);
    return now;
  }

  test("does not change in a fast browser", () => {
    const budget = new DrawingBudget();
    pictures(budget, 0, 16, 5000);
    expect(budget.resolution).toBe(1);
    expect(budget.pause).toBeLessThan(35);
  });

  test("is lowered until pictures are drawn often enough, and raised again", () => {
    const budget = new DrawingBudget();
    let now = pictures(budget, 0, 100, 1200); // ten per second
    expect(budget.pause).toBeGreaterThan(90);
    now = pictures(budget, now, 28, 4000); // 36 per second
    const [pause, resolution] = [budget.pause, budget.resolution];
    now = pictures(budget, now, 28, 4000);
    expect([budget.pause, budget.resolution]).toEqual([pause, resolution]);
    pictures(budget, now, 16, 10_000);
    expect([budget.pause, budget.resolution]).toEqual([30, 1]);
  });

  test("knows for how long a picture is seen", () => {
    const budget = new DrawingBudget();
    expect(budget.interval).toBeNull();
    pictures(budget, 0, 125, 1200);
    expect(budget.interval).toBe(125);
  });

  test("does not take a rest for slow drawing", () => {
    const budget = new DrawingBudget();
    for (let i = 0; i < 20; i += 1) {
      pictures(budget, 2000 * i, 16, 200);
      budget.rest();
    }
    expect(budget.pause).toBeLessThan(35);
  });

  test("counts pictures that come in bunches", () => {
    const budget = new DrawingBudget();
    let now = 0;
    for (let i = 0; i < 10; i += 1) now = pictures(budget, now, 6, 36) + 350; // bunches: 16 per second
    expect(budget.pause).toBeGreaterThan(90);
  });
});
