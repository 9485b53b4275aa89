"""Markdown tables shared by the pages of results: claims, verdicts, confusions and sweeps."""

import collections
import json
import statistics
import sys

VERDICTS = ("holds", "holds, but so does chance", "mostly", "fails", "cannot be decided here")
# Those of the second measure, by the words of the texts.
WRITTEN_VERDICTS = ("holds", "holds, but so does chance", "compatible", "compatible, but no narrower than chance",
                    "mostly", "not determined", "fails", "cannot be decided here")
FOLDS = ("leave_group_out", "trial")
LEAST_FIRST_ORDER = 0.05  # an unknown with a lower index is not considered decisive
TIMES_CHANCE = 2  # the same for an index below this multiple of the value by chance
MOST_CONFUSIONS = 3


def load_results(path):
    """Content of results.json."""
    return json.loads(path.read_text(encoding="utf-8"))


def print_or_check(page, given):
    """Prints the page made from `given.results`, or compares it with the file `given.check`."""
    if not given.check:
        print(page, end="")
    elif given.check.read_text(encoding="utf-8") != page:
        sys.exit(f"{given.check} differs from the page generated from {given.results}; generate it again")


def table(heads, rows):
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines)


def number(value):
    return "–" if value is None else f"{value:g}"


def rounded(value):
    return "–" if value is None else f"{round(value, 2):g}"


def percent(share):
    return "–" if share is None else f"{100 * share:.0f} %"


def measured(claim):
    """Mean and standard deviation, of which a pair without a value leaves none."""
    return "–" if claim["mean"] is None else f"{claim['mean']:.2f} ± {claim['sd']:.2f}"


def spread(values, digits=3):
    deviation = statistics.stdev(values) if len(values) > 1 else 0.0
    return f"{statistics.mean(values):.{digits}f} ± {deviation:.{digits}f}"


def counted(count, singular):
    return f"{count} {singular}" + ("" if count == 1 else "s")


def listing(texts):
    return " and ".join([", ".join(texts[:-1]), texts[-1]] if len(texts) > 1 else texts)


def cell(text):
    """Text of a file, escaped for a table cell."""
    return text.replace("|", "\\|").replace("\n", " ")


def subject(part):
    return f"{part['system']}, {part['variation']}" if part["variation"] else part["system"]


def protocol_text(protocol):
    group = protocol.get("group", "")
    known = {("train_is_test", ""): "train = test", FOLDS: "5 folds", ("test_data", ""): "new objects"}
    name = protocol["protocol"]
    return known.get((name, group), f"{name.replace('leave_group_out', 'leave out')} {group}".rstrip())


# Claims


def range_text(claim):
    low, high = claim["at_least"], claim["at_most"]
    if low is None:
        return f"≤ {number(high)}"
    if high is None:
        return f"≥ {number(low)}"
    return f"= {number(low)}" if low == high else f"{number(low)} to {number(high)}"


def bounds(claim):
    what = f"`{claim['metric']}`"
    if "than_system" in claim:
        than = {"system": claim["than_system"], "variation": claim["than_variation"]}
        than_metric = claim.get("than_metric", claim["metric"])
        metric = "that" if than_metric == claim["metric"] else f"`{than_metric}`"
        what += f" less {metric} of {subject(than)}"
    return f"{what} {range_text(claim)}, {protocol_text(claim)}{limit_text(claim)}"


def limit_text(claim):
    """The best value that the numbers of the objects permit, if the metric has one."""
    return f"; best possible {rounded(claim['limit'])}" if "limit" in claim else ""


def verdict_text(claim):
    undecided = claim["verdict"] == "cannot be decided here" and claim["reason"]
    return claim["verdict"] + (f": {cell(claim['reason'])}" if undecided else "")


def ends(values):
    return "–" if values is None else f"{rounded(values[0])} to {rounded(values[1])}"


def written_text(second):
    """What the second measure of a claim found."""
    if not second["values"]:
        return "–"
    if second["judged_by"] == "central_range":
        return f"{number(second['published'])} in {ends(second['range'])}; by chance {ends(second['chance_range'])}"
    if second["judged_by"] == "mean":
        signs = ("≥", "≤") if second["bounds_included"] else (">", "<")
        sides = [f"{sign} {number(bound)}" for sign, bound in zip(signs, (second["at_least"], second["at_most"]))
                 if bound is not None]
        return f"mean {rounded(second['mean'])} ({ends(second['range'])}) {' and '.join(sides)}"
    return (f"`{second['metric']}` {range_text(second)}{limit_text(second)}: {measured(second)}, "
            f"{percent(second['share'])}; by chance {rounded(second['by_chance'])}, "
            f"{percent(second['chance_share'])}")


def written_cells(claim):
    """The columns of the second measure, and of the figure that contradicts the claim."""
    second = claim.get("as_written")
    verdict = verdict_text(second) if second else "the same"
    if "contradicted_by" in claim:
        verdict += f"; contradicted by {cell(claim['contradicted_by'])}"
    return [written_text(second) if second else "–", verdict]


def has_written(claims):
    return any("as_written" in claim or "contradicted_by" in claim for claim in claims)


def claim_table(claims):
    with_paper = any(claim["paper"] for claim in claims)
    heads = ["claim", "paper", "measured by", "published", "measured", "by chance", "holds in",
             "chance holds in", "verdict"]
    rows = [[f"{subject(c)}: {cell(c['text'])}", c["paper"] or "ours", bounds(c),
             number(c["published"]), measured(c), rounded(c["by_chance"]),
             f"{percent(c['share'])} of {len(c['values'])}", percent(c["chance_share"]), verdict_text(c)]
            for c in claims]
    if has_written(claims):
        heads += ["as written", "verdict as written"]
        rows = [row + written_cells(claim) for row, claim in zip(rows, claims)]
    if not with_paper:
        heads, rows = heads[:1] + heads[2:], [row[:1] + row[2:] for row in rows]
    return table(heads, rows)


