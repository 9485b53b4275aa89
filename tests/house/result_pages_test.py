import contextlib
import io
import json
import tomllib
import unittest
from pathlib import Path

from support import TreeTest

import announced_page
import reproduction_page
import result_tables
import unknowns_page

UNKNOWNS = Path(__file__).resolve().parents[2] / "systems" / "unknowns"
HASH = "cdab067e9f3b"


def claim(**changes):
    made = {"text": "It holds", "paper": "P11 IV", "question": "", "system": "texture", "variation": "",
            "metric": "classes_separated", "protocol": "train_is_test", "group": "", "published": 5,
            "at_least": 4, "at_most": 6, "share": 0.75, "mean": 5.25, "sd": 0.5, "by_chance": 7.5,
            "values": [5, 5, 5, 6], "verdict": "mostly", "reason": "", "chance_share": 0.25}
    return {**made, **changes}


def written(**changes):
    made = {"judged_by": "central_range", "metric": "classes_separated", "published": 5, "at_least": None,
            "at_most": None, "bounds_included": True, "verdict": "compatible", "reason": "", "share": 0.75,
            "mean": 5.25, "sd": 0.5, "by_chance": None, "chance_share": None, "values": [5, 5, 5, 6], "range": [4, 6],
            "chance_range": [6, 8], "recordings": [0, 0, 1, 1]}
    return {**made, **changes}


def run(*pairs):
    return {"seed": 1, "winners": [], "labels": [p[0] for p in pairs], "predictions": [p[1] for p in pairs]}


def protocol(name, group, *runs):
    made = {"protocol": name, "label": "material", "metrics": {"accuracy": {"values": [0.5, 1.0]}}, "runs": list(runs)}
    return {**made, "group": group} if group else made


FOLDS = protocol("leave_group_out", "trial",
                 run(("felt", "felt"), ("felt", "wood"), ("wood", "wood"), ("metal", "wood")),
                 run(("felt", "felt"), ("felt", "felt"), ("wood", "felt"), ("metal", "metal")))


def results():
    part = {"question": "", "system": "texture", "variation": "", "parameters": {"b": 1, "a": "x"},
            "recordings": [0], "pairs": [[0, 7], [0, 8]],
            "protocols": [protocol("train_is_test", "", run(("felt", "felt"))), FOLDS]}
    return {"parts": [part], "claims": [claim(), claim(paper="", text="Ours")],
            "recordings": [{"name": "one.mcap", "source": "probes", "seed": 7, "hash": "fnv1a64:12",
                            "explorations": 4}]}


def swept(first_order, chance=0.1):
    return {"name": "rate", "cells": [{"points": 2, "share": 0.25}, {"points": 2, "share": 1.0}], "change": 0.75,
            "first_order": first_order, "first_order_by_chance": chance}


def sweep(*unknowns):
    judged = {**claim(), "points": 4, "holds": 0.5, "mean_share": 0.625, "unknowns": list(unknowns)}
    return {"system": "texture", "design": "sobol", "seed": 7, "pairs": 4,
            "unknowns": [{"name": "rate", "cells": [{"from": 0.05, "to": 0.2}, {"from": 0.2, "to": 0.8}]}],
            "claims": [judged, {**judged, "text": "Held out", "points": 0}], "not_judged": ["Between two"],
            "points": [{"recordings": ["one.mcap"]}] * 4}


