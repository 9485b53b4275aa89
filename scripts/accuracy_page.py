#!/usr/bin/env python3
"""Writes docs/accuracy.md from the cells that scripts/accuracy_study.py has stored.

    scripts/accuracy_page.py out/accuracy > docs/accuracy.md

The tables are inserted into the text of scripts/accuracy_page.md.in, with the remarks of
scripts/accuracy_remarks.md.in, which contain no figures. With --check FILE nothing is written; the script
fails if FILE differs from the page generated from the cells.
"""

import argparse
import json
import pathlib
import statistics

import reproduction_page
import result_tables as tables

HERE = pathlib.Path(__file__).resolve().parent
TEMPLATE = HERE / "accuracy_page.md.in"
REMARKS = HERE / "accuracy_remarks.md.in"
BASELINE = "best_neighbour"
REFINED = ("refined", "refined_manhattan", "relevance", "relevance_manhattan")
OVERVIEW = ("default", "manhattan", "measured", "suggested", *REFINED, "growing", "growing_by_names",
            "growing_refined", BASELINE, "half_of_samples", "linear_discriminant", "support_vectors")
LEAST_GAP = 0.0005  # smaller differences are not visible in the tables
GOAL_SETS = ("bts3v2_palm_45", "bts3v2_palm_45_test")
# Methods, the nearest neighbour that they are compared with, the greatest difference, the largest share kept.
GOALS = ((("default", "manhattan", "measured", "suggested"), "manhattan_standardized", 0.06, 1.0),
         (REFINED, "euclidean_standardized", 0.0, 0.5),
         (REFINED, "manhattan_standardized", 0.03, 0.5),
         (("growing", "growing_by_names", "growing_refined"), BASELINE, 0.02, 0.3))


class Results:
    """The cells of a folder: `accuracy` and `clusters` by (set, method), and the description of the study."""

    def __init__(self, folder):
        self.study = tables.load_results(folder / "study.json")
        self.accuracy = self._read(folder / "accuracy", self.study["methods"])
        self.clusters = self._read(folder / "clusters", self.study["clusterers"])
        self._check_libraries()

    def _read(self, folder, entries):
        found = {}
        for one in self.study["sets"]:
            for entry in entries:
                path = folder / one["name"] / f"{entry['name']}.json"
                if path.exists():
                    found[one["name"], entry["name"]] = json.loads(path.read_text(encoding="utf-8"))
        return found

    def _check_libraries(self):
        libraries = sorted({cell["identity"]["library"] for cell in [*self.accuracy.values(), *self.clusters.values()]
                            if cell["identity"]["library"].startswith("pysomato")})
        if len(libraries) > 1:
            raise SystemExit(f"the cells are of several versions ({', '.join(libraries)}); run accuracy_study.py "
                             "with all sets and methods again")

    def sets(self, group):
        return [one for one in self.study["sets"] if one["group"] == group]

    def methods(self, group):
        return [method for method in self.study["methods"] if group in method["groups"]]

    def values(self, set_name, method_name):
        """The accuracy of each seed, or None if the cell was not run."""
        cell = self.accuracy.get((set_name, method_name))
        return [run["accuracy"] for run in cell["runs"]] if cell else None

    def mean(self, set_name, method_name):
        values = self.values(set_name, method_name)
        return statistics.mean(values) if values else None


def figure(values):
    """Mean ± deviation over seeds, one number of a method without chance, or a dash."""
    if not values:
        return "–"
    return tables.spread(values) if len(values) > 1 else f"{values[0]:.3f}"


def points(difference):
    return "–" if difference is None else f"{100 * difference:+.1f}"


def mean_of(cell, key):
    return statistics.mean(run[key] for run in cell["runs"])


def kept(cell):
    """The vectors kept of a fold, and their share of the training samples."""
    share = mean_of(cell, "kept") / mean_of(cell, "trained")
    return f"{mean_of(cell, 'kept'):.0f} ({tables.percent(share)})"


