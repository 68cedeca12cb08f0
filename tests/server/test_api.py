"""The whole way of a build over HTTP, as a script goes it (docs/server.md)."""

import io
import json
import subprocess
import zipfile

import pytest

from conftest import API, PROGRAM, SAMPLES, sample_job


def test_it_describes_itself(server):
    assert server.get("/openapi.json").json == API
    info = server.get("/api/info").json
    names = {option["name"]: option for option in info["options"]}
    assert names["voxel"]["here"] and names["voxel"]["help"]
    assert not names["output"]["here"] and not names["journal"]["here"] and not names["threads"]["here"]
    assert any(printer["size"][2] > 100 for printer in info["printers"])


def test_the_page_is_there(server):
    page = server.get("/", described=False)
    assert page.status == 200 and page.headers["Content-Type"].startswith("text/html")
    assert "script-src 'self'" in page.headers["Content-Security-Policy"]
    again = server.ask("GET", "/", headers={"If-None-Match": page.headers["ETag"]}, described=False)
    assert again.status == 304 and again.body == b""
    packed = server.ask("GET", "/", headers={"Accept-Encoding": "gzip"}, described=False)
    assert packed.headers["Content-Encoding"] == "gzip" and len(packed.body) < len(page.body)


def test_from_parts_to_a_file_that_check_accepts(server, tmp_path):
    job = sample_job(server)
    parts = server.parts(job)
    assert [mesh["name"] for mesh in parts["meshes"]] == ["bracket", "gear", "hook"]
    assert parts["meshes"][0]["size"] == pytest.approx([52, 32, 40])
    estimate = server.ask("POST", f"/api/jobs/{job}/estimate").json
    assert estimate["copies"] == 15 and estimate["seconds"] > 0
    assert server.get(f"/api/jobs/{job}").json["status"] == "new"

    assert server.ask("POST", f"/api/jobs/{job}/start").status == 202
    state = server.wait(job)
    assert state["status"] == "done", state
    assert state["summary"]["placed"] == 15 and state["verdict"]["ok"] and state["verdict"]["apart"] == "checked"
    assert state["has_picture"] and state["tray"] == "Box 160 × 120 × 100 mm"

    packing = server.get(f"/api/jobs/{job}/packing.json").json
    assert len(packing["trays"][0]["placements"]) == 15
    # Taken away as it is, with its meshes: the program's own check accepts it.
    (tmp_path / "files").mkdir()
    for part in packing["parts"]:
        name = part["mesh"].removeprefix("files/")
        (tmp_path / "files" / name).write_bytes(server.get(f"/api/jobs/{job}/files/{name}").body)
    (tmp_path / "packing.json").write_text(json.dumps(packing))
    subprocess.run([PROGRAM, "check", "--require-plan", tmp_path / "packing.json"], check=True, capture_output=True)

    threemf = server.get(f"/api/jobs/{job}/packing.3mf")
    assert "attachment" in threemf.headers["Content-Disposition"]
    assert "3D/3dmodel.model" in zipfile.ZipFile(io.BytesIO(threemf.body)).namelist()
    assert server.get(f"/api/jobs/{job}/packing.stl").body[80:84] != b"\0\0\0\0"
    assert server.get(f"/api/jobs/{job}/packing.csv").body.count(b"\n") >= 15
    assert server.get(f"/api/jobs/{job}/packing.png").body.startswith(b"\x89PNG")
    report = server.get(f"/api/jobs/{job}/packing.html")
    assert b"a few parts" in report.body and "sandbox" in report.headers["Content-Security-Policy"]
    assert server.get(f"/api/jobs/{job}/check").json["ok"]
    near = server.get(f"/api/jobs/{job}/clearance?tray=1&placement=3").json
    assert near["nearest"]["distance"] >= 1 - 1e-6 and near["wall"]["distance"] >= 0
    assert server.get(f"/api/jobs/{job}/picture.png", described=False).body.startswith(b"\x89PNG")


def test_trays_one_by_one(server):
    job = sample_job(server, tray=(90, 70, 60), trays="all")
    server.ask("POST", f"/api/jobs/{job}/start")
    state = server.wait(job)
    assert state["status"] == "done" and state["summary"]["trays"] > 1
    rows = [server.get(f"/api/jobs/{job}/packing.csv?tray={tray + 1}").body.count(b"\n")
            for tray in range(state["summary"]["trays"])]
    assert sum(rows) >= state["summary"]["placed"]
    assert server.get(f"/api/jobs/{job}/packing.csv?tray=99").status == 400


def test_meshes_to_look_at(server):
    job = sample_job(server)
    meshes = server.parts(job)["meshes"]
    bundle = server.get(f"/api/jobs/{job}/meshes.bin?detail=fine").body
    assert bundle[:4] == b"SPMB" and int.from_bytes(bundle[8:12], "little") == 3
    one = server.get(f"/api/jobs/{job}/meshes.bin?ids={meshes[1]['id']}").body
    assert int.from_bytes(one[8:12], "little") == 1 and int.from_bytes(one[12:16], "little") == meshes[1]["id"]
    assert int.from_bytes(one[20:24], "little") <= 1100  # triangles
    assert server.get(f"/api/jobs/{job}/meshes.bin?ids=x").status == 400
    assert server.get(f"/api/jobs/{job}/meshes.bin?detail=finest").status == 400