class Claims(unittest.TestCase):
    def test_two_sided_bounds_are_a_range(self):
        self.assertEqual(result_tables.range_text(claim()), "4 to 6")
        self.assertEqual(result_tables.range_text(claim(at_least=5, at_most=5)), "= 5")
        self.assertEqual(result_tables.range_text(claim(at_most=None)), "≥ 4")
        self.assertEqual(result_tables.range_text(claim(at_least=None, at_most=0)), "≤ 0")

    def test_a_row_has_the_share_of_chance_and_the_verdict(self):
        self.assertEqual(result_tables.claim_table([claim()]).splitlines()[2],
                         "| texture: It holds | P11 IV | `classes_separated` 4 to 6, train = test | 5 | 5.25 ± 0.50 | "
                         "7.5 | 75 % of 4 | 25 % | mostly |")

    def test_comparisons_of_our_own_have_no_column_of_papers(self):
        text = result_tables.claim_table([claim(paper="", chance_share=None, by_chance=None)])
        self.assertEqual(text.splitlines()[2].split(" | ")[5:], ["75 % of 4", "–", "mostly |"])
        self.assertNotIn("paper", text)

    def test_a_second_measure_has_its_columns(self):
        rows = result_tables.claim_table([
            claim(as_written=written(), contradicted_by="Fig. 8"), claim(limit=0.877),
            claim(as_written=written(judged_by="mean", published=None, at_least=0, range=[-0.25, 1.126], mean=0.4,
                                     bounds_included=False, verdict="not determined")),
            claim(as_written=written(judged_by="share_of_pairs", at_most=1, limit=3, by_chance=3.5, chance_share=0.01,
                                     metric="exceptions_around", verdict="cannot be decided here",
                                     reason="4 pairs; 20 are needed"))]).splitlines()
        self.assertEqual([line.split(" | ")[9:] for line in (rows[0], *rows[2:])], [
            ["as written", "verdict as written |"],
            ["5 in 4 to 6; by chance 6 to 8", "compatible; contradicted by Fig. 8 |"],
            ["–", "the same |"],
            ["mean 0.4 (-0.25 to 1.13) > 0", "not determined |"],
            ["`exceptions_around` ≤ 1; best possible 3: 5.25 ± 0.50, 75 %; by chance 3.5, 1 %",
             "cannot be decided here: 4 pairs; 20 are needed |"]])
        self.assertIn("`classes_separated` 4 to 6, train = test; best possible 0.88", rows[3])

    def test_a_mean_says_whether_its_bound_is_included(self):
        mean = written(judged_by="mean", published=None, at_least=0, range=[0, 0], mean=0)
        self.assertEqual(result_tables.written_text(mean), "mean 0 (0 to 0) ≥ 0")
        self.assertEqual(result_tables.written_text({**mean, "at_least": None, "at_most": 0.5}),
                         "mean 0 (0 to 0) ≤ 0.5")
        self.assertEqual(result_tables.written_text({**mean, "at_most": 0.5, "bounds_included": False}),
                         "mean 0 (0 to 0) > 0 and < 0.5")

    def test_a_pair_without_a_value_leaves_no_mean(self):
        missing = {"mean": None, "sd": None, "range": None, "values": [5, 5, 5, None]}
        row = result_tables.claim_table([claim(**missing)]).splitlines()[2]
        self.assertEqual(row.split(" | ")[3:6], ["5", "–", "7.5"])
        self.assertEqual(result_tables.written_text(written(judged_by="share_of_pairs", at_most=6, **missing)),
                         "`classes_separated` ≤ 6: –, 75 %; by chance –, –")
        self.assertEqual(result_tables.written_text(written(judged_by="mean", at_least=0, **missing)),
                         "mean – (–) ≥ 0")

    def test_a_second_measure_that_was_not_measured_is_not_the_first(self):
        reason = "the metric 'exceptions_around' was not measured"
        second = written(judged_by="share_of_pairs", metric="exceptions_around", at_most=1, values=[], mean=None,
                         sd=None, share=0, range=None, chance_range=None, recordings=[], reason=reason,
                         verdict="cannot be decided here")
        self.assertEqual(result_tables.written_cells(claim(as_written=second)),
                         ["–", f"cannot be decided here: {reason}"])
        counts = result_tables.written_verdict_counts([claim(as_written=second)])
        self.assertIn("*mostly*: 0", counts)
        self.assertIn("*cannot be decided here*: 1", counts)

    def test_verdicts_as_written_are_counted_with_those_of_the_other_claims(self):
        counts = result_tables.written_verdict_counts([claim(as_written=written()), claim(), claim(verdict="fails")])
        self.assertIn("*compatible*: 1, ", counts)
        self.assertIn("*mostly*: 1, ", counts)
        self.assertIn("*fails*: 1, ", counts)
        sentence = reproduction_page.verdict_sentence([claim(as_written=written()), claim(contradicted_by="Fig. 8")])
        self.assertIn("the second measures of 1 claim: ", sentence)
        self.assertTrue(sentence.endswith("A figure of its paper contradicts 1 claim."))
        self.assertNotIn("written", reproduction_page.verdict_sentence([claim()]))

    def test_a_comparison_names_what_it_is_compared_with(self):
        compared = claim(than_system="hardness", than_variation="small", than_metric="classes_separated",
                         at_least=0, at_most=None)
        self.assertEqual(result_tables.bounds(compared),
                         "`classes_separated` less that of hardness, small ≥ 0, train = test")
        compared["than_metric"] = "classes_separated_chance"
        self.assertEqual(result_tables.bounds(compared),
                         "`classes_separated` less `classes_separated_chance` of hardness, small ≥ 0, train = test")

    def test_what_cannot_be_decided_says_why(self):
        undecided = claim(verdict="cannot be decided here", reason="Too few | pairs.")
        self.assertEqual(result_tables.verdict_text(undecided), "cannot be decided here: Too few \\| pairs.")

    def test_verdicts_are_counted_and_unknown_ones_refused(self):
        self.assertEqual(result_tables.verdict_counts([claim(), claim(), claim(verdict="fails")]),
                         "*holds*: 0, *holds, but so does chance*: 0, *mostly*: 2, *fails*: 1, "
                         "*cannot be decided here*: 0")
        with self.assertRaises(ValueError):
            result_tables.verdict_counts([claim(verdict="perhaps")])


