#!/usr/bin/env python3
"""Runs the fenced blocks of README.md and docs/.

- ```sh and ```bash blocks run as scripts; ```console blocks run the lines after `$ ` (continued
  after `> `), and what they print must match what the block shows: `...` in a line matches
  any text, a line `...` any lines. Without shown output nothing is compared.
- ```cpp blocks with `int main` are compiled, linked with the library and run.
- ```python blocks run as scripts of the interpreter of --python, all blocks of a document as one program.
- The blocks of a document run in order in a new folder, which contains the folders of the source tree
  and build/release/somato; `somato` is on the path.
- `<!-- test: skip REASON -->` before a block skips it; REASONS defines the permitted blocks. Data of
  others are a `--data FOLDER` or a quoted variable, such as "$FCPS".
- `<!-- test: made FILE -->` before a picture names the file of that folder with the same bytes.

usage: run_doc_blocks.py --source DIR --scratch DIR [--program FILE] [--compiler CXX] [--link FILE]...
                         [--python FILE] [--only DOCUMENT | --without DOCUMENT] [--share I/N]
"""

import argparse
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

# Permitted reasons for skipping a block, and the required form of each of its lines.
REASONS = {
    "sets up the machine": r"(#.*|git clone .*|cd somato|\./dev( [a-z-]+)*( [\w/.-]+)?( *#.*)?"
                           r"|sudo scripts/other_systems\.sh( \d+| arm64)?( *#.*)?)",
    "needs docker": r"(#.*|docker .*)",
    "needs an installed Somato": r"(cmake .*|out/c/user .*)",
    "needs data of others": r"(#.*|.*--data .*|.*\"\$[A-Z]+\".*|.*\\|  .*)",
}
TIMEOUT = 600  # seconds for a command
FENCE = re.compile(
    r"^(?:<!-- test: skip (?P<reason>[^\n]*?) -->\n+)?"
    r"```(?P<kind>sh|bash|console|cpp|python)\n(?P<text>.*?)^```$", re.MULTILINE | re.DOTALL)
MADE = re.compile(r"^<!-- test: made (?P<file>\S+) -->\n+!\[[^\n]*\]\((?P<picture>[^)]+)\)$",
                  re.MULTILINE)

END_OF_BLOCK = "-- end of the block --"
# A program that runs each line of its input, a literal with the text of a block.
INTERPRETER = f"""
import ast, sys
names = {{"__name__": "__main__"}}
for line in sys.stdin:
    exec(compile(ast.literal_eval(line), "block", "exec"), names)
    print("\\n{END_OF_BLOCK}", flush=True)
"""


class Failure(Exception):
    """A block failed."""


@dataclass
class Block:
    where: str  # file:line
    kind: str
    text: str
    skip_reason: str | None


def blocks_of(text, name):
    found = []
    for match in FENCE.finditer(text):
        line = text.count("\n", 0, match.start("text"))
        found.append(Block(f"{name}:{line}", match["kind"], match["text"], match["reason"]))
    return found


def check_skip(block):
    """Whether the block is skipped; raises Failure if skipping is not permitted."""
    if block.skip_reason is None:
        return False
    pattern = REASONS.get(block.skip_reason)
    if pattern is None:
        raise Failure(f"'{block.skip_reason}' is not a permitted reason; permitted reasons: {', '.join(REASONS)}")
    for line in filter(None, block.text.splitlines()):
        if not re.fullmatch(pattern, line):
            raise Failure(f"'{line}' cannot be skipped with the reason: {block.skip_reason}")
    return True


def commands_of(text):
    """The (command, shown output) pairs of a console block."""
    pairs = []
    for line in text.splitlines():
        if line.startswith("$ "):
            pairs.append((line[2:], []))
        elif not pairs:
            raise Failure("a console block starts with '$ '")
        elif line.startswith("> ") and not pairs[-1][1]:
            pairs[-1] = (pairs[-1][0] + "\n" + line[2:], [])
        else:
            pairs[-1][1].append(line)
    return pairs


def pattern_of(shown):
    """A regular expression for the shown lines with their wildcards."""
    lines = []
    for line in shown:
        if line.strip() == "...":
            lines.append(r"(?:[^\n]*\n)*?")
        else:
            lines.append(".*?".join(re.escape(part) for part in line.rstrip().split("...")) + r" *\n")
    return "".join(lines)


def signal_group(group, number):
    """Whether there are processes of the group, which then receive the signal."""
    try:
        os.killpg(group, number)
    except ProcessLookupError:
        return False
    return True


def shell(text):
    return ["bash", "-e", "-o", "pipefail", "-c", text]


