#!/usr/bin/env python3
"""Writes docs/inference.md from the results of inference_study.py.

    scripts/inference_page.py out/inference --reproduction out/reproduction/results.json > docs/inference.md

OUT/NAME contains inference.json, for each inference NAME of systems/inference that was run. Without --reproduction the columns
of the shipped body are empty. With --check FILE nothing is written; the script fails if FILE differs
from the page generated from the results.

The generated tables are inserted into the text of scripts/inference_page.md.in, with the remarks of
scripts/inference_remarks.md.in.
"""

import argparse
import json
import math
import pathlib
import statistics
import sys

import inference_study
import reproduction_page
import result_tables as tables

HERE = pathlib.Path(__file__).resolve().parent
TEMPLATE = HERE / "inference_page.md.in"
REMARKS = HERE / "inference_remarks.md.in"
SUPPORTS = ("explained", "reachable", "excluded", "not decided")
DECIDING_DRAWS = 1000  # kDecidingDraws of src/studies/inference/claim_support.h
OPEN = ("fails", "cannot be decided here")  # verdicts of claims that fail or are open
INTERVAL = 0.9  # the share of truths that a central interval should contain
GOOD_COVER = (0.80, 0.97)
NARROW, OPEN_WIDTH = 0.8, 0.9  # widths below which values say something, above which next to nothing
MOSTLY = 0.5  # kMostlyFrom of include/somato/studies/claim.h: a claim that holds in fewer maps fails
MOST_LISTED = 4  # numbers in a list, of which the most frequent is named
DEVIATIONS = 3  # of a correlation by chance


class Inference:
    """The results of one inference, with those of the shipped body, if they are known."""

    def __init__(self, name, folder, shipped):
        self.name = name
        self.data = json.loads((folder / "inference.json").read_text(encoding="utf-8"))
        seconds = folder / "seconds.json"
        self.seconds = json.loads(seconds.read_text(encoding="utf-8")) if seconds.exists() else None
        self.held_out = [tables.load_results(file) for file in sorted(folder.glob("held_out/*/results.json"))]
        self.shipped = {key_of(claim): claim for claim in shipped["claims"]} if shipped else {}
        self.of_papers = [claim for claim in self.data["claims"] if claim["paper"]]

    def shipped_claim(self, claim):
        return self.shipped.get(key_of(claim))


def key_of(claim):
    return tuple(claim[key] for key in ("question", "system", "variation", "text", "protocol", "group"))


def has_not_failed(verdict):
    return verdict is not None and verdict not in OPEN


def as_written(claim):
    return claim.get("as_written", claim)["verdict"]


def quantile(values, share):
    """The value at a share of the sorted values, by linear interpolation."""
    ordered = sorted(values)
    place = share * (len(ordered) - 1)
    low = ordered[math.floor(place)]
    return low + (place - math.floor(place)) * (ordered[math.ceil(place)] - low)


# All claims together


def not_failing(inference):
    """Numbers of the claims of papers that do not fail: in the prior, shipped, fresh, and the latter two as written."""
    shipped = [inference.shipped_claim(claim) for claim in inference.of_papers]
    known = all(shipped) and bool(shipped)
    claims = inference.of_papers
    return {"claims": len(claims),
            "prior": sum(claim["prior"] is not None and claim["prior"] >= MOSTLY for claim in claims),
            "shipped": sum(has_not_failed(claim["verdict"]) for claim in shipped) if known else None,
            "shipped as written": sum(has_not_failed(as_written(claim)) for claim in shipped) if known else None,
            "fresh": sum(has_not_failed(claim["fresh_verdict"]) for claim in claims),
            "fresh as written": sum(has_not_failed(claim["fresh_verdict_as_written"]) for claim in claims)}


def supports(claims):
    return [sum(claim["support"] == support for claim in claims) for support in SUPPORTS]


def added(counts):
    return None if None in counts else sum(counts)


