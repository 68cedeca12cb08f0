"""A packing that is done is changed by hand, packed on, made better, and gone back from."""

import concurrent.futures
import copy
import signal
import time

from conftest import long_job, sample_job


def packed(server, **options):
    job = sample_job(server, **options)
    server.ask("POST", f"/api/jobs/{job}/start")
    state = server.wait(job)
    assert state["status"] == "done" and state["verdict"]["ok"]
    return job, state


def packing_of(server, job):
    return server.get(f"/api/jobs/{job}/packing.json").json


def stand(server, job):
    """Where each copy stands: by part and copy."""
    placements = packing_of(server, job)["trays"][0]["placements"]
    return {(one["part"], one["copy"]): one["transform"] for one in placements}


def change(server, job, *changes):
    said = [{"tray": 1, "part": part, "copy": number, "transform": transform} for part, number, transform in changes]
    return server.ask("POST", f"/api/jobs/{job}/change", {"changes": said})


def moved(transform, x=0, y=0, z=0):
    there = copy.deepcopy(transform)
    for row, step in enumerate((x, y, z)):
        there[row][3] += step
    return there


def test_a_copy_is_taken_out_and_put_back(server):
    job, state = packed(server)
    before = stand(server, job)
    first = next(iter(before))
    answer = change(server, job, (*first, None))
    assert answer.status == 202 and answer.json["status"] == "running"
    after = server.wait(job)
    assert after["status"] == "done" and after["verdict"]["ok"] and after["verdict"]["apart"] == "checked"
    assert after["summary"]["placed"] == state["summary"]["placed"] - 1
    assert after["revision"] == state["revision"] + 1 and after["revisions"] == [state["revision"]]
    left = [one for one in packing_of(server, job)["unplaced"] if (one["part"], one["copy"]) == first]
    assert left[0]["reason"] == "not_tried" and left[0]["detail"] == "taken out by hand"
    assert server.get(f"/api/jobs/{job}/packing.3mf").body[:2] == b"PK"

    assert change(server, job, (*first, before[first])).status == 202
    assert server.wait(job)["summary"]["placed"] == state["summary"]["placed"]
    assert stand(server, job) == before


def test_what_is_asked_while_a_packing_changes_is_answered(server):
    job, _ = packed(server)
    first = next(iter(stand(server, job)))
    with concurrent.futures.ThreadPoolExecutor(20) as crowd:
        changing = crowd.submit(change, server, job, (*first, None))
        time.sleep(0.02)
        asked = [crowd.submit(server.get, f"/api/jobs/{job}/clearance?tray=1&placement={i % 5}") for i in range(16)]
        assert changing.result().status == 202
        assert {one.result().status for one in asked} == {200}
    assert server.wait(job)["verdict"]["ok"]


def test_a_copy_moves_where_it_is_clear_and_nowhere_else(server):
    job, _ = packed(server, tray=[200, 200, 100])
    before = stand(server, job)
    top = max(before, key=lambda one: before[one][2][3])
    up = moved(before[top], z=2)
    asked = {"tray": 1, "part": top[0], "copy": top[1], "transform": up}
    clear = server.ask("POST", f"/api/jobs/{job}/clearance", asked).json
    assert clear["clear"] and clear["nearest"]["distance"] >= 1 - 1e-3 and clear["nearest"]["gap"] == 1
    assert clear["next"]["distance"] >= clear["nearest"]["distance"] and clear["wall"]["gap"] == 0
    assert change(server, job, (*top, up)).status == 202
    assert server.wait(job)["verdict"]["ok"]
    assert stand(server, job) == {**before, top: up}

    # Onto another copy, out of the tray: refused in words, and nothing has changed.
    other = next(one for one in before if one != top)
    for there in (before[other], moved(up, x=-500)):
        asked["transform"] = there
        assert not server.ask("POST", f"/api/jobs/{job}/clearance", asked).json["clear"]
        refused = change(server, job, (*top, there))
        assert refused.status == 400 and len(refused.json["error"]) > 10
    assert stand(server, job) == {**before, top: up}
    # Where that copy goes first, it is free.
    asked["transform"] = up
    asked["changes"] = [{"tray": 1, "part": other[0], "copy": other[1], "transform": None}]
    answer = server.ask("POST", f"/api/jobs/{job}/clearance", asked).json
    assert answer["clear"] and (answer["nearest"]["part"], answer["nearest"]["copy"]) != other


