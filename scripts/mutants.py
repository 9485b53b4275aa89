"""Single mutations of C++ sources: another operator, another constant, a removed statement."""

import re
from dataclasses import dataclass
from pathlib import Path

TREE = Path(__file__).resolve().parent.parent

# Operators stand between blanks, as clang-format writes binary ones; '<' and '>' of templates do not.
OPERATORS = {
    " < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ", " == ": " != ", " != ": " == ",
    " + ": " - ", " - ": " + ", " * ": " / ", " / ": " * ", " && ": " || ", " || ": " && ",
    " += ": " -= ", " -= ": " += ", "(!": "(", " % ": " / ",
}
OPERATOR = re.compile("|".join(re.escape(operator) for operator in
                               sorted(OPERATORS, key=len, reverse=True)))
CONSTANT = re.compile(r"(?<![\w.])(\d+\.\d*(?:e-?\d+)?|\d+|true|false)(?=[^\w.'xX]|[uUfF]\b)")
# A call or an assignment on a line of its own; reserved memory changes nothing that a test could see.
STATEMENT = re.compile(r"\s+(?!return|using|throw|case|default|break|continue|static|const|auto|typedef|"
                       r"goto|delete|else|namespace|friend|[\w.>-]+reserve\()"
                       r"[\w.:>*()\[\]-]+( [-+*/|&^%]?= .+|\(.*\));")
PREPROCESSOR = re.compile(r"\s*#")
LITERAL = re.compile(r'R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|//[^\n]*|/\*.*?\*/',
                     re.DOTALL)


@dataclass(frozen=True)
class Mutant:
    file: Path
    start: int  # of the replaced characters
    end: int
    replacement: str

    def text(self):
        whole = self.file.read_text(encoding="utf-8")
        return whole[:self.start] + self.replacement + whole[self.end:]

    def __str__(self):
        whole = self.file.read_text(encoding="utf-8")
        line = whole.count("\n", 0, self.start) + 1
        old = whole[self.start:self.end].strip()
        new = self.replacement.strip() or "nothing"
        return f"{self.file.relative_to(TREE)}:{line}: {old} -> {new}"


def without_literals(text):
    """`text` with string literals and comments replaced by blanks, positions unchanged."""
    return LITERAL.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)


def other_constant(constant):
    if constant in ("true", "false"):
        return "false" if constant == "true" else "true"
    if constant.isdigit():
        return str(int(constant) + 1)
    return f"({constant} * 2 + 1)"


def is_balanced(line):
    return line.count("(") == line.count(")") and line.count("{") == line.count("}")


def of_line(file, line, offset):
    for match in OPERATOR.finditer(line):
        yield Mutant(file, offset + match.start(), offset + match.end(), OPERATORS[match[0]])
    for match in CONSTANT.finditer(line):
        yield Mutant(file, offset + match.start(1), offset + match.end(1), other_constant(match[1]))
    if STATEMENT.fullmatch(line) and is_balanced(line):
        yield Mutant(file, offset + len(line) - len(line.lstrip()), offset + len(line), ";")


def of_file(file):
    offset = 0
    for line in without_literals(file.read_text(encoding="utf-8")).splitlines(keepends=True):
        if not PREPROCESSOR.match(line):
            yield from of_line(file, line.rstrip("\n").rstrip(), offset)
        offset += len(line)


def of_files(files):
    """All mutants of `files`, in order."""
    return [mutant for file in files for mutant in of_file(file)]
