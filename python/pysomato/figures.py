"""Figures, tables and the methods of a report, for a paper."""

import os

from ._program import run_program


def figure(results, name, path, *, width=None, caption=False, selection=None, data=None) -> None:
    """Saves a figure of the report, as ``somato figure`` does (docs/report.md).

    The page of the report draws it in the browser Chromium, without a window.

    Args:
        results: The results.json of a study or a reproduction.
        name: Such as ``"map"``, ``"winners"``, ``"systems"``, ``"methods"`` or ``"references"``.
        path: The file, whose ending is the format: .svg, .pdf or .png; .tex or .csv for a table;
            .tex or .txt for the methods; .bib for the references.
        width: The width of a picture, such as ``"85mm"``, ``"8.5cm"`` or ``"3.3in"``; None: 85 mm.
        caption: Whether a picture contains its title and its caption.
        selection: What is shown of a system, as in an address of the report, such as
            ``"label=shape&run=2"``.
        data: The recordings of the results, if they are in another folder.

    Raises:
        UsageError: There is no such figure (the message names similar ones), it cannot be saved in
            this format, or an argument is wrong.
        Error: A file cannot be read or written, or Chromium is not installed.
    """
    words = ["figure", os.fspath(results), name, "--output", os.fspath(path)]
    given = {"--width": width, "--selection": selection, "--data": data}
    for flag, value in given.items():
        if value is not None:
            words += [flag, os.fspath(value)]
    run_program(*words, *(["--caption"] if caption else []))