def test_changes_that_make_no_sense_are_refused(server):
    job, _ = packed(server)
    one = next(iter(stand(server, job)))
    good = {"tray": 1, "part": one[0], "copy": one[1], "transform": None}
    for bad in ([], [{}], "all", [{**good, "tray": 9}], [{**good, "part": -1}], [{**good, "copy": 10 ** 6}],
                [{**good, "transform": [[1, 0, 0, 0]]}], [{**good, "transform": 3}], [{**good, "part": "0"}],
                [{**good, "transform": [[2, 0, 0, 9], [0, 1, 0, 9], [0, 0, 1, 9], [0, 0, 0, 1]]}], [good, good]):
        answer = server.ask("POST", f"/api/jobs/{job}/change", {"changes": bad})
        assert answer.status == 400, bad
    for bad in ({"keep": []}, {"keep": "some"}, {"keep": [{"tray": 0}]}, {"improve": 0}, {"improve": "long"},
                {"keep": "all", "improve": 5}, {"output": "/etc/passwd"}, []):
        assert server.ask("POST", f"/api/jobs/{job}/start", bad).status == 400, bad
    assert server.ask("POST", f"/api/jobs/{job}/revert", {"revision": 77}).status == 404
    fresh = sample_job(server)
    assert server.ask("POST", f"/api/jobs/{fresh}/change", {"changes": [good]}).status == 404
    assert server.ask("POST", f"/api/jobs/{fresh}/start", {"keep": "all"}).status == 409
    assert server.ask("POST", f"/api/jobs/{fresh}/start", {"improve": 5}).status == 409
    assert server.get(f"/api/jobs/{job}").json["status"] == "done"


def test_two_changes_at_once_do_not_lose_each_other(server):
    job, _ = packed(server)
    first, second = list(stand(server, job))[:2]
    assert change(server, job, (*first, None)).status == 202
    assert change(server, job, (*second, None)).status == 409  # the first is still checked
    server.wait(job)
    assert change(server, job, (*second, None)).status == 202
    server.wait(job)
    assert not {first, second} & set(stand(server, job))


def test_locked_copies_stay_and_the_rest_is_packed_again(server):
    job, state = packed(server)
    before = stand(server, job)
    locked = list(before)[:4]
    keep = [{"tray": 1, "part": part, "copy": number} for part, number in locked]
    assert server.ask("POST", f"/api/jobs/{job}/start", {"keep": keep}).status == 202
    after = server.wait(job)
    assert after["status"] == "done" and after["verdict"]["ok"] and after["verdict"]["apart"] == "checked"
    assert after["summary"]["placed"] == state["summary"]["placed"] and not after["can_improve"]
    now = stand(server, job)
    assert all(now[one] == before[one] for one in locked)


def test_more_copies_are_added_to_what_stands(server):
    job, state = packed(server, tray=[200, 200, 200])
    before = stand(server, job)
    said = server.get(f"/api/jobs/{job}/job.json").json
    for part in said["parts"]:
        part["count"] += 1
    server.ask("PUT", f"/api/jobs/{job}/job.json", said)
    server.ask("POST", f"/api/jobs/{job}/start", {"keep": "all"})
    after = server.wait(job)
    assert after["summary"]["placed"] == state["summary"]["placed"] + len(said["parts"])
    now = stand(server, job)
    assert {one: now[one] for one in before} == before


def test_what_finds_no_place_beside_what_stays_leaves_all_as_it_was(server):
    job, state = packed(server)
    before = stand(server, job)
    server.ask("POST", f"/api/jobs/{job}/start", {"keep": "all"})
    after = server.wait(job)
    assert after["status"] == "failed" and "no copy fits" in after["error"]
    assert after["has_packing"] and after["verdict"]["ok"] and stand(server, job) == before


