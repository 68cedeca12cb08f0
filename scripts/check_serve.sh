#!/usr/bin/env bash
# scripts/check_serve.sh SPECTRALPACK: that program's page is there, and packs the sample.
set -eu -o pipefail
work=$(mktemp -d)
"$1" serve --dir "$work/jobs" --no-browser >"$work/said" 2>&1 &
server=$!
trap 'kill $server 2>/dev/null; wait $server 2>/dev/null || true; rm -rf "$work"' EXIT
for _ in $(seq 100); do
    at=$(grep -o 'http://[0-9.:]*' "$work/said" || true)
    [ -n "$at" ] && break
    sleep 0.1
done
[ -n "$at" ] || { cat "$work/said" >&2; exit 1; }
/usr/bin/python3 - "$at" <<'PYTHON'
import json, sys, time, urllib.request

def ask(path, body=None):
    sent = None if body is None else json.dumps(body).encode()
    with urllib.request.urlopen(sys.argv[1] + path, sent, timeout=60) as answer:
        return answer.read()

assert b"<script" in ask("/")
job = json.loads(ask("/api/jobs", {"sample": True}))["id"]
ask(f"/api/jobs/{job}/start", {})
end = time.monotonic() + 120
while json.loads(ask(f"/api/jobs/{job}"))["status"] in ("queued", "running") and time.monotonic() < end:
    time.sleep(0.2)
state = json.loads(ask(f"/api/jobs/{job}"))
assert state["status"] == "done" and state["verdict"]["ok"], state
assert ask(f"/api/jobs/{job}/packing.3mf")[:2] == b"PK"
print(f"serve: the sample is packed, {state['summary']['placed']} of {state['summary']['copies']} copies")
PYTHON
