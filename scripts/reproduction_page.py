#!/usr/bin/env python3
"""Writes docs/reproduction.md from the results.json of `somato reproduce`.

    scripts/reproduction_page.py out/reproduction/results.json > docs/reproduction.md

Around the tables made here stand the texts of scripts/reproduction_page.md.in, and the remarks of
scripts/reproduction_remarks.md.in, which name no figures: those come from the results.
"""

import argparse
import json
import pathlib
import re
import statistics

TEMPLATE = pathlib.Path(__file__).parent / "reproduction_page.md.in"
MAIN = ("accuracy", "baseline_accuracy")


def spread(values, digits=3):
    deviation = statistics.stdev(values) if len(values) > 1 else 0.0
    return f"{statistics.mean(values):.{digits}f} ± {deviation:.{digits}f}"


def metric(protocol, name):
    found = protocol["metrics"].get(name)
    return found["values"] if found else None


def label_prefix(protocol):
    """Of the system's own label, or where that cannot be named, of the first that can."""
    for name in protocol["metrics"]:
        if name == "accuracy":
            return "", protocol["label"]
        if name.endswith(".accuracy"):
            return name[: -len("accuracy")], name[: -len(".accuracy")]
    return "", protocol["label"]


def protocol_text(protocol):
    return {
        ("train_is_test", ""): "train = test",
        ("leave_group_out", "trial"): "5 folds",
        ("test_data", ""): "new objects",
    }.get(
        (protocol["protocol"], protocol.get("group", "")),
        protocol["protocol"].replace("leave_group_out", "leave out") + " " + protocol.get("group", ""),
    )


def subject(part):
    return f"{part['system']}, {part['variation']}" if part["variation"] else part["system"]


def accuracy_rows(parts, protocols=None):
    rows = ["| system | protocol | asked | accuracy | nearest neighbour |", "|---|---|---|---|---|"]
    for part in parts:
        for protocol in part["protocols"]:
            text = protocol_text(protocol)
            if protocols and text not in protocols:
                continue
            prefix, label = label_prefix(protocol)
            values = [metric(protocol, prefix + name) for name in MAIN]
            cells = [spread(v) if v else "–" for v in values]
            rows.append(f"| {subject(part)} | {text} | {label} | {' | '.join(cells)} |")
    return "\n".join(rows)


def area_rows(parts):
    """Measures read off the papers' own kind of map, beside what luck gives."""
    names = ["individuals_apart", "areas_connected", "told_exactly", "undetermined", "with_own"]
    rows = ["| system | asked | " + " | ".join(n.replace("_", " ") for n in names) + " |",
            "|---|---|" + "---|" * len(names)]
    for part in parts:
        protocol = part["protocols"][0]
        if protocol["protocol"] != "train_is_test":
            continue
        prefixes = [""] + sorted({n.split(".")[0] + "." for n in protocol["metrics"] if "." in n})
        for prefix in prefixes:
            cells = []
            for name in names:
                values = metric(protocol, prefix + name)
                luck = metric(protocol, prefix + name + "_by_luck")
                cell = f"{statistics.mean(values):.2f}" if values else "–"
                if luck:
                    cell += f" ({statistics.mean(luck):.2f})"
                cells.append(cell)
            label = prefix[:-1] or protocol["label"]
            rows.append(f"| {subject(part)} | {label} | {' | '.join(cells)} |")
    return "\n".join(rows)


def verdict(share):
    if share >= 0.95:
        return "holds"
    if share >= 0.5:
        return "mostly"
    return "sometimes" if share > 0.05 else "does not hold"


def number(value):
    return "–" if value is None else f"{value:g}"


def bounds(claim):
    what = f"`{claim['metric']}`"
    if "than_system" in claim:
        than = claim["than_system"]
        if claim["than_variation"]:
            than += ", " + claim["than_variation"]
        what += f" less that of {than}"
    if claim["at_least"] is not None:
        what += f" ≥ {number(claim['at_least'])}"
    if claim["at_most"] is not None:
        what += f" ≤ {number(claim['at_most'])}"
    return what


def claim_rows(claims):
    rows = ["| claim | paper | measured by | published | measured | by luck | holds in |",
            "|---|---|---|---|---|---|---|"]
    for claim in claims:
        who = claim["system"] + (", " + claim["variation"] if claim["variation"] else "")
        under = protocol_text(claim)
        measured = f"{claim['mean']:.2f} ± {claim['sd']:.2f}"
        rows.append(
            f"| {who}: {claim['text']} | {claim['paper'] or 'ours'} | {bounds(claim)}, {under} | "
            f"{number(claim['published'])} | {measured} | {number(round_or_none(claim['by_luck']))} | "
            f"{100 * claim['share']:.0f} % of {claim['pairs']}: {verdict(claim['share'])} |")
    return "\n".join(rows)


def round_or_none(value):
    return None if value is None else round(value, 2)


def recordings_of(results, parts):
    names = {name for part in parts for name in part["recordings"]}
    return [r for r in results["recordings"] if r["name"] in names]


def questions(results):
    texts = []
    names = list(dict.fromkeys(p["question"] for p in results["systems"] if p["question"]))
    for name in names:
        parts = [p for p in results["systems"] if p["question"] == name]
        claims = [c for c in results["claims"] if c["question"] == name]
        texts.append(f"### {name.replace('_', ' ')}\n\n{{{{question {name}}}}}\n")
        texts.append(f"{len(parts[0]['pairs'])} pairs each.\n")
        texts.append(accuracy_rows(parts, ("5 folds",) if name == "sensitivity" else None))
        if claims:
            texts.append("\n" + claim_rows(claims))
        texts.append("")
    return "\n".join(texts)


def fill(template, results):
    systems = [p for p in results["systems"] if not p["question"]]
    own = [c for c in results["claims"] if not c["question"]]
    held = sum(c["share"] >= 0.95 for c in results["claims"] if c["paper"])
    never = sum(c["share"] <= 0.05 for c in results["claims"] if c["paper"])
    asked = sum(bool(c["paper"]) for c in results["claims"])
    page = template
    for key, value in {
        "pairs": str(results["pairs"]),
        "seed": str(results["seed"]),
        "recordings": str(max(len(p["recordings"]) for p in systems)),
        "claims_of_papers": str(asked),
        "claims_hold": str(held),
        "claims_never": str(never),
        "claims": claim_rows(own),
        "accuracies": accuracy_rows(systems),
        "areas": area_rows(systems),
        "questions": questions(results),
    }.items():
        page = page.replace("{{" + key + "}}", value)
    return page


def remarks(page, file):
    """What is said about questions and tables: `## name` and what follows, in a file of its own."""
    sections = file.read_text(encoding="utf-8").split("\n## ")[1:] if file.exists() else []
    known = dict(section.split("\n", 1) for section in sections)
    for kind in ("question ", "remarks "):
        for name, text in known.items():
            page = page.replace("{{" + kind + name + "}}", text.strip())
    left = re.findall(r"\{\{.*?\}\}", page)
    if left:
        raise SystemExit(f"{file}: nothing is said about {', '.join(left)}")
    return page


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", type=pathlib.Path, help="results.json of somato reproduce")
    arguments = parser.parse_args()
    results = json.loads(arguments.results.read_text(encoding="utf-8"))
    page = fill(TEMPLATE.read_text(encoding="utf-8"), results)
    print(remarks(page, TEMPLATE.with_name("reproduction_remarks.md.in")), end="")


if __name__ == "__main__":
    main()