class Confusions(unittest.TestCase):
    def test_shares_are_of_the_row_over_all_runs(self):
        self.assertEqual(result_tables.confusion_table(FOLDS).splitlines(), [
            "| true \\ predicted, % | felt | wood | metal |", "| --- | --- | --- | --- |",
            "| **felt** | 75 | 25 |  |", "| **wood** | 50 | 50 |  |", "| **metal** |  | 50 | 50 |"])

    def test_the_greatest_come_first(self):
        self.assertEqual(result_tables.greatest_confusions(FOLDS),
                         "Most often confused: wood is classified as felt (50.0 %), metal is classified as wood (50.0 %) and "
                         "felt is classified as wood (25.0 %).")

    def test_without_any_it_says_so(self):
        right = protocol("leave_group_out", "trial", run(("felt", "felt")))
        self.assertEqual(result_tables.greatest_confusions(right), "All explorations are classified correctly.")


class Sweeps(unittest.TestCase):
    def test_an_unknown_decides_when_clearly_above_chance(self):
        self.assertTrue(result_tables.decides(swept(0.2)))
        self.assertFalse(result_tables.decides(swept(0.19)))
        self.assertFalse(result_tables.decides(swept(0.04, chance=0.01)))
        self.assertFalse(result_tables.decides(swept(None, chance=None)))

    def test_a_row_says_where_the_claim_holds_more(self):
        rows = result_tables.sweep_table(sweep(swept(0.6))).splitlines()
        self.assertEqual(rows[2:], ["| It holds | P11 IV | 4 to 6 | 50 % | 62 % | `rate` (0.60): most at 0.2 to 0.8 "
                                    "(100 %), least at 0.05 to 0.2 (25 %) |"])

    def test_claims_that_were_not_judged_are_listed(self):
        self.assertEqual(result_tables.unjudged(sweep(swept(0.6))), ["Held out", "Between two"])


class Page(TreeTest):
    def make(self, *options):
        self.write("results.json", json.dumps(results()))
        self.write("sweeps/texture/sweep.json", json.dumps(sweep(swept(0.6))))
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            reproduction_page.main([str(self.tree / "results.json"), "--sweeps", str(self.tree / "sweeps"), *options])
        return printed.getvalue()

    def test_papers_and_our_own_have_tables_of_their_own(self):
        page = self.make()
        papers, ours = page.index("### Claims of the papers"), page.index("### Comparisons by this project")
        self.assertLess(papers, page.index("| texture: It holds"))
        self.assertLess(ours, page.index("| texture: Ours"))
        self.assertIn("Verdicts on 1 claim of the papers", page)

    def test_parameters_have_a_hash_that_does_not_depend_on_their_order(self):
        # printf '{"a":"x","b":1}' | sha256sum
        self.assertEqual(reproduction_page.parameters_hash({"parameters": {"b": 1, "a": "x"}}), HASH)
        self.assertIn(HASH, self.make())

    def test_nothing_is_left_to_fill_in(self):
        self.assertNotIn("{{", self.make())

    def test_check_fails_on_another_page(self):
        same = self.write("page.md", self.make())
        self.assertEqual(self.make("--check", str(same)), "")
        other = self.write("page.md", same.read_text(encoding="utf-8") + "x")
        with self.assertRaises(SystemExit):
            self.make("--check", str(other))

    def test_a_remark_that_is_not_there_is_left_out(self):
        text = "a {{remarks one}} b {{question two}} c"
        self.assertEqual(reproduction_page.put_remarks(text, "Head\n## one\nsaid\n"), "a said b  c")


