"""Many at once."""

import concurrent.futures
import threading
import time

from conftest import SAMPLES, sample_job
from test_lives import ended, lines_of


def test_two_hundred_requests_at_once(server):
    job = sample_job(server)
    with concurrent.futures.ThreadPoolExecutor(200) as crowd:
        answers = list(crowd.map(lambda _: server.get(f"/api/jobs/{job}").status, range(200)))
    assert answers == [200] * 200


def test_eight_pages_watch_one_job(server):
    job = sample_job(server, voxel=1)
    seen = [None] * 8

    def watch(i):
        seen[i] = [event[1] for event in lines_of(server, job, ended) if event[0] == "line" and "event" in event[1]]

    watchers = [threading.Thread(target=watch, args=(i,)) for i in range(8)]
    for watcher in watchers:
        watcher.start()
    server.ask("POST", f"/api/jobs/{job}/start")
    for watcher in watchers:
        watcher.join(120)
    assert seen[0] and all(one == seen[0] for one in seen)


def test_a_thousand_jobs(server):
    for i in range(1000):
        server.new_job(name=f"job {i:04}")
    begun = time.monotonic()
    listed = server.get("/api/jobs?most=1000").json
    assert listed["total"] == 1000 and len(listed["jobs"]) == 1000
    assert time.monotonic() - begun < 10
    server.stop()
    server.start()
    assert server.get("/api/jobs?find=0777").json["jobs"][0]["name"] == "job 0777"


def test_a_hundred_files_at_once(server):
    job = server.new_job()
    data = (SAMPLES / "gear.stl").read_bytes()
    with concurrent.futures.ThreadPoolExecutor(6) as crowd:
        statuses = list(crowd.map(lambda i: server.put_file(job, f"gear-{i}.stl", data).status, range(100)))
    assert statuses == [201] * 100
    assert len(server.parts(job)["meshes"]) == 100
