#!/usr/bin/env bash
# scripts/check_python.sh BUILD: installs the Python package with pip as docs/python.md has it, building on in BUILD, and
# runs the examples with what was installed.
set -eu -o pipefail
cd "$(dirname "$0")/.."
build=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

/usr/bin/python3 -m venv --system-site-packages "$work/venv"
SPECTRALPACK_BUILD="$build" "$work/venv/bin/pip" install -q --no-build-isolation --no-deps . >"$work/log" 2>&1 ||
    { cat "$work/log"; exit 1; }
source=$PWD
cd "$work"
venv/bin/python -c 'import spectralpack; print("pip: spectralpack", spectralpack.__version__)'
for example in "$source"/examples/python/*.py; do
    venv/bin/python "$example" >"$work/said" 2>&1 || { cat "$work/said"; exit 1; }
done
for file in build.3mf build.png letter.png collision.png proximity.png; do
    [ -s "$file" ] || { echo "the examples wrote no $file" >&2; exit 1; }
done
venv/bin/python -m mypy --strict "$source"/examples/python/*.py
echo "python: installed with pip, and the examples run"
