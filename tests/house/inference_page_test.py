import contextlib
import io
import json
import unittest

from support import TREE, TreeTest

import inference_page
import inference_study

COMMENT = """# A prior of a press.
#
#     somato explore --body press -o out/inference/stock.mcap
#     somato sweep press --over systems/inference/press.toml \\
#       --targets 'a b.toml' --out out/inference/press
#
# Somato is mentioned here: somato sweep is no command.

[sweep]
# somato report
"""


def claim(**changes):
    made = {"text": "It holds", "paper": "P11 IV", "question": "", "system": "press", "variation": "", "metric": "accuracy",
            "protocol": "train_is_test", "group": "", "published": None, "at_least": 0.5, "at_most": None, "prior": 0.25,
            "values": {"least": 0.125, "median": 0.25, "greatest": 0.75},
            "posterior": 1.0, "left_out": 0.5, "fresh": 0.95, "fresh_verdict": "holds", "fresh_verdict_as_written": "holds",
            "chance": 0.2, "fresh_chance": 0.1, "draws": 1024, "support": "explained"}
    return {**made, **changes}


CLAIMS = [claim(),
          claim(text="It is half", prior=0.5, left_out=None, fresh=0.25, fresh_verdict="fails",
                fresh_verdict_as_written="compatible", support="reachable"),
          claim(text="It never holds", prior=0.0, at_least=None, at_most=1, values=None, fresh=0.0, fresh_verdict="fails", fresh_verdict_as_written="fails",
                fresh_chance=None, support="excluded"),
          claim(text="Ours", paper="", prior=1.0, support="explained")]


def unknown(name, shrinkage, cells, **ends):
    low, median, high = ends.get("ends", (1, 2, 3))
    summary = {"low": low, "median": median, "high": high}
    return {"name": name, "key": [f"module.map.{name}"], "text": "", "system": "0.3", "cells": cells, "prior": summary,
            "posterior": summary, "shrinkage": shrinkage}


def cell(low, high, prior, posterior):
    return {"from": low, "to": high, "prior": prior, "posterior": posterior}


def calibrated(name, covered, p):
    return {"name": name, "covered": covered, "uniform_p": p, "ranks": [0.5]}


def joint(sums, failing):
    return {"bodies": len(sums), "mean": sum(sums) / len(sums), "sums": sums, "not_failing": failing,
            "not_failing_as_written": failing}


def inference(**changes):
    made = {"version": 1, "systems": ["press"], "draws": 1024, "pairs": 2, "accepted": 100, "adjusted": True,
            "inference": {"accepted": 0.02, "adjusted": True, "truths": 25, "bodies": 20, "pairs": 5, "seed": 1},
            "targets": [{"text": "Half", "paper": "P11", "system": "press", "variation": "", "metric": "accuracy",
                         "protocol": "train_is_test", "observed": 5, "scale": 1.5, "prior": 7.25, "posterior": 5.5}],
            "unknowns": [unknown("rate", 0.5, [cell(0.1, 2, 0.5, 0.25), cell(2, 9000.0, 0.5, 0.75)]),
                         unknown("order", 0.95, [cell("once", "once", 0.5, 0.4), cell("each", "each", 0.5, 0.6)])],
            "dependences": [{"first": "rate", "second": "order", "correlation": -0.31}],
            "calibration": {"truths": 25, "unknowns": [calibrated("rate", 0.88, 0.4), calibrated("order", 0.6, 0.04)]},
            "claims": CLAIMS,
            "conflicts": [{"first": {"system": "press", "variation": "", "text": "A"},
                           "second": {"system": "press", "variation": "small", "text": "B"}, "together": 26.0,
                           "expected": 55.2, "deviations": -4.26}],
            "joint": {"claims": 4, "prior": joint([1.0, 2.0, 3.0], 3), "fresh": joint([2.0, 2.5], 2)}, "bodies": [{}, {}]}
    return {**made, **changes}


def shipped():
    """Results of the shipped body: two more claims, one of them of a side question."""
    def of(one, verdict, **changes):
        return {**one, "verdict": verdict, "share": 0.75, **changes}

    protocol = {"protocol": "leave_group_out", "group": "trial", "label": "material", "runs": [],
                "metrics": {"accuracy": {"values": [0.5, 0.7]}, "baseline_accuracy": {"values": [0.8, 0.8]}}}
    part = {"question": "", "system": "press", "variation": "", "protocols": [protocol]}
    return {"parts": [part],
            "claims": [of(CLAIMS[0], "fails"), of(CLAIMS[1], "fails", as_written={"verdict": "compatible"}),
                       of(CLAIMS[2], "mostly"), of(claim(text="Side", question="side"), "holds"),
                       of(claim(text="Other", protocol="k_folds"), "fails")]}


