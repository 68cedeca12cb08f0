#!/usr/bin/env bash
# scripts/check_packages.sh BUILD: makes the Debian packages of a built tree, looks into them and runs what is in them.
set -eu -o pipefail
cd "$(dirname "$0")/.."
build=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

(cd "$build" && cpack -B "$work/packages" >"$work/cpack.log") || { cat "$work/cpack.log"; exit 1; }
for package in spectralpack libspectralpack-dev spectralpack-reference python3-spectralpack; do
    file=$(echo "$work/packages/${package}"_*.deb)
    dpkg -I "$file" | grep -E '^ (Package|Depends|Installed-Size):'
    dpkg -c "$file" >"$work/$package.list"
    depends=$(dpkg-deb -f "$file" Depends)
    case "$package" in
    spectralpack) holds=usr/bin/spectralpack-server ;;
    libspectralpack-dev) holds=include/spectralpack/pack.hpp ;;
    spectralpack-reference) holds=usr/bin/spectralpack-reference ;;
    python3-spectralpack) holds=spectralpack/__init__.py ;;
    esac
    grep -q "$holds\$" "$work/$package.list" || { echo "$package lacks $holds" >&2; exit 1; }
    # FFTW, which is GPL, is for the reference package alone.
    case "$package,$depends" in
    spectralpack-reference,*libfftw3*) ;;
    spectralpack-reference,*) echo "$package does not depend on FFTW" >&2; exit 1 ;;
    *libfftw3*) echo "$package depends on FFTW" >&2; exit 1 ;;
    esac
    dpkg -x "$file" "$work/root"
done
for program in spectralpack spectralpack-reference; do
    "$work/root/usr/bin/$program" pack data/samples/box.stl:2 --tray 80x80x80 --voxel 4 --progress none \
        -o "$work/$program.json" >/dev/null
    "$work/root/usr/bin/$program" check "$work/$program.json"
done
scripts/check_serve.sh "$work/root/usr/bin/spectralpack"
if "$work/root/usr/bin/spectralpack" pack data/samples/box.stl:2 --engine reference -o "$work/none.json" 2>"$work/said"; then
    echo "the permissive program has the reference engine" >&2
    exit 1
fi
grep -q 'spectralpack-reference has' "$work/said"
PYTHONPATH="$work/root/usr/lib/python3/dist-packages" /usr/bin/python3 -c '
import spectralpack as sp
job = sp.Job(tray=(80, 80, 80), voxel=4)
job.add("data/samples/box.stl", count=2)
assert sp.pack(job).check().ok'
echo "packages: their programs run"
