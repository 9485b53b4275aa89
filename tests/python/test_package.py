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


def test_packages_that_take_seconds_are_imported_when_they_are_needed():
    code = ("import sys, pysomato; "
            "print(sorted({'numpy', 'pandas', 'scipy', 'sklearn'} & set(sys.modules))); "
            "pysomato.SOM; print('sklearn' in sys.modules)")
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert done.stdout.split("\n")[:2] == ["[]", "True"]


def test_modules_and_names_are_those_of_the_package():
    assert pysomato.som.SOM is pysomato.SOM
    assert set(pysomato.__all__) <= set(dir(pysomato))
    assert not hasattr(pysomato, "som_learner")