class PageTest(TreeTest):
    def store(self, name, data, **files):
        self.write(f"out/{name}/inference.json", json.dumps(data))
        for file, content in files.items():
            self.write(f"out/{name}/{file}.json", json.dumps(content))

    def page(self, reproduction=None):
        arguments = [str(self.tree / "out")]
        if reproduction:
            arguments += ["--reproduction", str(self.write("shipped.json", json.dumps(reproduction)))]
        text = io.StringIO()
        with contextlib.redirect_stdout(text):
            inference_page.main(arguments)
        return text.getvalue()


class Page(PageTest):
    def test_bodies_that_were_not_run_are_named(self):
        self.store("probes", inference())
        self.assertIn("**Not run for this page: *hand_2* and *hand_3*.**", self.page())
        self.assertNotIn("## hand_2", self.page())
        (self.tree / "out/probes/inference.json").unlink()
        page = self.page()
        self.assertIn("*probes*, *hand_2* and *hand_3*", page)
        self.assertIn("No inference was run for this page.", page)

    def test_each_claim_has_its_shares_and_both_verdicts(self):
        self.store("probes", inference())
        rows = [line for line in self.page(shipped()).splitlines() if line.startswith("| press: It")]
        self.assertEqual(rows, [
            "| press: It holds | P11 IV | 75 % | **25 %** | ≥ 0.5 | 0.25 (0.12 to 0.75) | 95 % | 50 % | 10 % | fails | holds | explained |",
            "| press: It is half | P11 IV | 75 % | **50 %** | ≥ 0.5 | 0.25 (0.12 to 0.75) | 25 % | – | 10 % | fails; as written: compatible | "
            "fails; as written: compatible | reachable |",
            "| press: It never holds | P11 IV | 75 % | **0 %** | ≤ 1 | – | 0 % | 50 % | – | mostly | fails | excluded |"])

    def test_without_a_reproduction_nothing_is_said_of_the_shipped_body(self):
        self.store("probes", inference())
        page = self.page()
        self.assertIn("| press: It holds | P11 IV | – | **25 %** |", page)
        self.assertIn("| probes | 3 | 1 | – | 1 | – | 2 | 1 | 1 | 1 | 0 |", page)
        self.assertIn("The results of the shipped bodies were not given", page)

    def test_the_joint_number_counts_claims_of_papers_of_all_bodies(self):
        self.store("probes", inference())
        others = [{**one, "system": "hand"} for one in CLAIMS]
        self.store("hand_3", inference(claims=others))
        result = shipped()
        result["claims"] += [{**one, "system": "hand"} for one in result["claims"][:3]]
        page = self.page(result)
        self.assertIn("| probes | 3 | 1 | 1 | 1 | 2 | 2 | 1 | 1 | 1 | 0 |", page)
        self.assertIn("| **together** | 6 | 2 | 2 | 2 | 4 | 4 | 2 | 2 | 2 | 0 |", page)
        self.assertIn("2 of 6 claims do not fail", page)
        self.assertIn("as the texts are written, 4.", page)
        self.assertIn("has 8 claims of papers; 2 of them are judged by no inference", page)

    def test_the_distribution_over_bodies_is_that_of_the_prior_and_the_fresh_ones(self):
        self.store("probes", inference())
        page = self.page()
        self.assertIn("2.0 of 4 claims on *probes* (from 1.1 to 2.9 in 90 % of the bodies), and 2.2 with its posterior", page)
        self.assertIn("| probes | prior | 4 | 3 | 2.0 | 1.0 | 1.1 | 2.0 | 2.9 | 3.0 |", page)

    def test_excluded_claims_are_listed_and_few_draws_decide_nothing(self):
        self.store("probes", inference())
        self.assertIn("Claims that are excluded:\n\n- press: It never holds", self.page())
        undecided = [{**one, "support": "not decided"} if one["support"] == "excluded" else one for one in CLAIMS]
        self.store("probes", inference(draws=999, claims=undecided))
        page = self.page()
        self.assertIn("not decided because there are 999 draws; 1000 are needed", page)
        self.assertIn("Claims that are not decided:\n\n- press: It never holds", page)

    def test_unknowns_dependences_conflicts_and_calibration(self):
        self.store("probes", inference())
        page = self.page()
        self.assertIn("| `rate` | 0.3 | 2 (1 to 3) | 2 (1 to 3) | 0.50 | 88 % | 0.4 |", page)
        self.assertIn("| `order` | 0.3 | once (50 %) | each (60 %) | 0.95 | 60 % | 0.04 |", page)
        self.assertIn("say something about `rate` (0.50). 1 of 2 unknowns have a width above 0.9", page)
        self.assertIn("`rate` and `order` (-0.31)", page, "0.3 is three standard deviations of 100")
        self.assertIn("| press: A | press, small: B | 26 | 55 | -4.3 |", page)
        self.assertIn("contain 74 % of them on average over 2 unknowns, from 60 % to 88 %", page)
        self.assertIn("1 lie from 80 % to 97 %. Ranks deviate from uniform ones with p < 0.05 for 1 of 2", page)
        self.store("probes", inference(dependences=[], conflicts=[]))
        page = self.page()
        self.assertIn("No two unknowns depend on each other", page)
        self.assertIn("No pair of claims holds together less often", page)

    def test_names_and_few_numbers_have_a_most_frequent_value_and_many_numbers_a_median(self):
        few = [cell(bits, bits, 0.25, share) for bits, share in ((8, 0.1), (10, 0.2), (12, 0.3), (16, 0.4))]
        many = [*few, cell(18, 18, 0, 0)]
        names = [cell(str(i), str(i), 0.2, 0.2) for i in range(5)]
        self.store("probes", inference(unknowns=[unknown("rate", 1, few), unknown("order", 1, many)]))
        page = self.page()
        self.assertIn("| `rate` | 0.3 | 8 (25 %) | 16 (40 %) |", page)
        self.assertIn("| `order` | 0.3 | 2 (1 to 3) | 2 (1 to 3) |", page)
        self.store("probes", inference(unknowns=[unknown("rate", 1, few), unknown("order", 1, names)]))
        self.assertIn("| `order` | 0.3 | 0 (20 %) | 0 (20 %) |", self.page())

    def test_durations_and_held_out_accuracies_are_those_measured(self):
        self.store("probes", inference())
        self.assertIn("Its duration was not measured", self.page())
        self.assertIn("--only probes --held-out 5", self.page())
        self.store("probes", inference(), seconds={"seconds": 90, "processor_seconds": 600})
        for body, accuracies in (("01", [0.4, 0.6]), ("02", [0.6, 0.8])):
            results = shipped()
            results["parts"][0]["protocols"][0]["metrics"]["accuracy"]["values"] = accuracies
            self.write(f"out/probes/held_out/{body}/results.json", json.dumps(results))
        page = self.page(shipped())
        self.assertIn("Duration: 90 seconds, 10 minutes of processor time", page)
        self.assertIn("| press | 5 folds | material | 0.600 ± 0.141 | 0.800 ± 0.000 | 0.600 | 0.800 |", page)

    def test_a_page_of_other_results_is_refused(self):
        self.store("probes", inference())
        page = self.write("page.md", self.page())
        inference_page.main([str(self.tree / "out"), "--check", str(page)])
        page.write_text("another", encoding="utf-8")
        with self.assertRaises(SystemExit):
            inference_page.main([str(self.tree / "out"), "--check", str(page)])
        with self.assertRaisesRegex(SystemExit, "is not a folder"):
            inference_page.main([str(self.tree / "none")])


