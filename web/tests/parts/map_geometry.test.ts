import { describe, expect, test } from "vitest";

import { areasOf } from "../../src/parts/maps/areas";
import type { GridData } from "../../src/parts/data";
import {
  borders,
  centreOf,
  heightOf,
  neuronAtPixel,
  neuronCount,
  pixelColumns,
  squaredDistance,
  stepFrom,
  widthOf,
} from "../../src/parts/maps/grid";

const grids: GridData[] = (["rectangular", "hexagonal"] as const).flatMap((lattice) =>
  (["plane", "torus"] as const).map((topology) => ({ rows: 4, columns: 5, lattice, topology })),
);

describe.each(grids)("a map: $lattice, $topology", (grid) => {
  test("has its neurons inside its picture, none nearer than 1 to another", () => {
    for (let i = 0; i < neuronCount(grid); i += 1) {
      const [x, y] = centreOf(grid, i);
      expect(x).toBeGreaterThan(0.49);
      expect(x).toBeLessThan(widthOf(grid) - 0.49);
      expect(y).toBeGreaterThan(0.49);
      expect(y).toBeLessThan(heightOf(grid) - 0.49);
      for (let j = 0; j < i; j += 1) expect(squaredDistance(grid, i, j)).toBeGreaterThan(0.999);
    }
  });

  test("has as many neighbours as its lattice says", () => {
    const neighbours = (i: number) =>
      Array.from({ length: 20 }, (_, j) => j).filter((j) => j !== i && squaredDistance(grid, i, j) < 1.001);
    const most = grid.lattice === "hexagonal" ? 6 : 4;
    expect(neighbours(7).length).toBe(most);
    if (grid.topology === "torus") for (let i = 0; i < 20; i += 1) expect(neighbours(i).length).toBe(most);
    else expect(neighbours(0).length).toBe(2);
  });

  test("has one border around everything when there is one area", () => {
    const { between, outside } = borders(grid, new Array<number>(20).fill(0));
    expect(between).toEqual([]);
    // Around 4 x 5 squares: 18 sides; hexagons: 2 of each in the outer rows and sides besides.
    expect(outside.length).toBe(grid.lattice === "rectangular" ? 18 : 34);
  });

  test("is left by arrow keys only on a torus", () => {
    expect(stepFrom(grid, 0, -1, 0)).toBe(grid.topology === "torus" ? 15 : 0);
    expect(stepFrom(grid, 4, 0, 1)).toBe(grid.topology === "torus" ? 0 : 4);
    expect(stepFrom(grid, 7, 1, 1)).toBe(13);
  });
});

describe("areas", () => {
  const line: GridData = { rows: 1, columns: 5, lattice: "rectangular", topology: "plane" };

  test("are what is nearest; in between the class with more samples, then the first", () => {
    expect(areasOf(line, [0, 4], [0, 1])).toEqual([0, 0, 0, 1, 1]);
    expect(areasOf(line, [0, 4, 4], [0, 1, 1])).toEqual([0, 0, 1, 1, 1]);
    expect(areasOf(line, [4, 0], [1, 0])).toEqual([0, 0, 0, 1, 1]);
  });

  test("go over the edge of a torus", () => {
    expect(areasOf({ ...line, topology: "torus" }, [0, 2], [0, 1])).toEqual([0, 0, 1, 1, 0]);
  });

  test("are none without samples", () => {
    expect(areasOf(line, [], [])).toEqual([null, null, null, null, null]);
  });
});

test("each neuron has two pixels side by side, in odd rows of a hexagonal map shifted by one", () => {
  const rowsOf = (lattice: GridData["lattice"], rows: number) => {
    const grid: GridData = { rows, columns: 2, lattice, topology: "plane" };
    return Array.from({ length: rows }, (_, row) =>
      Array.from({ length: pixelColumns(grid) }, (_, x) => neuronAtPixel(grid, x, row)),
    );
  };
  expect(rowsOf("rectangular", 2)).toEqual([
    [0, 0, 1, 1],
    [2, 2, 3, 3],
  ]);
  expect(rowsOf("hexagonal", 2)).toEqual([
    [0, 0, 1, 1, null],
    [null, 2, 2, 3, 3],
  ]);
  expect(rowsOf("hexagonal", 1)).toEqual([[0, 0, 1, 1]]);
});
