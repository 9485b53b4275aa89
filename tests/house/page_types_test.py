import json
import unittest

from support import TreeTest

import page_types

NUMBER = {"type": "number"}


class PageTypes(TreeTest):
    """Types of a tree whose report has the schemas of a test."""

    def write_schemas(self, definitions, parts=None):
        for folder, content in (("parts", parts or {}), ("report", definitions), ("view", {})):
            schema = {"description": f"The {folder}.", "$defs": content}
            self.write(f"web/schema/{folder}.json", json.dumps(schema))
            self.write(f"web/src/{folder}/data.ts")

    def types(self, definitions, parts=None):
        self.write_schemas(definitions, parts)
        return page_types.types_of(self.tree)[self.tree / "web/src/report/data.ts"]

    def type_of(self, schema):
        return self.types({"A": schema}).split("export type A = ")[1].removesuffix(";\n")

    def problem(self, schema):
        with self.assertRaises(page_types.SchemaError) as caught:
            self.types({"A": schema})
        return str(caught.exception)

    def test_plain_types(self):
        self.assertEqual(self.type_of({"type": "string"}), "string")
        self.assertEqual(self.type_of({"type": "integer", "minimum": 0}), "number")
        self.assertEqual(self.type_of({"type": ["boolean", "null"]}), "boolean | null")
        self.assertEqual(self.type_of({"const": 1}), "1")
        self.assertEqual(self.type_of({"enum": ["a", 0]}), '"a" | 0')
        self.assertEqual(self.type_of({"anyOf": [NUMBER, {"type": "null"}]}), "number | null")

    def test_lists_and_records(self):
        self.assertEqual(self.type_of({"type": "array", "items": NUMBER}), "number[]")
        either = {"type": ["number", "null"]}
        self.assertEqual(self.type_of({"type": "array", "items": either}), "(number | null)[]")
        pair = {"type": "array", "items": NUMBER, "minItems": 2, "maxItems": 2}
        self.assertEqual(self.type_of(pair), "[number, number]")
        record = {"type": "object", "additionalProperties": NUMBER}
        self.assertEqual(self.type_of(record), "Record<string, number>")
        nothing = {"type": "object", "additionalProperties": False, "properties": {}}
        self.assertEqual(self.type_of(nothing), "Record<string, never>")

    def test_an_object_is_an_interface_with_its_documentation(self):
        text = self.types({"Size": {
            "description": "How large.", "type": "object", "required": ["width"],
            "additionalProperties": False,
            "properties": {"width": {"description": "In mm.", "type": "number"},
                           "unit": {"type": "string"}}}})
        self.assertEqual(text.split("\n\n")[1], "/** How large. */\nexport interface Size {\n"
                         "  /** In mm. */\n  width: number;\n  unit?: string;\n}\n")

    def test_a_name_of_another_file_is_imported(self):
        reference = {"type": "array", "items": {"$ref": "parts.json#/$defs/Size"}}
        text = self.types({"Sizes": reference, "Same": {"$ref": "#/$defs/Sizes"}}, {"Size": NUMBER})
        self.assertIn('import type {\n  Size,\n} from "../parts/data";\n', text)
        self.assertIn("export type Sizes = Size[];\n\nexport type Same = Sizes;\n", text)

    def test_refuses_what_it_cannot_express(self):
        self.assertEqual(self.problem({"type": "string", "pattern": "a"}),
                         "unknown keywords ['pattern']")
        self.assertEqual(self.problem({"$ref": "#/$defs/B"}), "'#/$defs/B' refers to nothing")
        self.assertEqual(self.problem({"type": "object"}),
                         "an object does not state its additionalProperties")
        open_object = {"type": "object", "properties": {"a": NUMBER}, "additionalProperties": NUMBER}
        self.assertEqual(self.problem(open_object),
                         "additionalProperties is not false beside properties")
        misspelt = {"type": "object", "properties": {"a": NUMBER}, "required": ["b"],
                    "additionalProperties": False}
        self.assertEqual(self.problem(misspelt), "['b'] are required and are no properties")

    def test_types_of_another_schema_are_refused(self):
        self.write_schemas({"A": NUMBER})
        for path, text in page_types.types_of(self.tree).items():
            path.write_text(text, encoding="utf-8")
        self.assertEqual(page_types.check(self.tree), [])
        self.write("web/schema/report.json",
                   json.dumps({"description": "The report.", "$defs": {"B": NUMBER}}))
        self.assertEqual(page_types.check(self.tree), [
            "web/src/report/data.ts: not made from its schema; run scripts/page_types.py"])


if __name__ == "__main__":
    unittest.main()
