import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

import guard
import guard_arm64
import limits
import report


class Guard(unittest.TestCase):
    def problems(self, counted, known):
        return list(guard.compare("avx2", counted, known))

    def test_passes_as_many_and_a_little_more(self):
        self.assertEqual(self.problems({"a": 1020}, {"a": 1000}), [])

    def test_refuses_more_than_that(self):
        self.assertEqual(self.problems({"a": 1021}, {"a": 1000}), [
            "avx2 a: 1021 instructions, 1000 before (+2.1 %)"])

    def test_refuses_names_that_only_one_side_knows(self):
        self.assertEqual(len(self.problems({"a": 1}, {"b": 1})), 2)

    def test_reads_what_callgrind_writes(self):
        text = "part: 1\ndesc: Trigger: Client Request: float.product\n\nevents: Ir\nsummary: 4711\n"
        match = guard.PART.search(text)
        self.assertEqual((match["name"], match["count"]), ("float.product", "4711"))


class GuardOfArm64(unittest.TestCase):
    PROMISED = ("float.inner_products", "double.inner_products")

    def setUp(self):
        self.promised = guard_arm64.PROMISED
        guard_arm64.PROMISED = {"single": {self.PROMISED[0]}, "double": {self.PROMISED[1]}}

    def tearDown(self):
        guard_arm64.PROMISED = self.promised

    def problems(self, scalar, neon):
        table = list(guard_arm64.rows(scalar, scalar, neon))
        return list(guard_arm64.problems(table, scalar, neon))

    def counts(self, single, double, digest="a"):
        return dict(zip(self.PROMISED, ((digest, single), (digest, double))))

    def test_passes_a_third_and_five_eighths(self):
        self.assertEqual(self.problems(self.counts(300, 160), self.counts(100, 100)), [])

    def test_refuses_more(self):
        self.assertEqual(self.problems(self.counts(299, 159), self.counts(100, 100)), [
            "float.inner_products: 2.99 times fewer, 3.0 are promised",
            "double.inner_products: 1.59 times fewer, 1.6 are promised"])

    def test_refuses_other_bits(self):
        self.assertEqual(self.problems(self.counts(300, 160), self.counts(100, 100, "b")), [
            "float.inner_products: other bits", "double.inner_products: other bits"])

    def test_refuses_a_kernel_that_is_not_counted(self):
        scalar, neon = self.counts(300, 160), self.counts(100, 100)
        for counts in (scalar, neon):
            del counts["double.inner_products"]
        self.assertEqual(self.problems(scalar, neon), ["double.inner_products: not counted"])


class Limits(unittest.TestCase):
    machine = {"flops": 1e9, "read": 1e9, "change": 2e9, "write": 4e9}

    def test_a_sample_at_a_time_takes_six_operations_a_weight(self):
        case = {"neurons": 10, "features": 100, "steps": 1000, "sparse": False}
        self.assertAlmostEqual(limits.limit("few_samples_streaming", case, self.machine), 6e-3)

    def test_a_sparse_one_reads_and_writes_the_weights_it_has(self):
        case = {"neurons": 10, "features": 1000, "steps": 100, "sparse": True}
        self.assertAlmostEqual(limits.limit("sparse_streaming", case, self.machine), 40e-6)

    def test_batch_training_takes_a_product_an_epoch(self):
        case = {"product_seconds": 0.5, "counted_steps": 10}
        self.assertEqual(limits.limit("dense_batch", case, self.machine), 5.0)

    def test_knows_none_without_a_product_or_a_rule(self):
        self.assertIsNone(limits.limit("dense_batch", {}, self.machine))
        self.assertIsNone(limits.limit("tensor_chain", {}, self.machine))


class Report(unittest.TestCase):
    def test_says_how_often_when_it_is_less_than_five_times(self):
        self.assertEqual(report.time_text({"seconds": 21.0, "times": [21.0] * 3}), "21 s (3 runs)")
        self.assertEqual(report.time_text({"seconds": 0.0012, "times": [1] * 5}), "1.2 ms")

    def test_marks_what_is_extrapolated_and_what_is_left_out(self):
        self.assertEqual(report.time_text({"seconds": 9.0, "times": [9] * 5, "estimated": True}),
                         "9 s est")
        self.assertEqual(report.time_text({"left_out": "no compiler"}), "left out: no compiler")

    def test_share_is_the_limit_by_the_time(self):
        self.assertEqual(report.share_text({"seconds": 2.0, "limit": 1.5}), "75 %")
        self.assertEqual(report.share_text({"seconds": 2.0, "limit": None}), "–")


if __name__ == "__main__":
    unittest.main()
