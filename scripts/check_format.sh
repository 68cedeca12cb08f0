#!/usr/bin/env bash
# Checks that the code is formatted as .clang-format says (clang-format -i mends it). Other releases of clang-format break
# lines elsewhere, so only the one of Debian 12 is asked.
set -eu -o pipefail
cd "$(dirname "$0")/.."

if ! clang-format --version 2>/dev/null | grep -q 'version 14\.'; then
    echo "skipped: no clang-format 14"
    exit 0
fi
find apps bench fuzz include python src tests \( -name '*.cpp' -o -name '*.hpp' -o -name '*.h' \) -print0 |
    xargs -0 clang-format --dry-run --Werror
echo "formatted as .clang-format says"
