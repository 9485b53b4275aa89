#!/usr/bin/env bash
# Builds the wheel of the Python package into FOLDER: wheel.sh FOLDER
# One wheel serves Python 3.10 and all later ones (the stable interface), and every Linux with a C library as new as that
# of this machine: it contains all other libraries. It is installed and used with each Python from 3.10 to 3.13 that is
# on the path or was installed by pyenv. The output has the lines 'needs ...' and 'passed with Python ...', which release.sh reads.
set -euo pipefail
folder=$(realpath -m "${1:?wheel.sh requires a folder for the wheel}")
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

./dev wheel "$work/built"
python3 -m venv "$work/tools"
"$work/tools/bin/pip" install --quiet --requirement scripts/release/wheel_tools.txt
export PATH=$work/tools/bin:$PATH
auditwheel repair --wheel-dir "$folder" "$work/built"/*.whl
abi3audit --strict --verbose "$folder"/*.whl
echo "needs $(basename "$folder"/*.whl | sed -n 's/.*-\(manylinux_[0-9]*_[0-9]*\).*/\1/p'): \
glibc, numpy, scikit-learn, nanobind-backend"

cat >"$work/use.py" <<'PYTHON'
import subprocess

import numpy
import pysomato

X = numpy.random.default_rng(1).normal(size=(200, 3))
som = pysomato.SOM(rows=4, columns=5).fit(X)
winners = som.predict(X)
distances = ((X[:, None, :] - som.weights_.reshape(20, 3)) ** 2).sum(axis=2)
assert (distances.argmin(axis=1) == winners).mean() > 0.99
subprocess.run(["somato", "--version"], check=True)
subprocess.run(["somato", "explore", "--body", "hardness", "--explorations", "1", "-o", "x.mcap"],
               check=True)
PYTHON
# python_of VERSION: its interpreter, or nothing.
python_of() {
  local candidate
  for candidate in "python$1" "${PYENV_ROOT:-$HOME/.pyenv}"/versions/"$1".*/bin/python3; do
    if "$candidate" -c 'import ensurepip' 2>/dev/null; then
      echo "$candidate"
      return
    fi
  done
}

passed=()
for version in 3.10 3.11 3.12 3.13; do
  python=$(python_of "$version")
  if [[ -z $python ]]; then
    echo "Python $version is not on this machine: not tested"
    continue
  fi
  "$python" -m venv "$work/$version"
  "$work/$version/bin/pip" install --quiet "$folder"/*.whl
  (cd "$work" && PATH=$work/$version/bin:$PATH "$work/$version/bin/python" use.py)
  passed+=("$version")
  echo "passed with Python $version"
done
[[ ${#passed[@]} -gt 0 ]]