def counted_verdicts(verdicts, known):
    found = collections.Counter(verdicts)
    unknown = sorted(set(found) - set(known))
    if unknown:
        raise ValueError(f"the verdict '{unknown[0]}' is not one of {', '.join(known)}")
    return ", ".join(f"*{verdict}*: {found[verdict]}" for verdict in known)


def verdict_counts(claims):
    """Counts of the verdicts, such as '*holds*: 2, *fails*: 1'."""
    return counted_verdicts((claim["verdict"] for claim in claims), VERDICTS)


def written_verdict_counts(claims):
    """The same by the second measure of each claim that has one."""
    return counted_verdicts((claim.get("as_written", claim)["verdict"] for claim in claims), WRITTEN_VERDICTS)


# Confusions


def find_protocol(part, name, group=""):
    for protocol in part["protocols"]:
        if (protocol["protocol"], protocol.get("group", "")) == (name, group):
            return protocol
    return None


def confusions(protocol):
    """Counts of (true class, predicted class) over all runs: (classes, predicted classes, Counter of pairs)."""
    found = collections.Counter()
    classes = {}
    for run in protocol["runs"]:
        found.update(zip(run["labels"], run["predictions"]))
        classes.update(dict.fromkeys(run["labels"]))
    named = dict.fromkeys(name for _, name in found)
    return list(classes), [*classes, *(n for n in named if n not in classes)], found


def confusion_table(protocol):
    classes, named, found = confusions(protocol)
    rows = []
    for true in classes:
        total = sum(found[true, name] for name in named)
        shares = [100 * found[true, name] / total for name in named]
        rows.append([f"**{true}**", *("" if s == 0 else "<1" if s < 0.5 else f"{s:.0f}" for s in shares)])
    return table(["true \\ predicted, %", *named], rows)


def greatest_confusions(protocol):
    classes, _, found = confusions(protocol)
    totals = {true: sum(n for (t, _), n in found.items() if t == true) for true in classes}
    wrong = [(count / totals[true], true, name) for (true, name), count in found.items() if true != name]
    if not wrong:
        return "All explorations are classified correctly."
    wrong.sort(key=lambda one: (-one[0], classes.index(one[1]), one[2]))
    return "Most often confused: " + listing(
        [f"{true} is classified as {name} ({100 * share:.1f} %)" for share, true, name in wrong[:MOST_CONFUSIONS]]) + "."


# Sweeps


def load_sweeps(folder, names):
    """Content of FOLDER/NAME/sweep.json by name; a missing sweep is an error."""
    return {name: json.loads((folder / name / "sweep.json").read_text(encoding="utf-8")) for name in names}


def decides(unknown):
    """Whether an unknown's first order is clearly above chance."""
    if unknown["first_order"] is None:
        return False
    chance = unknown["first_order_by_chance"] or 0.0
    return unknown["first_order"] >= max(LEAST_FIRST_ORDER, TIMES_CHANCE * chance)


def value_text(value):
    if isinstance(value, bool):
        return str(value).lower()
    return f"{float(f'{value:.3g}'):g}" if isinstance(value, (int, float)) else str(value)


def cell_text(part):
    low, high = value_text(part["from"]), value_text(part["to"])
    return low if low == high else f"{low} to {high}"


def influence(unknown, sweep):
    """Values of a deciding unknown at which a claim holds most and least often."""
    declared = next(u for u in sweep["unknowns"] if u["name"] == unknown["name"])
    shares = [(found["share"], cell_text(part)) for found, part in zip(unknown["cells"], declared["cells"])
              if found["share"] is not None]
    best, worst = max(shares, key=lambda s: s[0]), min(shares, key=lambda s: s[0])
    return (f"`{unknown['name']}` ({unknown['first_order']:.2f}): most at {best[1]} ({percent(best[0])}), "
            f"least at {worst[1]} ({percent(worst[0])})")


def deciding(claim):
    found = [unknown for unknown in claim["unknowns"] if decides(unknown)]
    return sorted(found, key=lambda unknown: -unknown["first_order"])


def judged(sweep):
    return [claim for claim in sweep["claims"] if claim["points"]]


def unjudged(sweep):
    """Claims under protocols that the sweep omits, and claims that compare systems."""
    return [c["text"] for c in sweep["claims"] if not c["points"]] + sweep["not_judged"]


def sweep_table(sweep):
    rows = []
    for claim in judged(sweep):
        why = "<br>".join(influence(unknown, sweep) for unknown in deciding(claim))
        text = cell(claim["text"]) + (f" ({claim['variation']})" if claim["variation"] else "")
        rows.append([text, claim["paper"] or "ours", range_text(claim), percent(claim["holds"]),
                     percent(claim["mean_share"]), why or "–"])
    return table(["claim", "paper", "bound", "holds in, of the space", "mean share of pairs",
                  "decided by (first order): holds"], rows)


def sweep_size(sweep):
    recordings = {name for point in sweep["points"] for name in point["recordings"]}
    return (f"{counted(len(sweep['points']), 'point')} (`{sweep['design']}`) over "
            f"{counted(len(sweep['unknowns']), 'unknown')}, {counted(sweep['pairs'], 'pair')} each, "
            f"{counted(len(recordings), 'recording')}, seeds from {sweep['seed']} on")
