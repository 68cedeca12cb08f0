#!/usr/bin/env bash
# Builds and runs all tests but the long ones (ctest label "long": scripts/test.sh -L long runs those).
set -u -o pipefail
cd "$(dirname "$0")/.." || exit 1
. scripts/packages.sh

install_missing $packages $test_packages || exit 1
log=build/build-tests.log
mkdir -p build
echo "Building the tests (log in $log) ..."
if ! { cmake --preset release -DSPECTRALPACK_TESTS=ON -DSPECTRALPACK_PYTHON=ON \
    -DPython3_EXECUTABLE=/usr/bin/python3 -DSPECTRALPACK_WERROR=${SPECTRALPACK_WERROR:-OFF} && cmake --build build; } >"$log" 2>&1; then
    grep -E 'error|Error' "$log" | head -n 20 >&2
    echo "The build failed; the whole log is $log." >&2
    exit 1
fi
[ $# -eq 0 ] && set -- -LE long
ctest --test-dir build --output-on-failure -j "$(nproc)" "$@"
