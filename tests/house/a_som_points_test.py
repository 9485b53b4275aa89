import unittest
from pathlib import Path

from support import TreeTest

import make_a_som_points


def rows(path):
    lines = path.read_text(encoding="utf-8").splitlines()
    assert lines[0] == "x,y,constant,number"
    return [tuple(float(value) for value in line.split(",")) for line in lines[1:]]


def distance(a, b):
    return (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2


class Points(TreeTest):
    def setUp(self):
        super().setUp()
        make_a_som_points.write_set(Path(self.tree), 3)

    def test_new_points_are_nearest_to_their_own(self):
        pairs = [rows(Path(self.tree) / "points_3" / f"point_{n + 1}.csv") for n in range(10)]
        for n, (new, learned) in enumerate(pairs):
            self.assertEqual((new[3], learned[3]), (n, n))
            self.assertNotEqual(new, learned)
            for other in range(10):
                self.assertLessEqual(distance(new, learned), distance(new, pairs[other][1]))

    def test_sequences_begin_anywhere_and_cease(self):
        learned = rows(Path(self.tree) / "sequence_3" / "start_4.csv")
        ceased = rows(Path(self.tree) / "ceased_3" / "start_4.csv")
        self.assertEqual([row[3] for row in learned], [(3 + k) % 10 for k in range(30)])
        self.assertEqual(len(ceased), 10 + 420)
        self.assertEqual(ceased[:10], learned[:10])
        for step, row in enumerate(ceased[10:]):
            self.assertEqual(row, (0, 0, 0, (3 + step) % 10))

    def test_sets_differ_and_are_made_again(self):
        first = (Path(self.tree) / "points_3" / "point_1.csv").read_bytes()
        make_a_som_points.write_set(Path(self.tree), 4)
        self.assertNotEqual((Path(self.tree) / "points_4" / "point_1.csv").read_bytes(), first)
        make_a_som_points.write_set(Path(self.tree), 3)
        self.assertEqual((Path(self.tree) / "points_3" / "point_1.csv").read_bytes(), first)


if __name__ == "__main__":
    unittest.main()