def joint_table(inferences):
    counts = [not_failing(inference) for inference in inferences]
    columns = ["claims", "prior", "shipped", "fresh", "shipped as written", "fresh as written"]
    rows = [[inference.name, *(tables.number(count[column]) for column in columns), *supports(inference.of_papers)]
            for inference, count in zip(inferences, counts)]
    every = [claim for inference in inferences for claim in inference.of_papers]
    rows.append(["**together**", *(tables.number(added([count[column] for count in counts])) for column in columns),
                 *supports(every)])
    heads = ["body", "claims of papers", "hold in half of the prior's maps", "do not fail, shipped", "do not fail, posterior", "as written, shipped",
             "as written, posterior", *SUPPORTS]
    return tables.table(heads, rows)


def prior_sentence(inferences):
    """The main result: how many claims hold in a pair of a body of the prior."""
    texts = []
    for inference in inferences:
        joint = inference.data["joint"]
        low, high = (quantile(joint["prior"]["sums"], share) for share in (0.05, 0.95))
        texts.append(f"{joint['prior']['mean']:.1f} of {joint['claims']} claims on *{inference.name}* (from {low:.1f} to {high:.1f} in 90 % of "
                     f"the bodies), and {joint['fresh']['mean']:.1f} with its posterior")
    return f"In a pair of a body of the prior hold {tables.listing(texts)}."


def joint_sentence(inferences, shipped):
    judged = {key_of(claim) for inference in inferences for claim in inference.of_papers}
    count = [not_failing(inference) for inference in inferences]
    fresh, written = (sum(one[key] for one in count) for key in ("fresh", "fresh as written"))
    sentence = (f"{prior_sentence(inferences)} With one posterior for each body, {fresh} of {tables.counted(len(judged), 'claim')} do not fail on all fresh maps "
                f"together; as the texts are written, {written}.")
    if not shipped:
        return f"{sentence} The results of the shipped bodies were not given for this page."
    every = [claim for claim in shipped["claims"] if claim["paper"]]
    others = [claim for claim in every if key_of(claim) not in judged]
    return (f"{sentence} The reproduction has {tables.counted(len(every), 'claim')} of papers; {len(others)} of them are judged by no "
            f"inference of this page (bodies that were not run, side questions and other protocols). With the shipped bodies "
            f"{sum(has_not_failed(claim['verdict']) for claim in others)} of these do not fail, as written "
            f"{sum(has_not_failed(as_written(claim)) for claim in others)}.")


def distribution_table(inferences):
    """The number of claims that hold in a pair, over the settings of the prior and the posterior."""
    rows = []
    for inference in inferences:
        joint = inference.data["joint"]
        for title, part in (("prior", joint["prior"]), ("posterior, fresh", joint["fresh"])):
            sums = part["sums"]
            ends = [f"{quantile(sums, share):.1f}" for share in (0, 0.05, 0.5, 0.95, 1)] if sums else ["–"] * 5
            rows.append([inference.name, title, joint["claims"], part["bodies"], f"{part['mean']:.1f}", *ends])
    return tables.table(["body", "settings", "claims", "number of settings", "mean", "least", "5 %", "median", "95 %",
                         "greatest"], rows)


def joint_section(inferences, shipped):
    if not inferences:
        return "No inference was run for this page."
    text = ("The number of claims that hold in a pair of recording and seed, over the settings: the claims are counted for each "
            "setting by itself, so that one body has to meet all of them.")
    return "\n\n".join([joint_sentence(inferences, shipped), joint_table(inferences), text, distribution_table(inferences)])


# One body


def minutes(seconds):
    return f"{seconds / 60:.0f} minutes" if seconds >= 120 else f"{seconds:.0f} seconds"


def size_sentence(inference):
    data = inference.data
    adjusted = "adjusted by a regression" if data["adjusted"] else "not adjusted, since they are too few for the regression"
    text = (f"{tables.counted(data['draws'], 'draw')} with {tables.counted(data['pairs'], 'map')} of each system; the "
            f"{data['accepted']} nearest to {tables.counted(len(data['targets']), 'printed value')} are accepted, {adjusted}. "
            f"Fresh: {tables.counted(data['inference']['bodies'], 'body').replace('bodys', 'bodies')}, "
            f"{tables.counted(data['inference']['pairs'], 'pair')} each.")
    if not inference.seconds:
        return f"{text} Its duration was not measured."
    return (f"{text} Duration: {minutes(inference.seconds['seconds'])}, {minutes(inference.seconds['processor_seconds'])} "
            f"of processor time.")


