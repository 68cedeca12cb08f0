"""Jobs outlive pages, servers and their own crashes."""

import http.client
import json
import os
import signal
import time

from conftest import long_job, sample_job


def lines_of(server, job, until, last=None, seconds=60):
    """Events of a job as (kind, data, id), until one of which `until` is true."""
    connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=seconds)
    connection.request("GET", f"/api/jobs/{job}/events", headers={"Last-Event-ID": last} if last else {})
    response = connection.getresponse()
    assert response.getheader("Content-Type") == "text/event-stream"
    events, fields = [], {}
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        line = response.readline().decode().rstrip("\n")
        if line:
            name, _, value = line.partition(": ")
            fields[name] = value
            continue
        if "event" in fields:
            events.append((fields["event"], json.loads(fields["data"]), fields.get("id")))
            if until(events[-1]):
                break
        fields = {}
    connection.close()
    return events


def ended(event):
    return event[0] == "state" and event[1]["status"] in ("done", "cancelled", "failed", "interrupted")


def placed(event):
    return event[0] == "line" and event[1].get("event") == "copy_placed"


def test_a_page_sees_it_happen_and_one_that_comes_later_catches_up(server):
    job = sample_job(server)
    server.ask("POST", f"/api/jobs/{job}/start")
    live = lines_of(server, job, ended)
    assert live[0][0] == "state" and live[-1][1]["summary"]["placed"] == 15
    assert len([one for one in live if placed(one)]) == 15
    later = lines_of(server, job, lambda event: event[0] == "line" and event[1].get("phase") == "check")
    assert [one[1] for one in later if one[0] == "line"] == [one[1] for one in live if one[0] == "line"]
    # One that was cut off goes on behind what it has seen.
    places = [one for one in later if placed(one)]
    rest = lines_of(server, job, lambda event: event[0] == "line" and event[1].get("phase") == "check", places[9][2])
    assert [one[1] for one in rest if placed(one)] == [one[1] for one in places[10:]]


def test_a_new_run_is_told(server):
    job = sample_job(server)
    server.ask("POST", f"/api/jobs/{job}/start")
    first = lines_of(server, job, ended)
    last = [one[2] for one in first if one[2]][-1]
    server.ask("POST", f"/api/jobs/{job}/start")
    second = lines_of(server, job, ended, last)
    assert any(one[0] == "anew" for one in second)
    assert len([one for one in second if placed(one)]) == 15


def test_cancel_keeps_the_best_so_far(server):
    job = long_job(server)
    server.ask("POST", f"/api/jobs/{job}/start")
    lines_of(server, job, placed)
    time.sleep(1)
    server.ask("POST", f"/api/jobs/{job}/cancel")
    state = server.wait(job)
    assert state["status"] == "cancelled" and state["has_packing"] and 0 < state["summary"]["placed"] < 1600
    assert state["verdict"]["ok"]


def test_one_packs_and_the_others_wait(server):
    first, second, third = long_job(server), sample_job(server), sample_job(server)
    for job in (first, second, third):
        server.ask("POST", f"/api/jobs/{job}/start")
    assert server.wait(first, "running")
    assert server.get(f"/api/jobs/{second}").json["queue_place"] == 1
    assert server.get(f"/api/jobs/{third}").json["queue_place"] == 2
    assert server.ask("POST", f"/api/jobs/{second}/cancel").json["status"] == "new"
    assert server.get(f"/api/jobs/{third}").json["queue_place"] == 1
    server.ask("DELETE", f"/api/jobs/{first}")
    assert server.wait(third)["status"] == "done"


def test_a_server_that_is_killed_finds_its_jobs_again(server):
    """The run goes on; the next server sees it, and its end."""
    job = long_job(server, copies=60)
    waiting = sample_job(server)
    server.ask("POST", f"/api/jobs/{job}/start")
    server.ask("POST", f"/api/jobs/{waiting}/start")
    lines_of(server, job, placed)
    server.stop(signal.SIGKILL)
    server.start()
    assert server.get(f"/api/jobs/{job}").json["status"] == "running"
    state = server.wait(job)
    assert state["status"] == "done" and state["summary"]["placed"] == 240 and state["verdict"]["ok"]
    assert server.wait(waiting)["status"] == "done"


def test_a_run_that_is_killed_with_its_server_goes_on_where_it_was(server):
    job = long_job(server, copies=60)
    server.ask("POST", f"/api/jobs/{job}/start")
    lines_of(server, job, lambda event: placed(event) and event[1]["copy"] > 20)
    process = json.loads((server.folder / job / "run" / "process.json").read_text())["process"]
    server.stop(signal.SIGKILL)
    os.killpg(process, signal.SIGKILL)
    server.start()
    assert server.get(f"/api/jobs/{job}").json["status"] == "interrupted"
    assert server.ask("POST", f"/api/jobs/{job}/start").status == 202
    state = server.wait(job)
    assert state["status"] == "done" and state["summary"]["placed"] == 240
    assert any("goes on" in remark for remark in state["remarks"])


def test_a_crash_of_one_job_is_told_and_the_server_lives(server):
    job = long_job(server)
    server.ask("POST", f"/api/jobs/{job}/start")
    lines_of(server, job, placed)
    runner = json.loads((server.folder / job / "run" / "process.json").read_text())["process"]
    children = open(f"/proc/{runner}/task/{runner}/children").read().split()
    os.kill(int(children[0]), signal.SIGSEGV)
    state = server.wait(job)
    assert state["status"] == "failed" and "unexpectedly" in state["error"]
    other = sample_job(server)
    server.ask("POST", f"/api/jobs/{other}/start")
    assert server.wait(other)["status"] == "done"


def test_deleting_a_job_ends_its_run(server):
    job = long_job(server)
    server.ask("POST", f"/api/jobs/{job}/start")
    lines_of(server, job, placed)
    runner = json.loads((server.folder / job / "run" / "process.json").read_text())["process"]
    assert server.ask("DELETE", f"/api/jobs/{job}").status == 204
    end = time.monotonic() + 10
    while os.path.exists(f"/proc/{runner}") and time.monotonic() < end:
        time.sleep(0.05)
    assert not os.path.exists(f"/proc/{runner}")
    assert not (server.folder / job).exists()
