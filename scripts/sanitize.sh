#!/usr/bin/env bash
# scripts/sanitize.sh PART...: what looks longer than continuous integration always has time for.
#
#   parsers address and undefined-behaviour sanitizers over what reads files and makes meshes and voxels of them
#   rooms   the same over all rooms' own tests (search, packing, disassembly, ... too)
#   whole   the same over all tests, runs of the program and the server among them
#   threads ThreadSanitizer over core, search and packing
#   scalar  the fast engine's tests without vector instructions
#   alone   every file compiled by itself, so that none leans on what another includes
set -eu -o pipefail
cd "$(dirname "$0")/.."
. scripts/building.sh

tests() {
    ctest --output-on-failure -j "$(nproc)" -LE long "$@" | grep -vE '^ *(Start |[0-9]+/[0-9]+ Test .* Passed )'
}
address() {
    # Lines are all of the debugging information that a report needs; the rest takes a fifth of the compiler's time.
    CC=clang CXX=clang++ cmake --preset asan -DSPECTRALPACK_UNITY=ON -DPython3_EXECUTABLE=/usr/bin/python3 \
        -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O2 -gline-tables-only" >/dev/null
}

for part in "$@"; do
    echo "== sanitize: $part"
    case "$part" in
    parsers)
        address
        build build-asan --target test_core test_geometry test_model test_formats test_voxel
        tests --test-dir build-asan -R '^(core|geometry|model|formats|voxel)\.'
        ;;
    rooms)
        address
        build build-asan --target test_core test_geometry test_model test_formats test_voxel test_refine test_search \
            test_disassembly test_packing test_verify test_render
        tests --test-dir build-asan -R '^(core|geometry|geometry_.*|model|formats|voxel|refine|search|disassembly|packing|verify|render)\.' \
            -E 'AnswersTheDefinitionWhileASpeck|_NOT_BUILT'
        ;;
    whole)
        address
        build build-asan
        tests --test-dir build-asan
        ;;
    threads)
        cmake --preset tsan -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" -DSPECTRALPACK_UNITY=ON >/dev/null
        build build-tsan --target test_core test_search test_packing
        # A speck that comes and goes asks the definition 80 times, which takes ten minutes here.
        TSAN_OPTIONS="suppressions=$PWD/scripts/tsan.supp halt_on_error=1 history_size=4" RC_PARAMS="max_success=15" \
            tests --test-dir build-tsan -E ASpeckComesAndGoes \
            -R '^core\.|^search\.(CpuSearch|VerifyingSearch|Tray)\.|^packing\.(Greedy|ManyTrays|Interlocking|UnlinkedSearch|ReachableSearch|TrayObserver|ShapeStore)\.'
        ;;
    scalar)
        cmake -S . -B build-scalar -G Ninja -DSPECTRALPACK_SCALAR_ONLY=ON -DSPECTRALPACK_WERROR=ON >/dev/null
        build build-scalar --target test_search
        build-scalar/tests/search/test_search --gtest_brief=1 --gtest_filter='*Search.*:*Tables.*:Lookups.*:Loads.*:Cells.*:Depths.*:DistanceGrid.*:Kernels.*:Engines/*'
        ;;
    alone)
        cmake --preset dev -DSPECTRALPACK_TESTS=OFF >/dev/null
        build build-dev
        ;;
    *)
        echo "there is no part $part: parsers, rooms, whole, threads, scalar, alone" >&2
        exit 2
        ;;
    esac
done