def claim_table(inference):
    rows = []
    for claim in inference.data["claims"]:
        shipped = inference.shipped_claim(claim)
        rows.append([f"{tables.subject(claim)}: {tables.cell(claim['text'])}", claim["paper"] or "ours",
                     tables.percent(shipped["share"]) if shipped else "–", f"**{tables.percent(claim['prior'])}**",
                     tables.range_text(claim), values_text(claim),
                     tables.percent(claim["fresh"]), tables.percent(claim["left_out"]), tables.percent(claim["fresh_chance"]),
                     verdicts(shipped and shipped["verdict"], shipped and as_written(shipped)),
                     verdicts(claim["fresh_verdict"], claim["fresh_verdict_as_written"]), claim["support"]])
    return tables.table(["claim", "paper", "shipped", "prior", "required", "values", "fresh", "without it", "by chance", "verdict, shipped",
                         "verdict, fresh", "support"], rows)


def values_text(claim):
    """The median of the values in the maps of all draws, with their ends: how far a claim is out of reach."""
    values = claim.get("values")
    if not values:
        return "–"
    least, median, greatest = (tables.rounded(values[name]) for name in ("least", "median", "greatest"))
    return f"{median} ({least} to {greatest})"


def verdicts(first, written):
    """The verdict, and the one as the text is written if it differs."""
    if first is None:
        return "–"
    return first if written in (None, first) else f"{first}; as written: {written}"


def support_sentence(inference):
    counts = ", ".join(f"*{support}*: {count}" for support, count in zip(SUPPORTS, supports(inference.data["claims"])))
    text = f"Of {tables.counted(len(inference.data['claims']), 'claim')}, {counts}. {open_sentence(inference)}".rstrip()
    return "\n\n".join([text, *(named_claims(inference, support) for support in ("excluded", "not decided"))]).rstrip()


def named_claims(inference, support):
    """A list of the claims with a support, or nothing."""
    found = [claim for claim in inference.data["claims"] if claim["support"] == support]
    lines = [f"- {tables.subject(claim)}: {tables.cell(claim['text'])}" for claim in found]
    return "\n".join([f"Claims that are {support}:", "", *lines]) if lines else ""


def open_sentence(inference):
    draws = inference.data["draws"]
    if draws >= DECIDING_DRAWS or not any(claim["support"] == "not decided" for claim in inference.data["claims"]):
        return ""
    return f"Claims are not decided because there are {draws} draws; {DECIDING_DRAWS} are needed to exclude one."


def target_table(inference):
    rows = [[f"{tables.subject(target)}: {tables.cell(target['text'])}", target["paper"], tables.number(target["observed"]),
             tables.rounded(target["prior"]), tables.rounded(target["posterior"]), tables.number(target["scale"])]
            for target in inference.data["targets"]]
    return tables.table(["printed value", "paper", "printed", "mean of the prior", "mean of the accepted maps", "scale"], rows)


def conflict_table(inference):
    def name(claim):
        return f"{tables.subject(claim)}: {tables.cell(claim['text'])}"

    found = inference.data["conflicts"]
    if not found:
        return "No pair of claims holds together less often than expected, by more than three standard deviations."
    rows = [[name(one["first"]), name(one["second"]), f"{one['together']:.0f}", f"{one['expected']:.0f}",
             f"{one['deviations']:.1f}"] for one in found]
    return tables.table(["claim", "claim", "maps with both", "expected", "standard deviations"], rows)


def most_frequent(unknown, which):
    best = max(unknown["cells"], key=lambda one: one[which])
    return f"{tables.cell_text(best)} ({tables.percent(best[which])})"


