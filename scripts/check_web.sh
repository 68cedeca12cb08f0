#!/usr/bin/env bash
# The page: its types, its style, its tests, the description of the interface, and that web/dist is what web/ builds to. With
# `--browser` also in a browser, with the program in the build folder that follows. Needs Node from 18 on and, once, its
# packages from the registry; where they cannot be had it says 'skipped'.
set -eu -o pipefail
cd "$(dirname "$0")/../web"

command -v npm >/dev/null || { echo "skipped: the page's checks need Node and npm"; exit 0; }
if [ ! -d node_modules ] || [ package-lock.json -nt node_modules ]; then
    npm ci --no-audit --no-fund >/tmp/spectralpack-npm.log 2>&1 || {
        tail -n 3 /tmp/spectralpack-npm.log
        echo "skipped: the page's packages cannot be had here"
        exit 0
    }
fi
npm run --silent lint
npm run --silent types
npm run --silent test
kept=$(mktemp -d)
trap 'rm -rf "$kept"' EXIT
cp src/api/schema.d.ts "$kept/"
npm run --silent api >/dev/null
cmp -s src/api/schema.d.ts "$kept/schema.d.ts" || { echo "src/api/schema.d.ts is not what 'npm run api' makes" >&2; exit 1; }
npm run --silent build -- --outDir "$kept/dist" --logLevel warn
diff -rq dist "$kept/dist" || { echo "web/dist is not what 'npm run build' makes" >&2; exit 1; }
echo "the page is as its sources say"
if [ "${1:-}" = --browser ]; then
    browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
    [ -n "$browser" ] || { echo "skipped: no Chromium to try the page in"; exit 0; }
    SPECTRALPACK_BUILD=$(realpath "../$2") CHROMIUM=$browser npm run --silent browser
fi
