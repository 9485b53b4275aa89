"""Formats the results as tables for a terminal or a page."""

UNITS = ((1.0, "s"), (1e-3, "ms"), (1e-6, "µs"))


def seconds_text(seconds):
    for size, unit in UNITS:
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds * 1e9:.3g} ns"


def share_text(entry):
    bound = entry.get("limit")
    return "–" if not bound else f"{100 * bound / entry['seconds']:.0f} %"


def memory_text(entry):
    return f"{entry['peak_kib'] / 1024:.0f} MiB" if entry.get("peak_kib") else "–"


def error_text(entry):
    error = entry.get("quantization_error")
    return "–" if error is None else f"{error:.4f}"


def time_text(entry):
    if "seconds" not in entry:
        return f"left out: {entry['left_out']}"
    few = f" ({len(entry['times'])} runs)" if len(entry["times"]) < 5 else ""
    return seconds_text(entry["seconds"]) + (" est" if entry.get("estimated") else "") + few


OURS_HEAD = ["workload", "threads", "time", "of the limit", "memory", "quantization error"]
OTHERS_HEAD = ["workload", "beside", "threads", "time", "ours is faster", "quantization error", "memory",
               "computes instead"]


def our_lines(results):
    for row in results["rows"]:
        for entry in [row, *(other for other in row["others"] if other.get("is_ours"))]:
            title = row["title"] if entry is row else entry["name"].replace("Somato, ", "… ")
            yield [title, entry["threads"], time_text(entry), share_text(entry) if "seconds" in entry else "–",
                   memory_text(entry), error_text(entry)]


def other_lines(results):
    for row in results["rows"]:
        for entry in row["others"]:
            if entry.get("is_ours"):
                continue
            ratio = f"{entry['ratio']:.3g} x" if "ratio" in entry else "–"
            yield [row["name"], entry["name"], entry["threads"], time_text(entry), ratio,
                   error_text(entry), memory_text(entry), entry["instead"] or "–"]


def markdown_table(head, lines):
    yield "| " + " | ".join(head) + " |"
    yield "|" + "---|" * len(head)
    for line in lines:
        yield "| " + " | ".join(str(cell) for cell in line) + " |"


def text_table(head, lines):
    lines = [head, *([str(cell) for cell in line] for line in lines)]
    widths = [max(len(line[i]) for line in lines) for i in range(len(head))]
    for line in lines:
        yield "  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip()


def machine_lines(results):
    yield f"{results['processor']}, {results['cores']} cores; Somato {results['version']}; {results['date']}"
    for threads, machine in sorted(results["machine"].items()):
        yield (f"limits, {threads} threads: {machine['flops'] / 1e9:.0f} GFLOP/s, memory read "
               f"{machine['read'] / 1e9:.1f}, changed {machine['change'] / 1e9:.1f}, written "
               f"{machine['write'] / 1e9:.1f} GB/s")
    for warning in results["warnings"]:
        yield f"warning: {warning}"


def as_text(results, markdown):
    table = markdown_table if markdown else text_table
    parts = [machine_lines(results), table(OURS_HEAD, our_lines(results))]
    others = list(other_lines(results))
    if others:
        parts.append(table(OTHERS_HEAD, others))
    gap = "\n\n" if markdown else "\n"
    head, *tables = ["\n".join(part) for part in parts]
    return "\n\n".join([head.replace("\n", gap), *tables])