def is_listed(cells):
    """Whether a single value says more than the median: for names and few numbers."""
    is_ordered = all(isinstance(cell["from"], (int, float)) and not isinstance(cell["from"], bool) for cell in cells)
    return all(cell["from"] == cell["to"] for cell in cells) and (not is_ordered or len(cells) <= MOST_LISTED)


def values_cell(unknown, which):
    if is_listed(unknown["cells"]):
        return most_frequent(unknown, which)
    ends = unknown[which]
    return f"{tables.value_text(ends['median'])} ({tables.value_text(ends['low'])} to {tables.value_text(ends['high'])})"


def unknown_table(inference):
    calibrated = {one["name"]: one for one in inference.data["calibration"]["unknowns"]}
    rows = [[f"`{unknown['name']}`", tables.cell(unknown["system"]), values_cell(unknown, "prior"),
             values_cell(unknown, "posterior"), f"{unknown['shrinkage']:.2f}",
             tables.percent(calibrated[unknown["name"]]["covered"]), tables.rounded(calibrated[unknown["name"]]["uniform_p"])]
            for unknown in inference.data["unknowns"]]
    return tables.table(["unknown", "shipped", "prior, median (5 to 95 %)", "posterior, median (5 to 95 %)", "width",
                         "truths in 90 %", "uniform, p"], rows)


def names_with(unknowns, is_one):
    return [f"`{unknown['name']}` ({unknown['shrinkage']:.2f})" for unknown in unknowns if is_one(unknown["shrinkage"])]


def unknown_sentence(inference):
    unknowns = sorted(inference.data["unknowns"], key=lambda unknown: unknown["shrinkage"])
    narrow = names_with(unknowns, lambda width: width < NARROW)
    still_open = names_with(unknowns, lambda width: width > OPEN_WIDTH)
    said = f"The printed values say something about {tables.listing(narrow)}." if narrow else \
        f"The printed values determine no unknown: no width is below {NARROW:g}."
    return f"{said} {len(still_open)} of {tables.counted(len(unknowns), 'unknown')} have a width above {OPEN_WIDTH:g}: they are as open as before."


def dependence_sentence(inference):
    limit = DEVIATIONS / math.sqrt(max(inference.data["accepted"], 1))
    strong = [one for one in inference.data["dependences"] if abs(one["correlation"]) >= limit]
    if not strong:
        return f"No two unknowns depend on each other in the posterior (no correlation reaches {DEVIATIONS} standard deviations by chance, {limit:.2f})."
    strong.sort(key=lambda one: -abs(one["correlation"]))
    pairs = [f"`{one['first']}` and `{one['second']}` ({one['correlation']:+.2f})" for one in strong]
    return f"Unknowns that depend on each other in the posterior (correlation of at least {limit:.2f}, {DEVIATIONS} standard deviations by chance): {tables.listing(pairs)}."


def calibration_sentence(inference):
    calibration = inference.data["calibration"]
    unknowns, truths = calibration["unknowns"], calibration["truths"]
    covered = [one["covered"] for one in unknowns]
    good = sum(GOOD_COVER[0] <= share <= GOOD_COVER[1] for share in covered)
    small = sum(one["uniform_p"] < 0.05 for one in unknowns)
    deviation = math.sqrt(INTERVAL * (1 - INTERVAL) / truths)
    return (f"With {tables.counted(truths, 'truth')}, the central 90 % intervals contain {tables.percent(statistics.mean(covered))} of them on "
            f"average over {tables.counted(len(unknowns), 'unknown')}, from {tables.percent(min(covered))} to {tables.percent(max(covered))} "
            f"(a single share has the standard deviation {deviation:.2f}); {good} lie from {tables.percent(GOOD_COVER[0])} to "
            f"{tables.percent(GOOD_COVER[1])}. Ranks deviate from uniform ones with p < 0.05 for {small} of {len(unknowns)}, where "
            f"{0.05 * len(unknowns):.1f} are expected by chance; the smallest p is {min(one['uniform_p'] for one in unknowns):.2g}.")