def seconds(cell):
    return f"{mean_of(cell, 'seconds'):.2f}"


def difference(one, other):
    return None if one is None or other is None else one - other


# Sets


def set_table(results, set_name, group):
    baseline = results.mean(set_name, BASELINE)
    rows = []
    for method in results.methods(group):
        cell = results.accuracy.get((set_name, method["name"]))
        gap = difference(results.mean(set_name, method["name"]), baseline)
        rows.append([method["text"], figure(results.values(set_name, method["name"])), points(gap),
                     *([kept(cell), seconds(cell)] if cell else ["–", "–"])])
    return tables.table(["method", "accuracy", "to the baseline, points", "vectors kept", "s"], rows)


def size_text(results, set_name):
    cells = [cell for (name, _), cell in results.accuracy.items() if name == set_name]
    if not cells:
        return ""
    return f"{cells[0]['samples']} explorations, {cells[0]['classes']} classes, {cells[0]['columns']} columns"


def set_sections(results, group):
    return "\n\n".join(f"### {one['name']}\n\n{one['text'][0].upper()}{one['text'][1:]}: "
                       f"{size_text(results, one['name'])}.\n\n{set_table(results, one['name'], group)}"
                       for one in results.sets(group))


def overview(results, group, names=None):
    """Rows are sets, columns are methods."""
    methods = [method for method in results.methods(group) if names is None or method["name"] in names]
    rows = [[one["name"], *(figure(results.values(one["name"], method["name"])) for method in methods)]
            for one in results.sets(group)]
    return tables.table(["set", *(method["text"] for method in methods)], rows)


def early_table(results, is_change):
    """Rows are methods, columns are shares of the frames."""
    sets = [one for one in results.sets("early") if one["name"].endswith("change") == is_change]
    rows = [[method["text"], *(figure(results.values(one["name"], method["name"])) for one in sets)]
            for method in results.methods("early")]
    return tables.table(["method", *(f"{one['name'].split('_')[1]} % of the frames" for one in sets)], rows)


# The baseline


def gap_row(results, set_name, method):
    """The points below the baseline; how many of them the nearest neighbour with the map's own distance and
    scale loses, too; and the accuracy on the explorations that the map has learned."""
    own, baseline = results.mean(set_name, method["name"]), results.mean(set_name, BASELINE)
    like = results.mean(set_name, method["like"]) if method["like"] else None
    cell = results.accuracy[set_name, method["name"]]
    return [set_name, f"{own:.3f}", f"{baseline:.3f}", points(own - baseline), points(difference(like, baseline)),
            points(difference(own, like)), f"{mean_of(cell, 'learned'):.3f}", kept(cell)]


def sets_below(results, method, group):
    gaps = {one["name"]: difference(results.mean(one["name"], method["name"]), results.mean(one["name"], BASELINE))
            for one in results.sets(group)}
    return [name for name, gap in gaps.items() if gap is not None and gap <= -LEAST_GAP]


def below_sections(results):
    texts = []
    for method in results.methods("touch"):
        if not method["is_map"]:
            continue
        below = sets_below(results, method, "touch")
        text = f"### {method['text']}\n\n"
        if not any(results.values(one["name"], method["name"]) for one in results.sets("touch")):
            texts.append(f"{text}Not run.")
        elif not below:
            texts.append(f"{text}It reaches the baseline on every set.")
        else:
            rows = [gap_row(results, name, method) for name in below]
            heads = ["set", "accuracy", "baseline", "difference, points", "by distance and scale", "by the map",
                     "learned", "vectors kept"]
            texts.append(f"{text}{tables.table(heads, rows)}\n\n{{{{remarks {method['name']}}}}}")
    return "\n\n".join(texts)


