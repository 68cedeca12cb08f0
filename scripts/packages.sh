# Sourced by the other scripts: makes sure that the Debian packages named in `packages` are installed, asking apt
# only for what is missing. docs/dependencies.md says what each is for.

packages="g++ cmake ninja-build pkg-config python3
    libfftw3-dev libtbb-dev libembree-dev libfcl-dev libcli11-dev libfmt-dev nlohmann-json3-dev libhwy-dev
    libzip-dev libexpat1-dev libfast-float-dev libpng-dev libstb-dev libxxhash-dev libqhull-dev libmeshoptimizer-dev
    libboost-dev"
python_packages="pybind11-dev python3-dev python3-venv python3-setuptools python3-wheel python3-numpy"
test_packages="libgtest-dev librapidcheck-dev $python_packages python3-pytest python3-hypothesis python3-jsonschema"
attack_packages="libcgal-dev"

# install_missing PACKAGE...
install_missing() {
    local missing="" package
    for package in "$@"; do
        dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing="$missing $package"
    done
    [ -z "$missing" ] && return 0
    echo "Installing:$missing"
    local as_root=""
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || { echo "Not root and no sudo. As root, run: apt-get install$missing" >&2; return 1; }
        as_root=sudo
    fi
    command -v apt-get >/dev/null || { echo "No apt-get here. Install the equivalents of:$missing" >&2; return 1; }
    # The list of packages may be old or absent on a fresh machine.
    $as_root apt-get update -q >/dev/null 2>&1
    if ! $as_root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 install -y -q --no-install-recommends $missing >/tmp/spectralpack-apt.log 2>&1; then
        tail -n 5 /tmp/spectralpack-apt.log >&2
        echo "Installing failed (whole log: /tmp/spectralpack-apt.log). Try: apt-get update && apt-get install$missing" >&2
        return 1
    fi
}
