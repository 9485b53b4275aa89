import { describe, expect, test } from "vitest";

import type { ChannelData, ModuleData } from "../../src/parts/data";
import { graphLayout } from "../../src/parts/graph_layout";
import { gridLayout, hasGrid } from "../../src/parts/hands/grid_layout";
import { handLayout, rowSizes } from "../../src/parts/hands/hand_layout";
import { groupsOf, isSkin, skinLayout } from "../../src/parts/hands/skin_layout";
import { nearestTowards } from "../../src/parts/hands/towards";
import { hull } from "../../src/parts/hands/thing_picture";
import { reportFixture } from "../report/report_fixture";
import { randomNumbers } from "../report/report_runs";
import { touchElements } from "../report/report_things";

function module(name: string, inputs: string[], type = "code"): ModuleData {
  const ports = inputs.map((one, i) => ({ port: String(i), module: one }));
  return {
    name,
    type,
    text: "",
    inputs: ports,
    shape: [],
    sparse: false,
    rate: "frame",
    learns: false,
    parameters: {},
    not_given: [],
  };
}

function overlaps(modules: ModuleData[]): string[] {
  const { layers, rows } = graphLayout(modules);
  return modules.flatMap((one, i) =>
    modules
      .slice(0, i)
      .flatMap((other, j) =>
        layers[i] === layers[j] && Math.abs(rows[i]! - rows[j]!) < 0.999
          ? [`${one.name} on ${other.name}`]
          : [],
      ),
  );
}

describe("the layout of a graph", () => {
  test("goes from left to right without overlaps", () => {
    const { modules } = reportFixture().systems[0]!.graph!;
    const { layers, links } = graphLayout(modules);
    for (const link of links) if (!link.isBack) expect(layers[link.to]!).toBeGreaterThan(layers[link.from]!);
    expect(overlaps(modules)).toEqual([]);
  });

  test("draws backwards what enters a delay, and nothing else", () => {
    const loop = [
      module("a", []),
      module("sum", ["a", "late"]),
      module("late", ["sum"], "delay"),
      module("map", ["sum"]),
    ];
    const back = graphLayout(loop).links.filter((link) => link.isBack);
    expect(back.map((link) => [loop[link.from]!.name, loop[link.to]!.name])).toEqual([["sum", "late"]]);
  });

  test("ends on loops without a delay, on itself and on inputs that are not there", () => {
    const odd = [module("a", ["b"]), module("b", ["a"]), module("c", ["c", "absent"])];
    expect(graphLayout(odd).links.filter((link) => link.isBack).length).toBe(2);
    expect(graphLayout([]).rowCount).toBe(1);
  });

  test("has no overlaps in random graphs", () => {
    const random = randomNumbers(5);
    for (let round = 0; round < 60; round += 1) {
      const modules = Array.from({ length: 2 + Math.floor(random() * 25) }, (_, i) =>
        module(
          `m${i}`,
          Array.from(
            { length: i === 0 ? 0 : Math.floor(random() * 4) },
            () => `m${Math.floor(random() * i)}`,
          ),
        ),
      );
      expect(overlaps(modules)).toEqual([]);
      for (const row of graphLayout(modules).rows) expect(row).toBeGreaterThanOrEqual(0);
    }
  });
});

describe("the layout of a hand", () => {
  test("has rows as the hands' models have", () => {
    expect(rowSizes(7, "proximal")).toEqual([2, 3, 2]);
    expect(rowSizes(8, "distal")).toEqual([3, 2, 3]);
    expect(rowSizes(3, "distal")).toEqual([2, 1]);
    expect(rowSizes(3, "proximal")).toEqual([1, 1, 1]);
    expect(rowSizes(20, "proximal").reduce((sum, size) => sum + size, 0)).toBe(20);
  });

  test("sets fingers side by side, distal above proximal, low numbers next to the palm", () => {
    const names = touchElements();
    const layout = handLayout(names)!;
    const at = (name: string) => layout.dots[names.indexOf(name)]!;
    expect(layout.fingers.map((finger) => finger.name)).toEqual(["finger1", "finger2", "finger3"]);
    expect(at("finger1_distal_8").y).toBeLessThan(at("finger1_distal_1").y);
    expect(at("finger1_distal_1").y).toBeLessThan(at("finger1_proximal_7").y);
    expect(at("finger2_proximal_1").x).toBeGreaterThan(at("finger1_proximal_1").x);
  });

  test.each([
    ["Hand II", touchElements()],
    [
      "Hand III",
      ["thumb", "index", "middle", "ring", "little"].flatMap((finger) =>
        [
          ["proximal", finger === "thumb" ? 2 : 3],
          ["middle", finger === "thumb" ? 0 : 2],
          ["distal", 3],
        ].flatMap(([segment, count]) =>
          Array.from({ length: Number(count) }, (_, i) => `${finger}_${segment}_${i + 1}`),
        ),
      ),
    ],
  ])("has no two elements of %s on each other, and all on a segment", (_, names) => {
    const layout = handLayout(names)!;
    layout.dots.forEach((dot, i) => {
      const within = layout.segments.filter(
        ({ x, y, width, height }) => dot.x > x && dot.x < x + width && dot.y > y && dot.y < y + height,
      );
      expect(within.length).toBe(1);
      for (const other of layout.dots.slice(0, i))
        expect(Math.hypot(dot.x - other.x, dot.y - other.y)).toBeGreaterThan(0.95);
    });
  });

  test("is a grid where names do not describe a hand", () => {
    expect(handLayout(["height", "wrist"])).toBeNull();
    expect(handLayout([])).toBeNull();
    expect(gridLayout(numbered(6), [2, 3])).toMatchObject({ width: 3, height: 2 });
    expect(gridLayout([], []).dots).toEqual([]);
  });

  test("is walked by arrow keys from end to end", () => {
    const layout = handLayout(touchElements())!;
    const seen = new Set([0]);
    for (const at of seen)
      for (const [dx, dy] of [
        [1, 0],
        [-1, 0],
        [0, 1],
        [0, -1],
      ])
        seen.add(nearestTowards(layout.dots, at, dx!, dy!));
    expect(seen.size).toBe(45);
  });
});