def goal_row(results, set_name, method, goal):
    _, reference, most_below, most_kept = goal
    cell, other = results.accuracy.get((set_name, method)), results.mean(set_name, reference)
    texts = {one["name"]: one["text"] for one in results.study["methods"]}
    row = [texts[method], set_name, texts[reference] + (f", less {100 * most_below:.0f} points" if most_below else "")]
    if not cell or other is None:
        return [*row, "–", "–", "not run"]
    share = mean_of(cell, "kept") / mean_of(cell, "trained")
    own = results.mean(set_name, method)
    is_met = own >= other - most_below and share <= most_kept
    return [*row, f"{own:.3f} of {other - most_below:.3f}", f"{tables.percent(share)} of {tables.percent(most_kept)}",
            "met" if is_met else f"missed by {100 * (other - most_below - own):.1f} points" if own < other - most_below
            else "missed: too many vectors"]


def goal_table(results):
    rows = [goal_row(results, set_name, method, goal)
            for goal in GOALS for method in goal[0] for set_name in GOAL_SETS]
    return tables.table(["method", "set", "at least the accuracy of", "accuracy", "kept, at most", "goal"], rows)


def fold_table(results):
    rows = []
    for one in results.sets("touch"):
        by_blocks = results.mean(one["name"], BASELINE)
        mixed = results.mean(one["name"], f"{BASELINE}_interleaved")
        rows.append([one["name"], figure(results.values(one["name"], BASELINE)),
                     figure(results.values(one["name"], f"{BASELINE}_interleaved")),
                     points(difference(mixed, by_blocks))])
    return tables.table(["set", "blocks", "interleaved", "difference, points"], rows)


# Clusters


def cluster_table(results, set_name):
    rows = []
    for clusterer in results.study["clusterers"]:
        cell = results.clusters.get((set_name, clusterer["name"]))
        if not cell:
            rows.append([clusterer["text"], "–", "–", "–"])
            continue
        values = {key: [run[key] for run in cell["runs"]] for key in cell["runs"][0]}
        rows.append([clusterer["text"], figure(values["adjusted_rand_index"]),
                     figure(values["normalized_mutual_information"]), tables.spread(values["clusters"], 1)])
    return tables.table(["method", "adjusted Rand index", "normalized mutual information", "clusters"], rows)


# The page


def not_run(results):
    """A sentence that names the methods without a cell, or nothing."""
    missing = [f"*{method['text']}*" for method in results.study["methods"]
               if not any((one["name"], method["name"]) in results.accuracy for one in results.study["sets"])]
    return f"Not run for this page: {tables.listing(missing)}." if missing else ""


def settings_table(results):
    rows = [[method["text"], f"`{tables.cell(method['settings'].split(chr(10))[0])}`"]
            for method in results.study["methods"]]
    return tables.table(["method", "settings"], rows)


def make_page(results, template, remarks):
    study = results.study
    frame, change = study["clustered"]
    filled = {
        "seeds": tables.counted(study["seeds"], "seed"), "folds": study["folds"],
        "versions": f"pysomato {study['pysomato']} and scikit-learn {study['scikit-learn']}",
        "not run": not_run(results), "overview": overview(results, "touch", OVERVIEW), "below": below_sections(results),
        "goals": goal_table(results),
        "folds table": fold_table(results), "sets": set_sections(results, "touch"),
        "points": overview(results, "points"), "settings": settings_table(results),
        "early frame": early_table(results, False), "early change": early_table(results, True),
        "clusters frame": cluster_table(results, frame), "clusters change": cluster_table(results, change)}
    for key, value in filled.items():
        template = template.replace("{{" + key + "}}", str(value))
    return reproduction_page.put_remarks(template, remarks, TEMPLATE)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", type=pathlib.Path, help="folder of accuracy_study.py")
    parser.add_argument("--check", type=pathlib.Path, help="fail if this page differs from the generated one")
    given = parser.parse_args(arguments)
    page = make_page(Results(given.results), TEMPLATE.read_text(encoding="utf-8"),
                     REMARKS.read_text(encoding="utf-8"))
    tables.print_or_check(page, given)


if __name__ == "__main__":
    main()