def test_rougher_meshes_are_smaller(server):
    job = sample_job(server)
    server.parts(job)
    rough, coarse, fine = (server.get(f"/api/jobs/{job}/meshes.bin?detail={detail}").body
                           for detail in ("rough", "coarse", "fine"))
    assert len(rough) < len(coarse) <= len(fine)
    assert rough[8:12] == coarse[8:12] == fine[8:12]
    # A job whose files an earlier version read has none: coarse ones stand for them.
    for path in (server.folder / job).glob("previews/*.rough"):
        path.unlink()
    assert server.get(f"/api/jobs/{job}/meshes.bin?detail=rough").body == coarse


def test_sets_and_job_files_are_read(server):
    job = server.new_job()
    server.put_file(job, "bracket.stl", (SAMPLES / "bracket.stl").read_bytes())
    server.put_file(job, "set.csv", b"mesh,count,scale\nparts/bracket.stl,7,1.5\nparts/gone.stl,2,1\n")
    said = {"format": "spectralpack/job", "version": 1, "parts": [{"mesh": "sub/bracket.stl", "count": 3}]}
    server.put_file(job, "order.json", json.dumps(said).encode())
    parts = server.parts(job)
    order, rows = parts["sets"]
    assert order["kind"] == "job" and order["job"]["parts"][0]["mesh"] == "bracket.stl"
    assert rows["rows"][0] == {"mesh": "bracket.stl", "name": rows["rows"][0]["name"], "count": 7, "scale": 1.5, "gap": None,
                               "priority": 0, "due": None}
    assert rows["missing"] == ["gone.stl"]


def test_bad_files_among_good_ones(server):
    job = server.new_job()
    whole = (SAMPLES / "bracket.stl").read_bytes()
    server.put_file(job, "good.stl", whole)
    server.put_file(job, "half.stl", whole[: len(whole) // 2])
    server.put_file(job, "cover.step", b"ISO-10303-21;")
    server.put_file(job, "noise.3mf", b"PK\x03\x04 this is no archive")
    parts = server.parts(job)
    assert [mesh["file"] for mesh in parts["meshes"]] == ["good.stl"]
    said = {bad["file"]: bad["error"] for bad in parts["bad"]}
    assert set(said) == {"half.stl", "cover.step", "noise.3mf"}
    assert said["cover.step"].startswith(".step files are not read")
    # Sent again under the same name, it is another.
    server.put_file(job, "half.stl", whole)
    assert {mesh["file"] for mesh in server.parts(job)["meshes"]} == {"good.stl", "half.stl"}


def test_jobs_are_listed_copied_renamed_and_deleted(server):
    sample = server.new_job(sample=True)
    assert len(server.parts(sample)["meshes"]) == 14
    assert server.ask("PATCH", f"/api/jobs/{sample}", {"name": "Week 48 · Größe"}).json["name"] == "Week 48 · Größe"
    copy = server.new_job(copy_of=sample)
    assert len(server.parts(copy)["meshes"]) == 14
    listed = server.get("/api/jobs?find=week").json
    assert listed["total"] == 2 and {job["id"] for job in listed["jobs"]} == {sample, copy}
    assert server.ask("DELETE", f"/api/jobs/{sample}").status == 204
    assert server.get(f"/api/jobs/{sample}").status == 404
    # What the copy shares with it is still there.
    assert server.get(f"/api/jobs/{copy}/files/gear.stl").body == (SAMPLES / "gear.stl").read_bytes()


def test_a_packing_from_elsewhere_is_shown(tmp_path, start_server):
    packing = tmp_path / "elsewhere" / "build.json"
    packing.parent.mkdir()
    ways = {"axes": ["+z", "-z"], "yaw": 90}
    asked = {"format": "spectralpack/job", "version": 1, "container": {"size": [120, 100, 60]},
             "parts": [{"mesh": str(SAMPLES / "gear.stl"), "count": 4, "orientations": ways}]}
    (tmp_path / "job.json").write_text(json.dumps(asked))
    subprocess.run([PROGRAM, "pack", tmp_path / "job.json", "-o", packing], check=True, capture_output=True)
    viewer = start_server(command=("view", packing))
    job = viewer.said.split("#/job/")[1].split("/")[0]
    state = viewer.wait(job)
    assert state["status"] == "done" and state["name"] == "build" and state["verdict"]["ok"] and state["has_picture"]
    shown = viewer.get(f"/api/jobs/{job}/packing.json").json
    assert shown["parts"][0]["mesh"] == "files/gear.stl" and len(shown["trays"][0]["placements"]) == 4
    # It can be packed again, and its parts may stand as before.
    assert viewer.get(f"/api/jobs/{job}/job.json").json["parts"][0]["orientations"] == ways
    assert viewer.ask("POST", f"/api/jobs/{job}/start").status == 202
    assert viewer.wait(job)["summary"]["placed"] == 4


def test_what_is_no_packing_is_not_shown(tmp_path):
    (tmp_path / "nonsense.json").write_text("{}")
    shown = subprocess.run([PROGRAM, "view", tmp_path / "nonsense.json", "--dir", tmp_path / "jobs", "--no-browser"],
                           capture_output=True, text=True)
    assert shown.returncode == 3 and "nonsense.json" in shown.stderr
    assert not [one for one in (tmp_path / "jobs").iterdir() if one.is_dir()]