test("a hull goes around all points and through corners only", () => {
  const square = [
    [0, 0],
    [2, 0],
    [2, 2],
    [0, 2],
    [1, 1],
    [1, 0],
  ] as [number, number][];
  expect(hull(square).length).toBe(4);
});

const numbered = (count: number) => Array.from({ length: count }, (_, i) => String(i + 1));

const indexed = (rows: number, columns: number, name: (row: number, column: number) => string) =>
  Array.from({ length: rows * columns }, (_, i) => name(Math.floor(i / columns), i % columns));

const sizeOf = ({ width, height }: { width: number; height: number }) => [width, height];

describe("the grid of a pad", () => {
  test("has no hole, and the shape of its channel first", () => {
    expect([16, 12, 8, 7, 17, 1].map((count) => sizeOf(gridLayout(numbered(count), [count])))).toEqual([
      [4, 4],
      [4, 3],
      [4, 2],
      [7, 1],
      [17, 1],
      [1, 1],
    ]);
    expect(sizeOf(gridLayout(numbered(16), [2, 8]))).toEqual([8, 2]);
    expect(sizeOf(gridLayout(numbered(16), [1, 2, 8, 1]))).toEqual([8, 2]);
    expect(sizeOf(gridLayout(numbered(997), [997]))).toEqual([45, 23]); // 997 in a row are too small to see
  });

  test.each([
    ["digits", indexed(2, 3, (row, column) => `t${row}${column}`)],
    ["numbers", indexed(2, 3, (row, column) => `taxel_${row}_${column}`)],
    ["letters", indexed(2, 3, (row, column) => `r${row + 1}c${column + 1}`)],
    ["a name that has a number itself", indexed(2, 3, (row, column) => `skin1_t${row}${column}`)],
  ])("follows two indices of names: %s", (_, names) => {
    const layout = gridLayout(names, [6]);
    expect(sizeOf(layout)).toEqual([3, 2]);
    expect(layout.dots[4]).toEqual({ x: 1.5, y: 1.5 });
    expect(hasGrid(names, [6])).toBe(true);
    const reversed = gridLayout([...names].reverse(), [6]);
    expect(reversed.dots[1]).toEqual(layout.dots[4]); // by the name, not by the order
  });

  test("with ten and more columns follows the numbers", () => {
    const names = indexed(16, 16, (row, column) => `taxel_${row}_${column}`);
    expect(sizeOf(gridLayout(names, [256]))).toEqual([16, 16]);
    expect(gridLayout(names, [256]).dots[10 * 16 + 11]).toEqual({ x: 11.5, y: 10.5 });
  });

  test("does not follow names that leave a hole, repeat a cell or differ otherwise", () => {
    const names = indexed(3, 3, (row, column) => `t${row}${column}`);
    expect(hasGrid(names.slice(1), [8])).toBe(false);
    expect(hasGrid([...names.slice(1), "t22"], [9])).toBe(false);
    expect(hasGrid([...names.slice(1), "s00"], [9])).toBe(false);
    expect(hasGrid(numbered(9), [9])).toBe(false);
  });
});

describe("the places of a layout file", () => {
  const channel: ChannelData = {
    name: "touch",
    unit: "",
    elements: ["a", "b", "c"],
    shape: [3],
    layout: {
      spacing: 2,
      places: [
        [10, 4],
        [12, 4],
        [10, 8],
      ],
      groups: [{ name: "top", elements: [0, 1] }],
      background: { image: "data:image/png;base64,", x: 8, y: 4, width: 4, height: 8 },
    },
  };

  test("are in distances between neighbours from the corner of picture and elements", () => {
    const layout = skinLayout(channel);
    expect(layout.kind).toBe("placed");
    expect(layout.dots.map(({ x, y }) => [x - layout.dots[0]!.x, y - layout.dots[0]!.y])).toEqual([
      [0, 0],
      [1, 0],
      [0, 2],
    ]);
    expect(layout.dots[0]).toEqual({ x: 1.75, y: 0.75 });
    expect(layout.width).toBeCloseTo(2 + 2 * 0.75);
    expect(layout.background).toMatchObject({ x: 0.75, y: 0.75, width: 2, height: 4 });
  });

  test("have groups with a box around their elements and their name below it", () => {
    const layout = skinLayout(channel);
    expect(layout.segments).toEqual([{ name: "top", x: 1, y: 0, width: 1 + 2 * 0.75, height: 2 * 0.75 }]);
    expect(layout.fingers).toEqual([{ name: "top", x: 1.75 + 0.5, y: 2 * 0.75 }]);
    expect([0, 2].map((one) => groupsOf(channel, one))).toEqual([["top"], []]);
  });

  test("are left out if they are of other elements", () => {
    expect(skinLayout({ ...channel, elements: ["a", "b"], shape: [2] }).kind).toBe("grid");
  });

  test("make a skin of any channel, as shapes, names and touch do", () => {
    const plain = { name: "joints", unit: "deg", elements: ["a", "b", "c"], shape: [3] };
    expect(isSkin(plain)).toBe(false);
    expect(isSkin({ ...channel, name: "joints" })).toBe(true);
    expect(isSkin({ ...plain, name: "touch_left" })).toBe(true);
    expect(isSkin({ ...plain, elements: numbered(4), shape: [2, 2] })).toBe(true);
  });
});
