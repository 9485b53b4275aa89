"""check_site.py finds each kind of broken link, and only those."""

import unittest

from support import TreeTest

import check_site


class CheckSite(TreeTest):
    def problems(self, **pages):
        for name, text in pages.items():
            self.write(f"{name}.html", text)
        self.write("picture.png")
        return check_site.problems_of(self.tree)

    def test_accepts_links_to_pages_anchors_and_files(self):
        self.assertEqual([], self.problems(
            a='<a href="b.html#there">x</a> <a href="#here">x</a> <p id="here"><img src="picture.png">',
            b='<h1 id="there"></h1> <a href="a.html">x</a> <a name="old"></a> <a href="#old">x</a>'))

    def test_finds_a_missing_page(self):
        self.assertEqual(["a.html: 'c.html' does not exist"], self.problems(a='<a href="c.html">x</a>'))

    def test_finds_a_missing_anchor(self):
        self.assertEqual(["a.html: 'b.html#nowhere' has no such anchor"],
                         self.problems(a='<a href="b.html#nowhere">x</a>', b='<h1 id="there"></h1>'))

    def test_finds_a_missing_picture(self):
        self.assertEqual(["a.html: 'lost.png' does not exist"], self.problems(a='<img src="lost.png">'))

    def test_links_to_other_sites_are_complete(self):
        self.assertEqual(["a.html: 'https://example' is not a complete address"], self.problems(
            a='<a href="https://example.org/x#y">x</a> <a href="mailto:a@example.org">x</a> '
              '<a href="https://example">x</a>'))

    def test_nothing_is_loaded_from_elsewhere(self):
        self.assertEqual(
            ["a.html: 'https://example.org/x.js' is loaded from elsewhere",
             "a.html: '//example.org/x.css' is loaded from elsewhere"],
            self.problems(a='<script src="https://example.org/x.js"></script>'
                       '<link rel="stylesheet" href="//example.org/x.css">'
                       '<link rel="canonical" href="https://example.org/a.html">'))


if __name__ == "__main__":
    unittest.main()
