#!/usr/bin/env python3
"""Writes docs/unknowns.md from the files of unknowns and, if available, their sweeps.

    scripts/unknowns_page.py systems/unknowns --sweeps out/sweeps > docs/unknowns.md

FOLDER/NAME/sweep.json of --sweeps is the result of `somato sweep NAME --over systems/unknowns/NAME.toml`.
"""

import argparse
import pathlib
import tomllib

import result_tables as tables

# As the papers present them.
ORDER = ("single_tensor_product", "tensor_chain", "t_mpsom_multiplied", "t_mpsom_added", "shape_and_size",
         "texture", "hardness", "combined", "bimodal")
INTRODUCTION = """# What the papers leave open

Each of the nine systems has a file of its unknowns in [`systems/unknowns`](../systems/unknowns): settings that no paper specifies and that may affect the outcome. This page lists them, with the tested values, the reasons for these values, and the claims that each setting decides.
The page is generated from these files and from the sweeps; [reproduction.md](reproduction.md) lists the commands and the claims, [sweeps.md](reference/sweeps.md) describes the method. Ranges are based on the texts, on physics and on the literature, not on results.

An unknown decides a claim if its first-order index is at least 0.05 and at least twice the value expected by chance. The index is given in brackets, followed by the values at which the claim holds in most pairs and in fewest.
"""


def place(name):
    return (ORDER.index(name) if name in ORDER else len(ORDER), name)


def load_unknowns(folder):
    """The unknowns of each system's file, in the order of the papers."""
    files = sorted(folder.glob("*.toml"), key=lambda file: place(file.stem))
    return {file.stem: tomllib.loads(file.read_text(encoding="utf-8"))["unknown"] for file in files}


def tried(unknown):
    if "values" in unknown:
        return ", ".join(tables.value_text(value) for value in unknown["values"])
    scale = ", logarithmic" if unknown.get("scale") == "logarithmic" else ""
    return f"{tables.value_text(unknown['low'])} to {tables.value_text(unknown['high'])}{scale}"


def keys(unknown):
    found = unknown["key"]
    return [found] if isinstance(found, str) else found


def grouped(unknowns):
    """Systems with the same values and reason, by name: {name: {(values, text): [(system, keys)]}}."""
    names = {}
    for system, of_system in unknowns.items():
        for name, unknown in of_system.items():
            same = names.setdefault(name, {}).setdefault((tried(unknown), unknown["text"]), [])
            same.append((system, keys(unknown)))
    return names


def decided(name, systems, sweeps):
    """A line for each claim that the unknown decides."""
    for system in systems:
        if system not in sweeps:
            continue
        for claim in tables.judged(sweeps[system]):
            for unknown in tables.deciding(claim):
                if unknown["name"] == name:
                    about = f"{system}, {claim['variation']}" if claim["variation"] else system
                    yield f"  - {about}: {claim['text']}: {tables.influence(unknown, sweeps[system])}"


def section(name, groups, sweeps):
    lines = [f"## {name.replace('_', ' ')}", ""]
    for (values, text), members in groups.items():
        systems = [system for system, _ in members]
        moved = dict.fromkeys(key for _, found in members for key in found)
        lines += [f"- **{tables.listing(systems)}**: {', '.join(f'`{key}`' for key in moved)}",
                  f"  - tested values: {values}", f"  - {text}"]
        lines += decided(name, systems, sweeps)
    return "\n".join(lines) + "\n"


def make_page(unknowns, sweeps):
    size = [f"- {name}: {tables.sweep_size(sweep)}" for name, sweep in sweeps.items()]
    measured = "\n".join(size) if size else "No sweep was run for this page; it lists the values that a sweep would test."
    sections = [section(name, groups, sweeps) for name, groups in grouped(unknowns).items()]
    return "\n".join([INTRODUCTION, measured + "\n", *sections])


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("unknowns", type=pathlib.Path, help="folder with a file of unknowns for each system")
    parser.add_argument("--sweeps", type=pathlib.Path, help="folder with NAME/sweep.json of each system")
    given = parser.parse_args(arguments)
    unknowns = load_unknowns(given.unknowns)
    sweeps = tables.load_sweeps(given.sweeps, unknowns) if given.sweeps else {}
    print(make_page(unknowns, sweeps), end="")


if __name__ == "__main__":
    main()
