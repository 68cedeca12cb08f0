#!/usr/bin/env bash
# Makes the reference of the public headers, build/reference/html/index.html. A warning is an error.
set -eu -o pipefail
cd "$(dirname "$0")/.."
command -v doxygen >/dev/null || { echo "skipped: no doxygen"; exit 0; }
mkdir -p build/reference
doxygen docs/Doxyfile
echo "reference: build/reference/html/index.html"
