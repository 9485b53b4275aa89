"""What the tests share: the program of the build, and small data."""

import os
import subprocess

import numpy as np
import pytest


@pytest.fixture(scope="session")
def somato():
    """Runs the program and returns what it prints."""

    def run(*words):
        done = subprocess.run([os.environ["SOMATO_PROGRAM"], *map(str, words)], check=False,
                              capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return done.stdout

    return run


@pytest.fixture
def study_text():
    """The text of a study of grasps, whose last line belongs to its map."""

    def text(settings, *, columns=4):
        return f"""
[study]
name = "grasps"
label = "object"
{settings}

[module.joints]
type = "channel"
channel = "joints"

[module.closed]
type = "last"
input = "joints"

[module.map]
type = "som"
input = "closed"
rows = 4
columns = {columns}
iterations = 300
"""

    return text


@pytest.fixture
def X():
    """Rows around four centres, float32 of (60, 7)."""
    random = np.random.default_rng(7)
    centres = random.normal(size=(4, 7)) * 3
    return (centres[np.arange(60) % 4] + random.normal(size=(60, 7))).astype(np.float32)


@pytest.fixture
def labels():
    """The centre of each row of X."""
    return np.array(["ball", "cube", "cone", "tube"])[np.arange(60) % 4]
