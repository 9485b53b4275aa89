#!/usr/bin/env python3
"""Makes the TypeScript types of the pages' JSON from its schemas: web/src/FOLDER/data.ts from
web/schema/FOLDER.json.

usage: page_types.py [--check] [TREE]

With --check nothing is written, and types that differ from their schema are refused. The schemas
are a subset of JSON Schema, draft 2020-12: the keywords of KEYWORDS and references to
"#/$defs/NAME" and "FILE.json#/$defs/NAME". An object states its additionalProperties; with
properties it has a name in $defs and no others. tests/base/support/json_schema.h checks documents by
the same subset.
"""

import json
import sys
import textwrap
from pathlib import Path

FOLDERS = ("parts", "report", "view")
KEYWORDS = {"$schema", "$defs", "$ref", "description", "type", "const", "enum", "anyOf", "minimum",
            "maximum", "items", "minItems", "maxItems", "properties", "required",
            "additionalProperties"}
PLAIN_TYPES = {"string": "string", "number": "number", "integer": "number", "boolean": "boolean",
               "null": "null"}
WIDTH = 100  # characters a line


class SchemaError(ValueError):
    """A schema outside of the subset."""


class TypeScript:
    """The types of the schema of one folder; `schemas` are those of all folders."""

    def __init__(self, folder, schemas):
        self.folder = folder
        self.schemas = schemas
        self.imported = {}  # folder to names

    def text(self):
        schema = self.schemas[self.folder]
        check_keywords(schema)
        definitions = [self.definition(name, one) for name, one in schema["$defs"].items()]
        origin = f"Made from web/schema/{self.folder}.json by scripts/page_types.py; change the schema."
        head = "\n".join(comment_lines(f"{origin}\n\n{schema['description']}", "// "))
        return "\n\n".join([head, *self.imports(), *definitions]) + "\n"

    def imports(self):
        for folder, names in sorted(self.imported.items()):
            lines = "\n".join(f"  {name}," for name in sorted(names))
            yield f'import type {{\n{lines}\n}} from "../{folder}/data";'

    def definition(self, name, schema):
        comment = documentation(schema, "")
        if schema.get("properties"):
            return "\n".join([*comment, f"export interface {name} {{", *self.fields(schema), "}"])
        line = f"export type {name} = {self.type_of(schema)};"
        if len(line) > WIDTH:
            line = line.replace(" | ", "\n  | ").replace(" = ", " =\n  | ")
        return "\n".join([*comment, line])

    def fields(self, schema):
        check_keywords(schema)
        if schema["additionalProperties"] is not False:
            raise SchemaError("additionalProperties is not false beside properties")
        required = schema.get("required", [])
        if unknown := set(required) - set(schema["properties"]):
            raise SchemaError(f"{sorted(unknown)} are required and are no properties")
        for name, one in schema["properties"].items():
            yield from documentation(one, "  ")
            yield f"  {name}{'' if name in required else '?'}: {self.type_of(one)};"

    def type_of(self, schema):
        check_keywords(schema)
        if "$ref" in schema:
            return self.referred(schema["$ref"])
        if "const" in schema:
            return json.dumps(schema["const"])
        if "enum" in schema:
            return " | ".join(json.dumps(one) for one in schema["enum"])
        if "anyOf" in schema:
            return " | ".join(self.type_of(one) for one in schema["anyOf"])
        if schema["type"] == "array":
            return self.array(schema)
        if schema["type"] == "object":
            return self.record(schema)
        types = schema["type"] if isinstance(schema["type"], list) else [schema["type"]]
        return " | ".join(PLAIN_TYPES[one] for one in types)

    def referred(self, reference):
        file, _, name = reference.partition("#/$defs/")
        folder = file.removesuffix(".json") or self.folder
        if name not in self.schemas.get(folder, {}).get("$defs", {}):
            raise SchemaError(f"'{reference}' refers to nothing")
        if folder != self.folder:
            self.imported.setdefault(folder, set()).add(name)
        return name

    def array(self, schema):
        items = self.type_of(schema["items"])
        if "maxItems" in schema and schema.get("minItems") == schema["maxItems"]:
            return f"[{', '.join([items] * schema['maxItems'])}]"
        return f"({items})[]" if "|" in items else f"{items}[]"

    def record(self, schema):
        if schema.get("properties"):
            raise SchemaError("an object with properties has no name in $defs")
        others = schema["additionalProperties"]
        return f"Record<string, {self.type_of(others) if others else 'never'}>"


def check_keywords(schema):
    if unknown := set(schema) - KEYWORDS:
        raise SchemaError(f"unknown keywords {sorted(unknown)}")
    if schema.get("type") == "object" and "additionalProperties" not in schema:
        raise SchemaError("an object does not state its additionalProperties")


def comment_lines(text, begin):
    for paragraph in text.split("\n"):
        for line in textwrap.wrap(paragraph, WIDTH - len(begin)) or [""]:
            yield (begin + line).rstrip()


def documentation(schema, indent):
    text = schema.get("description", "")
    line = f"{indent}/** {text} */"
    if not text or len(line) <= WIDTH:
        return [line] if text else []
    return [f"{indent}/**", *comment_lines(text, f"{indent} * "), f"{indent} */"]


def types_of(tree):
    """The text of each file of types, by its path."""
    schemas = {folder: json.loads((tree / f"web/schema/{folder}.json").read_text(encoding="utf-8"))
               for folder in FOLDERS}
    return {tree / f"web/src/{folder}/data.ts": TypeScript(folder, schemas).text()
            for folder in FOLDERS}


def check(tree):
    return [f"{path.relative_to(tree)}: not made from its schema; run scripts/page_types.py"
            for path, text in types_of(tree).items() if path.read_text(encoding="utf-8") != text]


def main():
    is_check = "--check" in sys.argv[1:]
    trees = [one for one in sys.argv[1:] if one != "--check"]
    tree = Path(trees[0]) if trees else Path(__file__).resolve().parent.parent
    if not is_check:
        for path, text in types_of(tree).items():
            path.write_text(text, encoding="utf-8")
        return 0
    problems = check(tree)
    print(*problems, sep="\n", end="\n" if problems else "", file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
