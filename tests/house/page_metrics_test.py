import unittest

from support import TREE, TreeTest

import page_metrics

ERROR_ROW = '{"prediction_error", "Prediction error", kFromZero, kLower, false},\n'


class PageMetrics(TreeTest):
    """The page of a tree with the rows of a test."""

    def write_rows(self, text):
        self.write("src/studies/results/metrics.inc", text)
        return page_metrics.page_of(self.tree)

    def problem(self, text):
        with self.assertRaises(page_metrics.RowError) as caught:
            page_metrics.read_rows(text)
        return str(caught.exception)

    def test_a_row_is_an_entry_with_its_words_and_range(self):
        page = self.write_rows("// Rows.\n" + '{"accuracy", "Accuracy", kShare, kHigher, true},\n' + ERROR_ROW)
        self.assertIn('export type MetricRange = "from_zero" | "share";\n', page)
        self.assertIn('  ["accuracy", { words: "Accuracy", range: "share" }],\n'
                      '  ["prediction_error", { words: "Prediction error", range: "from_zero" }],\n]);\n', page)

    def test_every_other_line_is_refused(self):
        for line in ("", "#if 0", ' {"a", "A", kShare, kHigher, true},', '{"a", "A", kShare, kHigher, true}',
                     '{"a", "A\\n", kShare, kHigher, true},', '{"a", "", kShare, kHigher, true},',
                     '{"a", "A", kShare, kHigher, true}, // a comment', '{"a", "A", kShare, kHigher, 1},',
                     '{"a", "A", share, kHigher, true},', '{"a b", "A", kShare, kHigher, true},',
                     '{"a", "A", kShare, kHigher, true}, {"b", "B", kShare, kHigher, true},'):
            self.assertEqual(self.problem(ERROR_ROW + line + "\n" + ERROR_ROW),
                             f"src/studies/results/metrics.inc:2: not a row of a metric: {line}")

    def test_a_second_row_of_a_metric_and_an_empty_table_are_refused(self):
        self.assertEqual(self.problem(ERROR_ROW + ERROR_ROW),
                         "src/studies/results/metrics.inc:2: 'prediction_error' has a row already")
        self.assertEqual(self.problem("// Rows.\n"), "src/studies/results/metrics.inc: no metric")

    def test_a_page_of_other_rows_is_refused(self):
        refused = ["web/src/report/metrics.ts: not made from src/studies/results/metrics.inc; "
                   "run scripts/page_metrics.py"]
        page = self.write_rows(ERROR_ROW)
        self.assertEqual(page_metrics.check(self.tree), refused)  # there is none
        self.write("web/src/report/metrics.ts", page)
        self.assertEqual(page_metrics.check(self.tree), [])
        self.write_rows(ERROR_ROW.replace("kFromZero", "kShare"))
        self.assertEqual(page_metrics.check(self.tree), refused)

    def test_the_page_of_this_checkout_has_every_line_of_its_table(self):
        text = (TREE / page_metrics.ROWS).read_text(encoding="utf-8")
        rows = [line for line in text.splitlines() if line.startswith("{")]
        self.assertEqual(len(page_metrics.read_rows(text)), len(rows))
        self.assertEqual(page_metrics.check(TREE), [])


if __name__ == "__main__":
    unittest.main()
