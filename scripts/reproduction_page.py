#!/usr/bin/env python3
"""Writes docs/reproduction.md from the results of `somato reproduce` and `somato sweep`.

    scripts/reproduction_page.py out/reproduction/results.json --sweeps out/sweeps > docs/reproduction.md

FOLDER/NAME/sweep.json of --sweeps are the sweeps of systems/unknowns. With --check FILE nothing is
written; the script fails if FILE differs from the page generated from the results.

The generated tables are inserted into the text of scripts/reproduction_page.md.in, with the remarks of
scripts/reproduction_remarks.md.in, which contain no figures: those come from the results. A missing
remark is omitted, and so is a remark on a missing table.
"""

import argparse
import hashlib
import json
import pathlib
import re
import statistics
import tomllib

import result_tables as tables

HERE = pathlib.Path(__file__).resolve().parent
TEMPLATE = HERE / "reproduction_page.md.in"
REMARKS = HERE / "reproduction_remarks.md.in"
QUESTIONS = HERE.parent / "systems" / "questions"
MAIN = ("accuracy", "baseline_accuracy")
# Systems whose confusions the papers report.
CONFUSED = ("single_tensor_product", "tensor_chain", "t_mpsom_multiplied", "t_mpsom_added", "texture",
            "hardness", "combined", "bimodal")
AREAS = ("individuals_apart", "areas_connected", "classes_separated", "samples_ambiguous", "neighbours_same_class")


def metric(protocol, name):
    found = protocol["metrics"].get(name)
    return found["values"] if found else None


def label_prefix(protocol):
    """Prefix and name of the system's own label, or of the first label with an accuracy."""
    for name in protocol["metrics"]:
        if name == "accuracy":
            return "", protocol["label"]
        if name.endswith(".accuracy"):
            return name[: -len("accuracy")], name[: -len(".accuracy")]
    return "", protocol["label"]


def accuracy_table(parts, protocols=None):
    """Table for the given protocols, or for all; empty if there are none."""
    rows = []
    for part in parts:
        for protocol in part["protocols"]:
            text = tables.protocol_text(protocol)
            if protocols is not None and text not in protocols:
                continue
            prefix, label = label_prefix(protocol)
            values = [metric(protocol, prefix + name) for name in MAIN]
            rows.append([tables.subject(part), text, label, *(tables.spread(v) if v else "–" for v in values)])
    return tables.table(["system", "protocol", "label", "accuracy", "nearest neighbour"], rows) if rows else ""


def area_cell(protocol, name):
    values, chance = metric(protocol, name), metric(protocol, name + "_chance")
    text = f"{statistics.mean(values):.2f}" if values else "–"
    return text + (f" ({statistics.mean(chance):.2f})" if chance else "")


def area_table(parts):
    """Measures of the maps under the papers' protocol, with the values by chance."""
    rows = []
    for part in parts:
        protocol = tables.find_protocol(part, "train_is_test")
        if not protocol:
            continue
        for prefix in [""] + sorted({n.split(".")[0] + "." for n in protocol["metrics"] if "." in n}):
            rows.append([tables.subject(part), prefix[:-1] or protocol["label"],
                         *(area_cell(protocol, prefix + name) for name in AREAS)])
    return tables.table(["system", "label", *(n.replace("_", " ") for n in AREAS)], rows)


def unchanged(results):
    return [p for p in results["parts"] if not p["question"] and not p["variation"]]


def claim_sections(claims):
    own = [c for c in claims if not c["question"]]
    sections = []
    for title, found in (("Claims of the papers", [c for c in own if c["paper"]]),
                         ("Comparisons by this project", [c for c in own if not c["paper"]])):
        if found:
            sections.append(f"### {title}\n\n{tables.claim_table(found)}")
    return "\n\n".join(sections)


def verdict_sentence(claims):
    papers = [c for c in claims if c["paper"]]
    if not papers:
        return "No claim of the papers was measured."
    pairs = [len(c["values"]) for c in papers]
    sentence = f"Verdicts on {tables.counted(len(papers), 'claim')} of the papers, side questions included, "
    sentence += f"each with at least {tables.counted(min(pairs), 'pair')}: {tables.verdict_counts(papers)}."
    return f"{sentence} {written_sentence(papers)}".rstrip()


def written_sentence(papers):
    """The verdicts by the second measures; empty if there are none."""
    second = [c for c in papers if "as_written" in c]
    if not second:
        return ""
    contradicted = [c for c in papers if "contradicted_by" in c]
    return (f"As written, with the second measures of {tables.counted(len(second), 'claim')}: "
            f"{tables.written_verdict_counts(papers)}. A figure of its paper contradicts "
            f"{tables.counted(len(contradicted), 'claim')}.")


def confusion_sections(results):
    texts = []
    for part in unchanged(results):
        protocol = tables.find_protocol(part, *tables.FOLDS)
        if part["system"] in CONFUSED and protocol:
            texts.append(f"### {part['system']}, {tables.protocol_text(protocol)}\n\n"
                         f"{tables.confusion_table(protocol)}\n\n{tables.greatest_confusions(protocol)}")
    return "\n\n".join(texts) or "No system was run under 5 folds."