def held_out_table(inference, shipped):
    """Accuracies of held-out explorations and their nearest neighbours, over the tested bodies."""
    found = {}
    for results in inference.held_out:
        for key, values in accuracies(results):
            found.setdefault(key, []).append(values)
    own = dict(accuracies(shipped)) if shipped else {}
    rows = [[*key, *(tables.spread([one[i] for one in bodies]) for i in (0, 1)),
             *(f"{own[key][i]:.3f}" if key in own else "–" for i in (0, 1))] for key, bodies in found.items()]
    return tables.table(["system", "protocol", "label", "accuracy, posterior", "nearest neighbour, posterior",
                         "accuracy, shipped", "nearest neighbour, shipped"], rows)


def accuracies(results):
    """For each protocol of each unchanged system: its names, mean accuracy and mean of the nearest neighbour."""
    for part in reproduction_page.unchanged(results):
        for protocol in part["protocols"]:
            prefix, label = reproduction_page.label_prefix(protocol)
            values = [reproduction_page.metric(protocol, prefix + name) for name in reproduction_page.MAIN]
            if all(values):
                yield (part["system"], tables.protocol_text(protocol), label), [statistics.mean(one) for one in values]


def held_out_section(inference, shipped):
    if not inference.held_out:
        return ("Held-out accuracies of posterior bodies were not measured for this page: draws and fresh maps have the papers' protocol only. "
                f"`scripts/inference_study.py --out out/inference --only {inference.name} --held-out 5` measures them.")
    return (f"Mean ± standard deviation over {len(inference.held_out)} posterior bodies; what else changes with the body:\n\n"
            f"{held_out_table(inference, shipped)}")


def body_section(inference, shipped):
    parts = [f"## {inference.name}", f"Systems: {tables.listing(inference.data['systems'])}. {size_sentence(inference)}",
             "### Claims", support_sentence(inference), claim_table(inference), "{{remarks claims}}",
             "### Printed values", target_table(inference),
             "### Conflicts", "{{remarks conflicts}}", conflict_table(inference),
             "### Unknowns", unknown_sentence(inference), unknown_table(inference), "{{remarks unknowns}}",
             dependence_sentence(inference),
             "### Calibration", calibration_sentence(inference), "{{remarks calibration}}",
             "### What else changes", held_out_section(inference, shipped)]
    # Every body has its own headings, so that links are unique.
    return "\n\n".join(f"{part} of {inference.name}" if part.startswith("### ") else part for part in parts)


def not_run_sentence(names, inferences):
    missing = [f"*{name}*" for name in names if name not in {inference.name for inference in inferences}]
    return f"**Not run for this page: {tables.listing(missing)}.**" if missing else ""


def make_page(inferences, names, shipped):
    template = TEMPLATE.read_text(encoding="utf-8")
    filled = {"not run": not_run_sentence(names, inferences), "joint": joint_section(inferences, shipped),
              "bodies": "\n\n".join(body_section(inference, shipped) for inference in inferences)}
    for key, value in filled.items():
        template = template.replace("{{" + key + "}}", value)
    return reproduction_page.put_remarks(template, REMARKS.read_text(encoding="utf-8"), TEMPLATE).rstrip() + "\n"


def load(out, names, shipped):
    return [Inference(name, out / name, shipped) for name in names if (out / name / "inference.json").exists()]


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", type=pathlib.Path, help="folder of inference_study.py")
    parser.add_argument("--reproduction", type=pathlib.Path, help="results.json of the shipped bodies")
    parser.add_argument("--check", type=pathlib.Path, help="fail if this page differs from the generated one")
    given = parser.parse_args(arguments)
    if not given.results.is_dir():
        sys.exit(f"inference_page: {given.results} is not a folder")
    shipped = tables.load_results(given.reproduction) if given.reproduction else None
    names = list(dict.fromkeys([*inference_study.BODIES, *inference_study.names_of_inferences()]))
    tables.print_or_check(make_page(load(given.results, names, shipped), names, shipped), given)


if __name__ == "__main__":
    main()
