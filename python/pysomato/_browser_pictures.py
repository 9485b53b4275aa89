"""Pictures in other formats than SVG, by the browser Chromium."""

import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from .errors import OperatingSystemError

# In the order of the program (program/view/headless_browser.cc).
_BROWSERS = ("chromium", "chromium-browser", "google-chrome")
_PAGE = ("<!doctype html><meta charset='utf-8'><style>@page {{ size: {}px {}px; margin: 0 }} body {{ margin: 0 }} "
         "svg {{ display: block }}</style>{}")
# Long for the largest picture on a machine with other work.
_SECONDS = 120


def converted(svg, ending) -> bytes:
    """An SVG picture as the content of a file with this ending: .pdf, or .png of 2 pixels for each unit.

    Raises:
        OperatingSystemError: There is no Chromium, or it does not draw the picture.
    """
    width, height = (int(float(re.search(f'<svg[^>]* {side}="([0-9.]+)"', svg)[1]) + 0.999)
                     for side in ("width", "height"))
    with tempfile.TemporaryDirectory() as folder:
        page, picture = Path(folder, "page.html"), Path(folder, f"picture{ending}")
        page.write_text(_PAGE.format(width, height, svg), encoding="utf-8")
        flags = {".pdf": ["--no-pdf-header-footer", f"--print-to-pdf={picture}"],
                 ".png": ["--force-device-scale-factor=2", f"--window-size={width},{height}",
                          f"--screenshot={picture}"]}[ending]
        _run(_browser(ending), folder, [*flags, page.as_uri()])
        if not picture.is_file():
            raise OperatingSystemError("Chromium has drawn nothing", ending, "save the picture as .svg")
        return picture.read_bytes()


def _browser(ending):
    for name in _BROWSERS:
        if (found := shutil.which(name)) is not None:
            return found
    raise OperatingSystemError(
        f"{ending[1:].upper()} files are drawn by the browser Chromium, which is not installed", ending,
        "install it, on Debian with: sudo apt-get install chromium; or save the picture as .svg; or draw a panel with "
        "plot() and figure.savefig()")


def _run(browser, folder, words):
    command = [browser, "--headless=new", f"--user-data-dir={folder}/profile", "--no-first-run",
               "--disable-extensions", "--disable-background-networking", "--hide-scrollbars"]
    if hasattr(os, "geteuid") and os.geteuid() == 0:
        command.append("--no-sandbox")  # which the superuser cannot have
    try:
        subprocess.run([*command, *words], check=False, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL, timeout=_SECONDS)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise OperatingSystemError(f"Chromium cannot draw the picture: {error}", browser,
                                   "save the picture as .svg") from error
