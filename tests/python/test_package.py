"""The package as a whole."""

import subprocess
import sys
from pathlib import Path

import pysomato


def test_all_names_exist_and_are_documented():
    assert len(set(pysomato.__all__)) == len(pysomato.__all__)
    for name in pysomato.__all__:
        assert getattr(pysomato, name).__doc__, name


def test_the_stub_is_that_of_the_extension_module(tmp_path):
    stub = tmp_path / "_somato.pyi"
    subprocess.run([sys.executable, "-m", "nanobind.stubgen", "-q", "-m", "pysomato._somato", "-o",
                    str(stub)], check=True)
    written = Path(pysomato.__file__).with_name("_somato.pyi")
    assert stub.read_text() == written.read_text(), f"write {written} anew with nanobind.stubgen"
