#!/usr/bin/env python3
"""Writes docs/announced.md from the results of `somato reproduce announced`.

    scripts/announced_page.py out/announced/results.json > docs/announced.md

Several results, such as those of single questions that ran on different machines, can be given instead.
The tables of each question replace {{question NAME}} in scripts/announced_page.md.in, those of a system that
ran on given recordings {{system NAME}}. With --check FILE
nothing is written; the script fails if FILE differs from the page generated from the results.
"""

import argparse
import pathlib
import re

import reproduction_page
import result_tables as tables

HERE = pathlib.Path(__file__).resolve().parent
TEMPLATE = HERE / "announced_page.md.in"
FILES = HERE.parent / "systems" / "announced"
PICTURES = HERE.parent / "docs" / "pictures" / "announced"
ALTERED = "altered."
PREDICTED = ("prediction_error", "prediction_error_of_mean", "prediction_error_of_nearest", "strongest_right",
             "strongest_right_of_preceding", "strongest_right_chance", "strongest_distance",
             "strongest_distance_of_preceding", "steps_right")


def parts_of(kind, name, results):
    if kind == "question":
        return [part for part in results["parts"] if part["question"] == name]
    return [part for part in results["parts"] if not part["question"] and part["system"] == name]


def prediction_names(protocol):
    """Names of the associations whose predictions are measured, in their order."""
    found = (re.fullmatch(r"(\w+)\.prediction_error", name) for name in protocol["metrics"])
    return [match[1] for match in found if match]


def prediction_table(parts):
    """Errors of predictions, with those of the values they are compared with; empty without any."""
    rows = []
    for part in parts:
        for protocol in part["protocols"]:
            for name in prediction_names(protocol):
                found = [reproduction_page.metric(protocol, f"{name}.{measure}") for measure in PREDICTED]
                rows.append([tables.subject(part), tables.protocol_text(protocol), name,
                             *(tables.spread(values) if values else "–" for values in found)])
    return tables.table(["system", "protocol", "prediction", *(m.replace("_", " ") for m in PREDICTED)], rows) if rows else ""


def altered_names(protocol):
    """Names of the alterations under which the system's own label is measured, in their order."""
    found = (re.fullmatch(r"altered\.(\w+)\.accuracy", name) for name in protocol["metrics"])
    return [match[1] for match in found if match]


def altered_row(part, protocol, names):
    cells = []
    for name in names:
        values = reproduction_page.metric(protocol, f"{ALTERED}{name}.accuracy")
        nearest = reproduction_page.metric(protocol, f"{ALTERED}{name}.baseline_accuracy")
        cells.append(f"{tables.spread(values)} ({sum(nearest) / len(nearest):.3f})" if values else "–")
    return [tables.subject(part), tables.protocol_text(protocol), *cells]


def altered_table(parts):
    """Accuracy, and that of the nearest neighbour, for altered test explorations; empty without any."""
    rows = []
    names = []
    for part in parts:
        for protocol in part["protocols"]:
            if altered_names(protocol) and protocol["protocol"] != "train_is_test":
                names = names or altered_names(protocol)
                rows.append(altered_row(part, protocol, names))
    if not rows:
        return ""
    return ("Accuracy for altered test explorations (nearest neighbour in brackets):\n\n" +
            tables.table(["system", "protocol", *(name.replace("_", " ") for name in names)], rows))


def files_line(kind, name, parts):
    """Links to the file of the question and of its systems, and the maps of these."""
    systems = dict.fromkeys(part["system"] for part in parts)
    links = [f"[{name}.toml](../systems/announced/{name}.toml)"] if kind == "question" else []
    prefix = f"{name}-" if kind == "question" else ""
    for system in systems:
        folder = "systems/announced" if (FILES / f"{system}.toml").exists() else "systems"
        links.append(f"[{system}.toml](../{folder}/{system}.toml)")
    shown = [f"![{system}](pictures/announced/{prefix}{system}.svg)" for system in systems
             if (PICTURES / f"{prefix}{system}.svg").exists()]
    return "Files: " + tables.listing(links) + ".\n\n" + "\n".join(shown)


def claims_of(kind, name, results):
    if kind == "question":
        return [claim for claim in results["claims"] if claim["question"] == name]
    return [claim for claim in results["claims"] if not claim["question"] and claim["system"] == name]


def section(kind, name, results):
    parts = parts_of(kind, name, results)
    if not parts:
        raise SystemExit(f"the results contain no {kind} '{name}'")
    claims = claims_of(kind, name, results)
    texts = [files_line(kind, name, parts), f"{tables.counted(len(parts[0]['pairs']), 'pair')} each."]
    if claims:
        texts.append(tables.claim_table(claims))
    texts += [reproduction_page.accuracy_table(parts), prediction_table(parts), altered_table(parts),
              reproduction_page.area_table([part for part in parts if not claims or part["variation"] == ""])]
    return "\n\n".join(text for text in texts if text)


def summary(claims):
    papers = [claim for claim in claims if claim["paper"]]
    ours = [claim for claim in claims if not claim["paper"]]
    return (f"Expectations of the papers: {tables.verdict_counts(papers)}.\n\n"
            f"Criteria of this project: {tables.verdict_counts(ours)}.")


def joined(documents):
    """One document with the parts, claims and recordings of all; a question may be in one of them only."""
    results = {"parts": [], "claims": [], "recordings": []}
    known = {}
    for number, document in enumerate(documents):
        for place in {(part["question"], part["question"] or part["system"]) for part in document["parts"]}:
            if known.setdefault(place, number) != number:
                raise SystemExit(f"'{place[1]}' is in two of the results")
        results["parts"] += document["parts"]
        results["claims"] += document["claims"]
        results["recordings"] += [r for r in document["recordings"] if r not in results["recordings"]]
    return results


def make_page(template, results):
    page = template.replace("{{summary}}", summary(results["claims"]))
    page = page.replace("{{provenance}}", reproduction_page.provenance(results))
    named = re.findall(r"\{\{(question|system) (\w+)\}\}", page)
    for part in results["parts"]:
        place = ("question", part["question"]) if part["question"] else ("system", part["system"])
        if place not in named:
            raise SystemExit(f"{TEMPLATE.name} has no place for the {' '.join(place)}")
    for kind, name in named:
        page = page.replace(f"{{{{{kind} {name}}}}}", section(kind, name, results))
    left = re.findall(r"\{\{.*?\}\}", page)
    if left:
        raise SystemExit(f"{TEMPLATE.name}: unknown placeholders {', '.join(left)}")
    return re.sub(r"\n{3,}", "\n\n", page)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", type=pathlib.Path, nargs="+", help="results.json of somato reproduce announced")
    parser.add_argument("--check", type=pathlib.Path, help="fail if this page differs from the generated one")
    given = parser.parse_args(arguments)
    results = joined([tables.load_results(path) for path in given.results])
    given.results = tables.listing([str(path) for path in given.results])
    tables.print_or_check(make_page(TEMPLATE.read_text(encoding="utf-8"), results), given)


if __name__ == "__main__":
    main()