class Runner:
    """Runs blocks in the folder of one document."""

    def __init__(self, options, folder):
        self.options = options
        self.folder = folder
        self.environment = dict(os.environ, LC_ALL="C.UTF-8")
        self.interpreter = None  # of the Python blocks, from the first one on
        self.background = []  # groups of processes that commands have left
        self.prepare()

    def prepare(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        (self.folder / "build/release").mkdir(parents=True)
        for entry in self.options.source.iterdir():
            if entry.name not in ("build", "out", ".git"):
                (self.folder / entry.name).symlink_to(entry)
        if self.options.program:
            program = self.folder / "build/release/somato"
            program.symlink_to(self.options.program)
            self.environment["PATH"] = f"{program.parent}:{self.environment['PATH']}"

    def run(self, block):
        if block.kind == "console":
            self.run_console(block)
        elif block.kind == "cpp":
            self.run_cpp(block)
        elif block.kind == "python":
            self.run_python(block)
        else:
            self.run_command(shell(block.text))

    def run_command(self, command):
        """What the command prints; its processes in the background run until the end of the document."""
        with subprocess.Popen(command, cwd=self.folder, env=self.environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              start_new_session=True) as process:
            try:
                printed, _ = process.communicate(timeout=TIMEOUT)
            except BaseException:
                signal_group(process.pid, signal.SIGKILL)
                raise
        if signal_group(process.pid, 0):
            self.background.append(process.pid)
        if process.returncode != 0:
            raise Failure(f"exit code {process.returncode} of:\n{command[-1]}\n{printed}")
        return printed

    def run_console(self, block):
        for command, shown in commands_of(block.text):
            printed = self.run_command(shell(command))
            if any(shown) and not re.fullmatch(pattern_of(shown), printed.rstrip("\n") + "\n"):
                raise Failure(f"$ {command}\nprints:\n{printed}instead of:\n" + "\n".join(shown))

    def search_paths(self):
        """The library path of a program."""
        shared = [Path(file) for file in self.options.link if ".so" in file]
        return sorted({f"-Wl,-rpath,{file.parent}" for file in shared})

    def run_cpp(self, block):
        if "int main" not in block.text:
            return
        source = self.folder / "build/block.cc"
        source.write_text(block.text, encoding="utf-8")
        program = self.folder / "build/block"
        self.run_command([self.options.compiler, "-std=c++20", "-Wall", "-Wextra", "-Werror", "-I",
                          str(self.options.source / "include"), str(source), "-o", str(program),
                          *self.options.link, *self.search_paths(), "-pthread"])
        self.run_command([str(program)])

    def run_python(self, block):
        """Runs the block in the document's interpreter, where names of earlier blocks are defined."""
        if self.interpreter is None:
            self.interpreter = subprocess.Popen(
                [self.options.python, "-u", "-c", INTERPRETER], cwd=self.folder,
                env=self.environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT, text=True)
        self.interpreter.stdin.write(repr(block.text) + "\n")
        self.interpreter.stdin.flush()
        printed = ""
        for line in self.interpreter.stdout:
            if line == END_OF_BLOCK + "\n":
                return
            printed += line
        raise Failure(f"exit code {self.interpreter.wait()} of:\n{block.text}\n{printed}")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for group in self.background:
            signal_group(group, signal.SIGKILL)
        if self.interpreter is not None:
            self.interpreter.communicate()


def passes(runner, block):
    """Whether the block passes or may be skipped; prints a line."""
    started = time.monotonic()
    try:
        if check_skip(block):
            print(f"skipped {block.where}: {block.skip_reason}", flush=True)
            return True
        runner.run(block)
    except (Failure, subprocess.TimeoutExpired) as failure:
        print(f"FAILED  {block.where}: {failure}", flush=True)
        return False
    print(f"ok {time.monotonic() - started:6.1f} s  {block.where}", flush=True)
    return True


def run_document(options, document):
    """Returns the number of failures."""
    blocks = blocks_in(options, document)
    if not blocks:
        return 0
    all_blocks = blocks_of(document.read_text(encoding="utf-8"), name_of(options, document))
    with Runner(options, options.scratch / name_of(options, document).replace("/", "_")) as runner:
        if not all(passes(runner, block) for block in blocks):
            return 1  # what follows in this document may stand on it
    # Without Python, some pictures are not made.
    return check_pictures(document, runner.folder) if len(blocks) == len(all_blocks) else 0


def name_of(options, document):
    return document.relative_to(options.source).as_posix()


def blocks_in(options, document):
    """The blocks of a document that run with the options."""
    blocks = blocks_of(document.read_text(encoding="utf-8"), name_of(options, document))
    return [block for block in blocks if options.python or block.kind != "python"]


def check_pictures(document, folder):
    """Returns the number of pictures that differ from the files created by the commands."""
    failures = 0
    for match in MADE.finditer(document.read_text(encoding="utf-8")):
        made, picture = folder / match["file"], document.parent / match["picture"]
        if not made.is_file() or made.read_bytes() != picture.read_bytes():
            print(f"FAILED  {document.name}: {match['picture']} differs from {made}; update it", flush=True)
            failures += 1
    return failures


def documents_of(options):
    named = options.only or options.without
    documents = [options.source / "README.md", *sorted((options.source / "docs").rglob("*.md"))]
    if named and options.source / named not in documents:
        sys.exit(f"{named} is no document of {options.source}")
    chosen = [document for document in documents
              if not named or (document == options.source / named) == bool(options.only)]
    return share_of(options, chosen)


def share_of(options, documents):
    """Every N-th document, by the number of blocks, so that the shares last about equally long."""
    number, of = options.share
    return sorted(documents, key=lambda document: -len(blocks_in(options, document)))[number - 1::of]


def share(text):
    """The numbers I and N of 'I/N'."""
    match = re.fullmatch(r"([1-9]\d*)/([1-9]\d*)", text)
    if not match or int(match[1]) > int(match[2]):
        raise argparse.ArgumentTypeError(f"'{text}' is no share, such as 1/2")
    return int(match[1]), int(match[2])


def main(arguments=None):
    parser = argparse.ArgumentParser(description="Runs the fenced blocks of the documentation.")
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--scratch", type=Path, required=True)
    parser.add_argument("--program", type=Path)
    parser.add_argument("--compiler", default="c++")
    parser.add_argument("--link", action="append", default=[])
    parser.add_argument("--python", help="without it, blocks in Python do not run")
    chosen = parser.add_mutually_exclusive_group()
    chosen.add_argument("--only", help="the only document to run, relative to --source")
    chosen.add_argument("--without", help="the only document not to run")
    parser.add_argument("--share", type=share, default=(1, 1), help="run only the I-th of N shares of the documents")
    options = parser.parse_args(arguments)
    options.source = options.source.resolve()
    failures = sum(run_document(options, document) for document in documents_of(options))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
