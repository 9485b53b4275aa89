"""Builds and runs the tests that a change can reach, in the build folder `dev`."""

import json
import re
import subprocess

import budget
import changed_files
import changed_tests
import test_cases

TREE = changed_files.TREE
DEV = TREE / "build/dev"
UNIT = 0.4  # seconds of the fixed job on a typical machine: enough for an estimate


def passes(*command):
    return subprocess.run(command, cwd=TREE).returncode == 0


def changed_names():
    return sorted(path.relative_to(TREE).as_posix() for path in changed_files.changed_files())


def commands_of_tests():
    """The commands of the tests that are not long, by name."""
    listed = subprocess.run(["ctest", "--test-dir", str(DEV), "-LE", "^long$", "--show-only=json-v1"],
                            capture_output=True, text=True, check=True).stdout
    return {test["name"]: test.get("command", []) for test in json.loads(listed)["tests"]}


def entry_of(test):
    return f"dev: {test}"


def seconds_by_test(tests):
    """Processor seconds of the tests in their last complete run on this machine, or of the budget."""
    kept = json.loads(budget.LAST.read_text(encoding="utf-8")) if budget.LAST.is_file() else {}
    of_budget = {name: units * UNIT for name, units in budget.read().items()}
    of_entry = {**of_budget, **kept.get("dev: tests", {}).get("seconds", {})}
    return {test: of_entry[entry_of(test)] for test in tests if entry_of(test) in of_entry}


def targets_of(tests, documents):
    """Targets to build: those of groups, because the tests of a wing are one program."""
    parts = [test.split(".") for test in tests]
    targets = {rest if group == "fuzz" else f"{group}_group" for group, rest in parts}
    return sorted(targets | ({"docs_group"} if documents else set()))


def without_documents(command):
    """A command of run_doc_blocks.py without its choice of documents and its folder."""
    words = iter(command)
    kept = []
    for word in words:
        if word in ("--only", "--without", "--scratch", "--share"):
            next(words)
        else:
            kept.append(word)
    return kept


def run_documents(documents, commands):
    """Whether the commands in the documents run as they show."""
    command = next((words for name, words in commands.items()
                    if name.startswith("docs.") and any("run_doc_blocks" in word for word in words)), None)
    if documents and command is None:
        print(f"FAILED    {', '.join(documents)}: this build has no test that runs the documentation")
        return False
    scratch = DEV / "changed_documents"
    environment = ["env", f"PYTHONPATH={DEV / 'python'}"]
    return all([passes(*environment, *without_documents(command), "--scratch", str(scratch), "--only", document)
                for document in documents])


def run_tests(tests):
    names = "|".join(map(re.escape, tests))
    return not tests or test_cases.run(DEV, ["-R", f"^({names})$", "-LE", "^long$"])


def print_not_run(commands, run, left):
    if left:
        print(f"Left out, although the change can reach them: {', '.join(left)}")
    groups = sorted({test.split(".")[0] for test in commands if test not in [*run, *left]})
    print(f"Not run, because no include leads there: tests of {', '.join(groups) or 'no room'}")
    print("Not run: what tests reach by running the program; long tests; sanitizers; the second compiler")


def run(chosen):
    """Runs what `chosen` names; returns whether the checks and the tests pass."""
    commands = commands_of_tests()
    tests = sorted(commands)
    chosen_tests, left = changed_tests.within_limit(chosen, tests, seconds_by_test(tests).get)
    targets = targets_of(chosen_tests, chosen.documents)
    built = not targets or passes("cmake", "--build", str(DEV), "--target", *targets)
    passed = built and run_tests(chosen_tests)
    passed = built and run_documents(chosen.documents, commands) and passed
    print_not_run(commands, chosen_tests, left)
    return passed
