#!/usr/bin/env python3
"""Writes points of the plane like those with which A-SOMs were published, as CSV files.

    make_a_som_points.py FOLDER [SETS]

writes, for each set of ten points drawn evenly in the unit square, a folder each of

    FOLDER/points_SET/point_N.csv       a new point, then point N: the new one is drawn evenly among
                                        those that are nearer to point N than to the other nine
    FOLDER/sequence_SET/start_N.csv     the ten points in turn, beginning with point N, three times
    FOLDER/ceased_SET/start_N.csv       the same once, then 42 times the silence of all inputs

A row is a frame: x, y, a constant (so that a map that compares directions sees where a point is),
and the number of the point, also in silence. The published sets are not known.

Only +, -, * and / and Python's `random.Random(seed).random()` are used, so the bytes are the same
on every machine.
"""

import pathlib
import random
import sys

POINTS = 10
ROUNDS = 3  # of the sequence while it is learned; not given in the paper
SILENT_ROUNDS = 42
HEADER = "x,y,constant,number"


def drawn(source):
    return (source.random(), source.random())


def nearest(point, points):
    def squared_distance(number):
        return (points[number][0] - point[0]) ** 2 + (points[number][1] - point[1]) ** 2

    return min(range(len(points)), key=squared_distance)


def new_point(number, points, source):
    while True:
        point = drawn(source)
        if nearest(point, points) == number:
            return point


def row(point, number):
    return f"{point[0]:.6f},{point[1]:.6f},1,{number}"


def silence(number):
    return f"0,0,0,{number}"


def write(path, rows):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join([HEADER, *rows]) + "\n", encoding="utf-8")


def write_set(folder, number):
    source = random.Random(number)
    points = [drawn(source) for _ in range(POINTS)]
    for n, point in enumerate(points):
        fresh = new_point(n, points, source)
        write(folder / f"points_{number}" / f"point_{n + 1}.csv", [row(fresh, n), row(point, n)])
        turn = [(n + step) % POINTS for step in range(POINTS)]
        seen = [row(points[k], k) for k in turn]
        silent = [silence(k) for k in turn]
        write(folder / f"sequence_{number}" / f"start_{n + 1}.csv", seen * ROUNDS)
        write(folder / f"ceased_{number}" / f"start_{n + 1}.csv", seen + silent * SILENT_ROUNDS)


def main():
    folder = pathlib.Path(sys.argv[1])
    for number in range(1, int(sys.argv[2]) + 1 if len(sys.argv) > 2 else 7):
        write_set(folder, number)


if __name__ == "__main__":
    main()
