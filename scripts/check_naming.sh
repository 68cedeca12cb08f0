#!/usr/bin/env bash
# Checks names against .clang-tidy: scripts/check_naming.sh COMMIT looks at the files that differ from that commit,
# scripts/check_naming.sh --all at all of them (half an hour of processor time). Needs no build. Other releases of clang-tidy
# judge otherwise, so only the one of Debian 12 is asked.
set -eu -o pipefail
cd "$(dirname "$0")/.."

if ! clang-tidy --version 2>/dev/null | grep -q 'version 14\.'; then
    echo "skipped: no clang-tidy 14"
    exit 0
fi
case "${1:-}" in
--all) files=$(git ls-files) ;;
"") echo "usage: scripts/check_naming.sh COMMIT|--all" >&2; exit 2 ;;
*) files=$(git diff --name-only --diff-filter=d "$1") ;;
esac
files=$(grep -E '^(apps|bench|examples|include|src|tests)/.*\.[ch]pp$' <<<"$files" || true)
[ -n "$files" ] || { echo "no file to check the names of"; exit 0; }

# Headers are read as if they were sources. What is included is not judged.
check() {
    clang-tidy --quiet "$1" -- -x c++ -std=c++20 -Isrc -Iinclude -Iapps/cli -Itests -isystem /usr/include/eigen3 \
        '-DSPECTRALPACK_VERSION="0"' '-DSPECTRALPACK_SOURCE_DIR="."' '-DSPECTRALPACK_PROGRAM="."' 2>&1 |
        { grep -E '(error|warning):' || true; } | tee /dev/stderr | { ! grep -q .; }
}
export -f check
xargs -d '\n' -P "$(nproc)" -I{} bash -c 'check {}' <<<"$files" || { echo "names above are not as .clang-tidy says" >&2; exit 1; }
echo "names of $(wc -l <<<"$files") files are as .clang-tidy says"
