"""Tests of scripts/header_pages.py."""

import unittest

from support import TreeTest

import header_pages

HEADER = """#pragma once

namespace somato {

namespace detail {

/// Not for users.
int hidden();

}  // namespace detail

/// A step of learning. It has two settings.
struct LearningStep {
  /// Not outside.
  double rate = 0.0;
};

/// Learns one sample at a time, e.g. from a stream: its weights follow.
///
/// Errors: none.
class SomLearner final : public Learner {
 public:
  explicit SomLearner(int threads);
};

/// The most | least steps.
inline constexpr int kMost = 3;

/// A list of steps
using Steps = std::vector<LearningStep>;

/// Whether two are equal. True for none.
template <typename Number>
bool are_equal(std::span<const Number> a,
               std::span<const Number> b);

/// The sum.
double operator+(const Steps& a, const Steps& b);

}  // namespace somato
"""


class HeaderPages(TreeTest):
    """A folder of public headers, and its page."""

    def setUp(self):
        super().setUp()
        self.write("include/somato/maps/som_learner.h", HEADER)
        self.folder = self.tree / "include/somato/maps"

    def test_names_and_first_sentences(self):
        self.assertEqual(list(header_pages.documented(HEADER)), [
            ("LearningStep", "A step of learning."),
            ("SomLearner", "Learns one sample at a time, e.g. from a stream: its weights follow."),
            ("kMost", "The most \\| least steps."),
            ("Steps", "A list of steps"),
            ("are_equal()", "Whether two are equal."),
            ("operator+()", "The sum."),
        ])

    def test_a_header_is_described_by_what_it_is_named_after(self):
        self.assertEqual(header_pages.row(self.folder / "som_learner.h"),
                         "| [som_learner.h](../../../include/somato/maps/som_learner.h) "
                         "| Learns one sample at a time, e.g. from a stream: its weights follow. "
                         "| `LearningStep`, `SomLearner`, `kMost`, `Steps`, `are_equal()`, `operator+()` |\n")

    def test_the_table_replaces_the_one_before(self):
        self.write("maps.md", "# Maps\n\nWords.\n")
        page = self.tree / "maps.md"
        once = header_pages.page_with_headers(page, self.folder)
        self.assertTrue(once.startswith("# Maps\n\nWords.\n\n| header |"))
        page.write_text(once)
        self.assertEqual(header_pages.page_with_headers(page, self.folder), once)


if __name__ == "__main__":
    unittest.main()
