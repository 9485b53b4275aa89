#!/usr/bin/env python3
"""Makes web/src/report/metrics.ts, the words and ranges of all metrics, from the rows of
src/studies/results/metrics.inc, which the C++ sources include.

usage: page_metrics.py [--check] [TREE]

With --check nothing is written, and a file that differs from the rows is refused. A row is one
line: {"NAME", "WORDS", RANGE, DIRECTION, true or false}, with enumerators of metric_table.h; other
lines begin with //.
"""

import re
import sys
from pathlib import Path

ROWS = "src/studies/results/metrics.inc"
PAGE = "web/src/report/metrics.ts"
ROW = re.compile(r'\{"([a-z][a-z_]*)", "([^"\\]+)", k([A-Z]\w*), k[A-Z]\w*, (?:true|false)\},')

HEAD = f"""\
// Made from {ROWS} by scripts/page_metrics.py; change the rows.
//
// The words and the range of every metric. docs/reference/results.md defines the metrics.
"""


class RowError(ValueError):
    """A line that is neither a row nor a comment, or a second row of the same metric."""


def range_named(enumerator):
    """The range of the page: "from_zero" for FromZero."""
    return re.sub(r"(?<!^)(?=[A-Z])", "_", enumerator).lower()


def read_rows(text):
    """(words, range) by the name of each metric, in the order of the rows."""
    rows = {}
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("//"):
            continue
        row = ROW.fullmatch(line)
        if not row:
            raise RowError(f"{ROWS}:{number}: not a row of a metric: {line}")
        if row[1] in rows:
            raise RowError(f"{ROWS}:{number}: '{row[1]}' has a row already")
        rows[row[1]] = (row[2], range_named(row[3]))
    if not rows:
        raise RowError(f"{ROWS}: no metric")
    return rows


def type_script(rows):
    ranges = " | ".join(f'"{one}"' for one in sorted({values for _, values in rows.values()}))
    entries = "\n".join(f'  ["{name}", {{ words: "{words}", range: "{values}" }}],'
                        for name, (words, values) in rows.items())
    return (f"{HEAD}\nexport type MetricRange = {ranges};\n\n"
            "export interface MetricInfo {\n  words: string;\n  range: MetricRange;\n}\n\n"
            f"export const kMetrics: ReadonlyMap<string, MetricInfo> = new Map<string, MetricInfo>([\n{entries}\n]);\n")


def page_of(tree):
    return type_script(read_rows((tree / ROWS).read_text(encoding="utf-8")))


def check(tree):
    page = tree / PAGE
    if page.is_file() and page.read_text(encoding="utf-8") == page_of(tree):
        return []
    return [f"{PAGE}: not made from {ROWS}; run scripts/page_metrics.py"]


def main():
    is_check = "--check" in sys.argv[1:]
    trees = [one for one in sys.argv[1:] if one != "--check"]
    tree = Path(trees[0]) if trees else Path(__file__).resolve().parent.parent
    try:
        problems = check(tree) if is_check else []
        if not is_check:
            (tree / PAGE).write_text(page_of(tree), encoding="utf-8")
    except RowError as error:
        problems = [str(error)]
    print(*problems, sep="\n", end="\n" if problems else "", file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
