#!/usr/bin/env bash
# scripts/check_install.sh BUILD: installs a built tree into an empty prefix, and builds and runs examples/ against what
# lies there, with find_package and once with pkg-config.
set -eu -o pipefail
cd "$(dirname "$0")/.."
build=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/prefix" >/dev/null
"$work/prefix/bin/spectralpack" --version
if ldd "$work/prefix/bin/spectralpack" | grep -i fftw; then
    echo "the installed spectralpack links FFTW, which is GPL" >&2
    exit 1
fi
if [ -e "$work/prefix/bin/spectralpack-reference" ]; then
    "$work/prefix/bin/spectralpack-reference" pack data/samples/box.stl:2 --tray 80x80x80 --voxel 4 --engine reference \
        --progress none -o "$work/two.json" >/dev/null
fi

scripts/check_serve.sh "$work/prefix/bin/spectralpack"

# A copy, so that nothing is found because it lies in this tree.
cp -r examples "$work/examples"
cmake -S "$work/examples" -B "$work/examples/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$work/prefix" >/dev/null
cmake --build "$work/examples/build" | tail -n 1
"$work/examples/build/pack_boxes" >"$work/boxes.txt"
grep -q '^0 found no place' "$work/boxes.txt" || { cat "$work/boxes.txt"; exit 1; }
"$work/examples/build/pack_files" "$work/samples.3mf" data/samples/samples.csv

export PKG_CONFIG_PATH="$work/prefix/lib/pkgconfig:$work/prefix/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)/pkgconfig"
g++ -std=c++20 examples/pack_boxes.cpp $(pkg-config --cflags --libs spectralpack) -o "$work/pack_boxes"
"$work/pack_boxes" | cmp - "$work/boxes.txt"
echo "installed: the examples build and run"
