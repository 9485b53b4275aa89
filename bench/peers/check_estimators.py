"""Prints as JSON what check_estimator of scikit-learn says of classes.

usage: check_estimators.py MODULE.CLASS(ARGUMENTS)...
"""

import collections
import importlib
import json
import os
import sys
import warnings

from sklearn.utils.estimator_checks import check_estimator


def verdict(expression):
    """Numbers of checks by status; or the reason why the class is refused."""
    module = expression.split("(")[0].rpartition(".")[0]
    estimator = eval(expression, {module: importlib.import_module(module)})
    try:
        results = check_estimator(estimator, on_skip=None, on_fail=None)
    except Exception as error:  # noqa: BLE001: a refusal is a result
        return {"refused": f"{type(error).__name__}: {error}".splitlines()[0]}
    return dict(collections.Counter(result["status"] for result in results))


def main():
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # the classes print
    warnings.simplefilter("ignore")
    json.dump({expression: verdict(expression) for expression in sys.argv[1:]}, answers)


if __name__ == "__main__":
    main()
