#!/usr/bin/env bash
# Attacks the program for MINUTES (10): kills runs and lets them go on, packs random jobs, has them judged by two
# verifiers. docs/reliability.md says more. Tables and what was found go to FOLDER (out/attack); exit status 1 if
# anything was found. scripts/attack.sh [MINUTES [FOLDER [SEED]]]
set -u -o pipefail
cd "$(dirname "$0")/.." || exit 2
. scripts/packages.sh

install_missing $packages $test_packages $attack_packages || exit 2
log=build/build-attack.log
mkdir -p build
echo "Building (log in $log) ..."
if ! { cmake --preset release -DSPECTRALPACK_TESTS=ON && cmake --build build --target spectralpack second_check; } >"$log" 2>&1; then
    grep -E 'error|Error' "$log" | head -n 20 >&2
    echo "The build failed; the whole log is $log." >&2
    exit 2
fi
exec python3 -B scripts/attack.py --program build/apps/cli/spectralpack --second build/tests/second/second_check \
    --schema docs/job.schema.json --minutes "${1:-10}" --out "${2:-out/attack}" ${3:+--seed "$3"}
