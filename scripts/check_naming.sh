#!/usr/bin/env bash
# Checks the names in all code but the tests against .clang-tidy. Reads the files as unity builds put them together, a dozen
# at a time: two minutes instead of half an hour. Nothing is compiled. Other releases of clang-tidy judge otherwise, so only
# the one of Debian 12 is asked.
set -eu -o pipefail
cd "$(dirname "$0")/.."

if ! clang-tidy --version 2>/dev/null | grep -q 'version 14\.'; then
    echo "skipped: no clang-tidy 14"
    exit 0
fi
cmake -S . -B build-names -G Ninja -DSPECTRALPACK_UNITY=ON -DSPECTRALPACK_TESTS=OFF \
    -DSPECTRALPACK_PYTHON=ON -DPython3_EXECUTABLE=/usr/bin/python3 >/dev/null
files=$(python3 -c '
import json
print("\n".join(sorted({entry["file"] for entry in json.load(open("build-names/compile_commands.json"))})))' |
    grep -v -e '/commit\.cpp$' -e '\.S$')
check() {
    local found
    found=$(clang-tidy --quiet -p build-names --header-filter="$PWD/(apps|include|python|src)/" "$1" 2>/dev/null |
        grep -E '(error|warning):' || true)
    [ -z "$found" ] || { echo "$found" >&2; return 1; }
}
export -f check
xargs -d '\n' -P "$(nproc)" -I{} bash -c 'check {}' <<<"$files" || { echo "names above are not as .clang-tidy says" >&2; exit 1; }
echo "names are as .clang-tidy says"