class Study(TreeTest):
    def test_the_commands_are_those_of_the_first_comment(self):
        commands = inference_study.commands_of(COMMENT)
        self.assertEqual([command[0] for command in commands], ["explore", "sweep"])
        self.assertEqual(inference_study.moved(commands[0], "/x")[-1], "/x/stock.mcap")
        self.assertEqual(inference_study.moved(commands[1], "/x")[4:], ["--targets", "a b.toml", "--out", "/x/press"])

    def test_every_prior_of_this_tree_has_commands_and_targets(self):
        for name in inference_study.names_of_inferences():
            text = (TREE / "systems/inference" / f"{name}.toml").read_text(encoding="utf-8")
            command = inference_study.commands_of(text)[-1]
            self.assertEqual(command[0], "sweep", name)
            self.assertIn(f"systems/inference/{name}_targets.toml", command)
            self.assertIn(f"out/inference/{name}", command)

    def test_a_study_keeps_the_seconds_of_its_parts(self):
        file = self.tree / "probes/seconds.json"
        inference_study.timed(lambda: None, file)
        file.write_text('{"seconds": 100, "processor_seconds": 50}', encoding="utf-8")
        with self.assertRaises(KeyError):
            inference_study.timed(lambda: {}["interrupted"], file)
        kept = json.loads(file.read_text(encoding="utf-8"))
        self.assertTrue(100 < kept["seconds"] < 101 and 50 <= kept["processor_seconds"] < 51, kept)

    def test_the_program_runs_the_commands_in_the_folder(self):
        calls = self.tree / "calls"
        program = self.write("program.sh", f'#!/bin/sh\necho "$@" >> {calls}\nexit 3\n')
        program.chmod(0o755)
        with self.assertRaises(inference_study.subprocess.CalledProcessError):
            inference_study.main(["--out", str(self.tree / "out"), "--only", "probes", "--program", str(program)])
        self.assertIn(f"--out {self.tree}/out/probes\n", calls.read_text(encoding="utf-8"))
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaisesRegex(SystemExit, "'foot' is not one of probes"):
            inference_study.main(["--out", "x", "--only", "foot"])

    def test_held_out_protocols_replace_those_of_the_draws(self):
        text = '[study]\nname = "press"\nprotocols = ["train_is_test"]\ngroups = []\n[explore]\nprotocols = ["a"]\n'
        self.assertEqual(
            inference_study.with_protocols(text, {"protocols": ["train_is_test", "leave_group_out"], "groups": ["trial"]}),
            '[study]\nname = "press"\nprotocols = ["train_is_test", "leave_group_out"]\ngroups = ["trial"]\n[explore]\n'
            'protocols = ["a"]\n')


if __name__ == "__main__":
    unittest.main()
