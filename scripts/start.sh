#!/usr/bin/env bash
# From a fresh clone to a packed tray: installs what is missing, builds, packs the sample parts.
set -u -o pipefail
cd "$(dirname "$0")/.." || exit 1
. scripts/packages.sh

install_missing $packages || exit 1
log=build/build.log
mkdir -p build out
echo "Building (the first time takes a few minutes; log in $log) ..."
if ! { cmake --preset release -DSPECTRALPACK_TESTS=OFF && cmake --build build --target spectralpack spectralpack-server; } >"$log" 2>&1; then
    grep -E 'error|Error' "$log" | head -n 10 >&2
    echo "The build failed; the whole log is $log. Removing the folder build and trying again may help." >&2
    exit 1
fi
build/apps/cli/spectralpack pack data/samples/samples.csv --tray 160x120x100 --voxel 1 --gap 1 \
    -o out/samples.3mf -o out/samples.json -o out/samples.png || exit
build/apps/cli/spectralpack check out/samples.json || exit
echo
echo "Look at out/samples.png, open out/samples.3mf in your slicer, and then pack parts of your own:"
echo "  build/apps/cli/spectralpack serve        # in the browser"
echo "  build/apps/cli/spectralpack pack MY_PARTS/ bracket.stl:12 --tray 480x245x200 --gap 1 -o build.3mf -o build.png"