class Announced(TreeTest):
    """The page of systems beyond the papers."""

    def results(self, **changes):
        made = results()
        part = {**made["parts"][0], "question": "early"}
        folds = protocol("leave_group_out", "trial", run(("felt", "felt")), run(("felt", "felt")))
        folds["metrics"] |= {"altered.half.accuracy": {"values": [0.25, 0.75]},
                             "altered.half.baseline_accuracy": {"values": [0.5, 0.75]},
                             "altered.half.shape.accuracy": {"values": [1, 1]}}
        part["protocols"] = [protocol("train_is_test", "", run(("felt", "felt"))), folds]
        return {**made, "parts": [part], "claims": [claim(question="early"), claim(question="early", paper="")], **changes}

    def page(self, template="{{summary}} {{question early}} {{provenance}}", **changes):
        return announced_page.make_page(template, self.results(**changes))

    def test_every_figure_comes_from_the_results(self):
        page = self.page()
        self.assertIn("| texture | 5 folds | 0.500 ± 0.354 (0.625) |", page)
        self.assertIn("| texture | train = test | material | 0.750 ± 0.354 | – |", page)
        self.assertIn("Expectations of the papers: *holds*: 0, *holds, but so does chance*: 0, *mostly*: 1,", page)
        self.assertIn("5.25 ± 0.50", page)

    def test_alterations_are_those_of_the_own_label(self):
        self.assertEqual(announced_page.altered_names(self.results()["parts"][0]["protocols"][1]), ["half"])

    def test_a_system_that_ran_on_given_recordings_has_its_own_place(self):
        predicted = {"next.prediction_error": {"values": [0.5, 0.75]}, "next.strongest_right": {"values": [1, 1]},
                     "next.strongest_right_chance": {"values": [0.25, 0.25]}}
        made = results()
        made["parts"][0]["protocols"][0]["metrics"] = predicted
        page = announced_page.make_page("{{system texture}}", made)
        self.assertIn("| texture | train = test | next | 0.625 ± 0.177 | – | – | 1.000 ± 0.000 | – | 0.250 ± 0.000 |", page)
        self.assertIn("texture: Ours", page)
        with self.assertRaises(SystemExit):
            announced_page.make_page("{{question early}}", made)

    def test_results_of_several_runs_are_joined(self):
        late = self.results(recordings=[{"name": "two.mcap", "source": "probes", "seed": 8, "hash": "fnv1a64:13",
                                         "explorations": 4}])
        late["parts"][0]["question"] = "late"
        late["claims"] = []
        joined = announced_page.joined([self.results(), late])
        self.assertEqual([part["question"] for part in joined["parts"]], ["early", "late"])
        self.assertEqual([r["name"] for r in joined["recordings"]], ["one.mcap", "two.mcap"])
        self.assertEqual(len(joined["claims"]), 2)
        with self.assertRaises(SystemExit):
            announced_page.joined([self.results(), self.results()])

    def test_a_question_without_a_place_is_refused(self):
        with self.assertRaises(SystemExit):
            self.page("{{summary}}")
        with self.assertRaises(SystemExit):
            self.page("{{question early}} {{question late}}")
        with self.assertRaises(SystemExit):
            self.page("{{question early}} {{else}}")

    def test_check_fails_on_another_page(self):
        source = self.write("results.json", json.dumps(self.results()))
        template = self.write("page.md.in", "{{question early}}\n")
        announced_page.TEMPLATE, kept = template, announced_page.TEMPLATE
        self.addCleanup(setattr, announced_page, "TEMPLATE", kept)
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            announced_page.main([str(source)])
        same = self.write("page.md", printed.getvalue())
        announced_page.main([str(source), "--check", str(same)])
        with self.assertRaises(SystemExit):
            announced_page.main([str(source), "--check", str(self.write("page.md", printed.getvalue() + "x"))])

    def test_each_question_has_a_place_on_the_page(self):
        template = announced_page.TEMPLATE.read_text(encoding="utf-8")
        for file in announced_page.FILES.glob("*.toml"):
            question = tomllib.loads(file.read_text(encoding="utf-8")).get("question")
            if question:
                self.assertIn(f"{{{{question {question['name']}}}}}", template, file.name)


class Unknowns(unittest.TestCase):
    def test_systems_that_try_the_same_stand_together(self):
        rate = {"key": "module.map.rate", "low": 0.05, "high": 0.8, "scale": "logarithmic", "text": "Not given."}
        page = unknowns_page.make_page({"texture": {"rate": rate}, "hardness": {"rate": rate}},
                                       {"texture": sweep(swept(0.6))})
        self.assertIn("- **texture and hardness**: `module.map.rate`\n  - tested values: 0.05 to 0.8, logarithmic\n"
                      "  - Not given.\n  - texture: It holds: `rate` (0.60): most at 0.2 to 0.8 (100 %)", page)

    def test_without_sweeps_it_says_so(self):
        self.assertIn("No sweep was run", unknowns_page.make_page({"a": {}}, {}))

    def test_each_of_the_nine_systems_has_a_file(self):
        self.assertEqual(tuple(unknowns_page.load_unknowns(UNKNOWNS)), unknowns_page.ORDER)

    def test_the_systems_of_hand_2_explore_the_same_points(self):
        """Else their sweeps could not share recordings: the place of an unknown decides its values."""
        bodies = []
        for name in unknowns_page.ORDER[:4]:
            file = tomllib.loads((UNKNOWNS / f"{name}.toml").read_text(encoding="utf-8"))
            unknowns = list(file["unknown"].values())
            explored = [u for u in unknowns if str(u["key"]).startswith("explore.")]
            self.assertEqual(explored, unknowns[:len(explored)], name)
            bodies.append((file["sweep"], explored))
        self.assertEqual(bodies, [bodies[0]] * 4)
