import contextlib
import io
import sys
import time
import unittest
from pathlib import Path

from support import TreeTest

import run_doc_blocks


def fenced(kind, text):
    return f"```{kind}\n{text}```\n"


def is_running(process):
    """Whether the process exists and has not ended; the system may keep it as a zombie."""
    for _ in range(500):
        try:
            status = Path(f"/proc/{process}/stat").read_text(encoding="utf-8")
        except FileNotFoundError:
            return False
        if status.rpartition(")")[2].split()[0] == "Z":
            return False
        time.sleep(0.01)
    return True


class DocBlocks(TreeTest):
    def run_document(self, text, *options):
        """(exit code, what was printed) for a tree whose README holds `text`."""
        self.write("source/README.md", text)
        self.write("source/examples/data.csv", "1,2\n")
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            code = run_doc_blocks.main(["--source", str(self.tree / "source"),
                                        "--scratch", str(self.tree / "scratch"), *options])
        return code, printed.getvalue()

    def assert_passes(self, text, *options):
        code, printed = self.run_document(text, *options)
        self.assertEqual(code, 0, printed)
        return printed

    def assert_fails(self, text, words):
        code, printed = self.run_document(text)
        self.assertEqual(code, 1, printed)
        self.assertIn(words, printed)

    def test_runs_blocks_in_order_in_one_folder(self):
        text = fenced("sh", "cat examples/data.csv > copy.csv\n") + fenced("bash", "grep 1,2 copy.csv\n")
        self.assertRegex(self.assert_passes("# Title\n" + text), r"(?m)^ok +[0-9.]+ s  README.md:5$")

    def test_compares_pictures_with_what_is_made(self):
        self.write("source/map.svg", "<svg/>\n")
        made = "<!-- test: made new.svg -->\n![a map](map.svg)\n"
        self.assert_passes(fenced("sh", "echo '<svg/>' > new.svg\n") + made)
        self.assert_fails(fenced("sh", "echo '<svg></svg>' > new.svg\n") + made, "map.svg differs from")
        self.assert_fails(fenced("sh", "true\n") + made, "map.svg differs from")

    def test_runs_one_document_or_all_others(self):
        self.write("source/docs/slow.md", fenced("sh", "true\n"))
        readme = fenced("sh", "true\n")
        printed = self.assert_passes(readme, "--only", "docs/slow.md")
        self.assertIn("docs/slow.md:1", printed)
        self.assertNotIn("README.md", printed)
        printed = self.assert_passes(readme, "--without", "docs/slow.md")
        self.assertIn("README.md:1", printed)
        self.assertNotIn("docs/slow.md", printed)
        with self.assertRaises(SystemExit):
            self.run_document(readme, "--only", "docs/slaw.md")

    def test_every_document_is_in_one_share(self):
        names = [f"docs/{name}.md" for name in "abcd"]
        for number, name in enumerate(names):
            self.write(f"source/{name}", number * fenced("sh", "true\n"))
        shares = [self.assert_passes(fenced("sh", "true\n"), "--share", f"{number}/2") for number in (1, 2)]
        for name in [*names[1:], "README.md"]:
            self.assertEqual([f"{name}:1\n" in printed for printed in shares].count(True), 1, name)
        for wrong in ("0/2", "3/2", "1", "a/b"):
            with self.assertRaises(SystemExit), contextlib.redirect_stderr(io.StringIO()):
                self.run_document("", "--share", wrong)

    def test_python_blocks_are_one_program(self):
        text = fenced("python", "x = 1\n") + fenced("python", "open('x', 'w').write(str(x))\n")
        text += fenced("sh", "grep 1 x\n")
        self.assert_passes(text, "--python", sys.executable)
        self.assertEqual(self.run_document(fenced("python", "y\n"), "--python", sys.executable)[0], 1)
        self.assert_passes(fenced("python", "y\n"))

    def test_does_not_change_the_source_tree(self):
        self.assert_passes(fenced("sh", "touch new\n"))
        self.assertFalse((self.tree / "source/new").exists())

    def test_fails_when_a_command_fails(self):
        self.assert_fails(fenced("sh", "false\ntrue\n"), "FAILED  README.md:1: exit code 1")
        self.assert_fails(fenced("sh", "false | cat\n"), "FAILED")

    def test_ends_what_a_failed_document_has_left(self):
        text = fenced("sh", "sleep 100 > log 2>&1 &\necho $! > pid\n") + fenced("sh", "kill -0 \"$(cat pid)\"\n")
        self.assert_passes(text)
        self.assertFalse(is_running(self.left()))
        self.assert_fails(text + fenced("sh", "false\n") + fenced("sh", "kill \"$(cat pid)\"\n"), "FAILED")
        self.assertFalse(is_running(self.left()))

    def left(self):
        return (self.tree / "scratch/README.md/pid").read_text(encoding="utf-8").strip()

    def test_compares_what_a_console_block_shows(self):
        self.assert_passes(fenced("console", "$ echo hello\nhello\n$ true\n"))
        self.assert_fails(fenced("console", "$ echo hello\nbye\n"), "instead of:\nbye")
        self.assert_fails(fenced("console", "$ printf 'a\\nb\\n'\na\n"), "instead of:")
        self.assert_fails(fenced("console", "$ echo 'a.b'\na+b\n"), "instead of:")

    def test_knows_wildcards_in_what_is_shown(self):
        self.assert_passes(fenced("console", "$ seq 1 9\n1\n...\n9\n"))
        self.assert_passes(fenced("console", "$ echo took 3.1 s\ntook ... s\n"))
        self.assert_fails(fenced("console", "$ seq 1 9\n2\n...\n9\n"), "instead of:")

    def test_continues_commands(self):
        self.assert_passes(fenced("console", "$ echo one \\\n> two\none two\n"))

    def test_finds_the_program(self):
        program = self.write("program", "#!/bin/sh\necho somato $1\n")
        program.chmod(0o755)
        text = fenced("console", "$ somato map\nsomato map\n$ build/release/somato plot\nsomato plot\n")
        self.assert_passes(text, "--program", str(program))

    def test_compiles_and_runs_programs(self):
        self.assert_passes(fenced("cpp", "int main() { return 0; }\n"))
        self.assert_passes(fenced("cpp", "map.train(samples);\n"))
        self.assert_fails(fenced("cpp", "int main() { return 3; }\n"), "exit code 3")
        self.assert_fails(fenced("cpp", "int main() { return x; }\n"), "exit code 1")

    def test_skips_only_for_known_reasons_and_lines(self):
        mark = "<!-- test: skip sets up the machine -->\n"
        self.assertIn("skipped README.md:2", self.assert_passes(mark + fenced("sh", "./dev test\n")))
        self.assert_fails(mark + fenced("sh", "./dev test\nsomato run\n"), "cannot be skipped")
        mark = "<!-- test: skip needs data of others -->\n"
        self.assert_passes(mark + fenced("sh", 'false --data "$ICUB"\nls "$ICUB"/trials && false\n'))
        self.assert_fails(mark + fenced("sh", "false\n"), "cannot be skipped")
        self.assert_fails(mark + fenced("sh", "echo $HOME\n"), "cannot be skipped")
        self.assert_fails("<!-- test: skip boring -->\n" + fenced("sh", "true\n"), "is not a permitted reason")


if __name__ == "__main__":
    unittest.main()
