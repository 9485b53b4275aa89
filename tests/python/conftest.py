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
def X():
    """Rows around four centres, float32 of (60, 7)."""
    random = np.random.default_rng(7)
    centres = random.normal(size=(4, 7)) * 3
    return (centres[np.arange(60) % 4] + random.normal(size=(60, 7))).astype(np.float32)


@pytest.fixture
def labels():
    """The centre of each row of X."""
    return np.array(["ball", "cube", "cone", "tube"])[np.arange(60) % 4]