def test_it_goes_on_improving_and_never_gets_worse(server):
    job, state = packed(server, **{"open-height": True}, tray=[110, 100, 300])
    assert state["can_improve"] and state["summary"]["improvement"] is None
    server.ask("POST", f"/api/jobs/{job}/start", {"improve": 3})
    first = server.wait(job)
    assert first["status"] == "done" and first["verdict"]["ok"] and first["can_improve"]
    assert first["summary"]["height"] <= state["summary"]["height"]
    steps = first["summary"]["improvement"]["steps"]
    assert steps > 0
    server.ask("POST", f"/api/jobs/{job}/start", {"improve": 3})
    second = server.wait(job)
    assert second["summary"]["height"] <= first["summary"]["height"]
    assert second["summary"]["improvement"]["steps"] > steps, "it went on from where it was"
    assert second["summary"]["improvement"]["seconds"] > 4
    lines = server.folder.joinpath(job, "run", "events.jsonl").read_text().splitlines()
    assert any('"improve"' in line and '"now"' in line for line in lines)


def test_a_box_that_holds_all_becomes_lower(server):
    job, state = packed(server)
    server.ask("POST", f"/api/jobs/{job}/start", {"improve": 3})
    after = server.wait(job)
    assert after["status"] == "done" and after["verdict"]["ok"]
    assert after["summary"]["improvement"]["what"] == "height", "the better one is kept"
    assert after["summary"]["height"] <= state["summary"]["height"]


def test_what_waits_in_the_queue_has_its_packing_until_its_turn(server):
    job, state = packed(server)
    before = stand(server, job)
    busy = long_job(server)
    server.ask("POST", f"/api/jobs/{busy}/start")
    for how in ({"improve": 5}, {"keep": "all"}, None):
        waiting = server.ask("POST", f"/api/jobs/{job}/start", how)
        assert waiting.status == 202 and waiting.json["status"] == "queued"
        server.ask("POST", f"/api/jobs/{job}/cancel")
        called_off = server.get(f"/api/jobs/{job}").json
        assert called_off["status"] == "done" and called_off["verdict"]["ok"]
        assert called_off["revision"] == state["revision"] and stand(server, job) == before
    server.ask("DELETE", f"/api/jobs/{busy}")


def test_improving_is_stopped_and_keeps_the_best(server):
    job, state = packed(server, **{"open-height": True}, tray=[110, 100, 300])
    server.ask("POST", f"/api/jobs/{job}/start", {"improve": 600})
    events = server.folder.joinpath(job, "run", "events.jsonl")
    end = time.monotonic() + 60
    while time.monotonic() < end and not (events.exists() and '"improve"' in events.read_text()):
        time.sleep(0.1)
    time.sleep(1)
    server.ask("POST", f"/api/jobs/{job}/cancel")
    after = server.wait(job)
    assert after["status"] == "cancelled" and after["verdict"]["ok"] and after["can_improve"]
    assert after["summary"]["placed"] == state["summary"]["placed"]
    assert after["summary"]["height"] <= state["summary"]["height"]


def test_earlier_packings_are_gone_back_to(server):
    job, state = packed(server)
    before = stand(server, job)
    first = next(iter(before))
    change(server, job, (*first, None))
    server.wait(job)
    server.ask("POST", f"/api/jobs/{job}/start")
    again = server.wait(job)
    assert again["revisions"] == [1, 2] and again["revision"] == 3
    assert server.ask("POST", f"/api/jobs/{job}/revert", {"revision": 2}).status == 202
    back = server.wait(job)
    assert back["verdict"]["ok"] and back["revision"] == 4 and first not in stand(server, job)
    server.ask("POST", f"/api/jobs/{job}/revert", {"revision": 1})
    server.wait(job)
    assert stand(server, job) == before


def test_the_server_is_killed_while_a_change_is_checked(start_server):
    server = start_server()
    job, _ = packed(server)
    first = next(iter(stand(server, job)))
    change(server, job, (*first, None))
    server.stop(signal.SIGKILL)
    server.start()
    after = server.wait(job)
    assert after["status"] == "done" and after["verdict"]["ok"] and first not in stand(server, job)