def remembered(results):
    """Error rates of the maps on their training explorations."""
    wrong = []
    for part in unchanged(results):
        protocol = tables.find_protocol(part, "train_is_test")
        if part["system"] in CONFUSED and protocol:
            named = [t == p for run in protocol["runs"] for t, p in zip(run["labels"], run["predictions"])]
            wrong.append(f"{part['system']} {100 * named.count(False) / len(named):.1f} %")
    return f"misclassified under train = test: {', '.join(wrong)}" if wrong else "no system was run this way"


def sweep_sections(sweeps):
    texts = []
    for name, sweep in sweeps.items():
        left_out = tables.unjudged(sweep)
        texts.append(f"### {name}: its unknowns\n\n{tables.sweep_size(sweep)}.\n\n{tables.sweep_table(sweep)}")
        if left_out:
            texts.append("Not judged in this sweep: " + "; ".join(left_out) + ".")
    return "\n\n".join(texts) or "No sweep was run for this page."


def question_text(name):
    file = QUESTIONS / f"{name}.toml"
    return tomllib.loads(file.read_text(encoding="utf-8"))["question"]["text"] if file.exists() else ""


def question_section(name, results):
    parts = [p for p in results["parts"] if p["question"] == name]
    claims = [c for c in results["claims"] if c["question"] == name]
    pairs = f"{tables.counted(len(parts[0]['pairs']), 'pair')} each."
    claimed = {tables.protocol_text(c) for c in claims if c["metric"].endswith("accuracy")}
    texts = [f"### {name.replace('_', ' ')}", question_text(name), pairs, f"{{{{question {name}}}}}"]
    if claims:
        texts.append(tables.claim_table(claims))
    texts.append(accuracy_table(parts, claimed if claims else {"5 folds"}))
    if not claims:
        texts.append(area_table(parts))
    return "\n\n".join(text for text in texts if text)


def questions(results):
    names = dict.fromkeys(p["question"] for p in results["parts"] if p["question"])
    return "\n\n".join(question_section(name, results) for name in names) or "No question was run."


def parameters_hash(part):
    text = json.dumps(part["parameters"], sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    return hashlib.sha256(text.encode("utf-8")).hexdigest()[:12]


def provenance(results):
    recordings = tables.table(
        ["recording", "source", "seed", "hash"],
        [[f"`{r['name']}`", tables.cell(r["source"]), r["seed"], f"`{r['hash']}`"] for r in results["recordings"]])
    systems = tables.table(
        ["system", "parameters", "recordings", "pairs", "seeds of training"],
        [[tables.subject(p) + (f" ({p['question']})" if p["question"] else ""), f"`{parameters_hash(p)}`",
          len(p["recordings"]), len(p["pairs"]), f"{p['pairs'][0][1]} to {p['pairs'][-1][1]}"]
         for p in results["parts"]])
    return (f"<details>\n<summary>{tables.counted(len(results['recordings']), 'recording')} and the parameters of "
            f"{tables.counted(len(results['parts']), 'system')} and variations</summary>\n\n"
            f"{recordings}\n\n{systems}\n\n</details>")


def turns(parts):
    """Number of pairs with the same recording, such as '16 or 17'."""
    counts = {sum(pair[0] == r for pair in part["pairs"]) for part in parts for r in range(len(part["recordings"]))}
    return " or ".join(str(count) for count in sorted(counts))


def fill(template, results, sweeps):
    systems = unchanged(results)
    filled = {
        "pairs": str(max(len(p["pairs"]) for p in systems)),
        "seed": str(min(p["pairs"][0][1] for p in systems)),
        "recordings": str(max(len(p["recordings"]) for p in systems)),
        "pairs_of_a_recording": turns(systems),
        "verdicts": verdict_sentence(results["claims"]),
        "claims": claim_sections(results["claims"]),
        "as_written": "\n{{remarks as written}}" if tables.has_written(results["claims"]) else "",
        "sweeps": sweep_sections(sweeps),
        "accuracies": accuracy_table(systems),
        "areas": area_table(systems),
        "remembered": remembered(results),
        "confusions": confusion_sections(results),
        "questions": questions(results),
        "provenance": provenance(results),
    }
    page = template
    for key, value in filled.items():
        page = page.replace("{{" + key + "}}", value)
    return page


def put_remarks(page, text, template=TEMPLATE):
    """Inserts the remarks `## NAME` of the file of remarks at {{remarks NAME}} or {{question NAME}} of a page."""
    known = dict(section.split("\n", 1) for section in text.split("\n## ")[1:])
    page = re.sub(r"\{\{(?:remarks|question) (.*?)\}\}", lambda place: known.get(place[1], "").strip(), page)
    left = re.findall(r"\{\{.*?\}\}", page)
    if left:
        raise SystemExit(f"{template.name}: unknown placeholders {', '.join(left)}")
    return re.sub(r"\n{3,}", "\n\n", page)


def make_page(results, sweeps):
    page = fill(TEMPLATE.read_text(encoding="utf-8"), results, sweeps)
    return put_remarks(page, REMARKS.read_text(encoding="utf-8") if REMARKS.exists() else "")


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", type=pathlib.Path, help="results.json of somato reproduce")
    parser.add_argument("--sweeps", type=pathlib.Path, help="folder with NAME/sweep.json of each system")
    parser.add_argument("--check", type=pathlib.Path, help="fail if this page differs from the generated one")
    given = parser.parse_args(arguments)
    results = tables.load_results(given.results)
    names = [p["system"] for p in unchanged(results)] if given.sweeps else []
    tables.print_or_check(make_page(results, tables.load_sweeps(given.sweeps, names)), given)


if __name__ == "__main__":
    main()
