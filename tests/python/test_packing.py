"""Jobs, packing, judging, files."""

import json
import signal
import subprocess
import threading
import time

import numpy as np
import pytest

import spectralpack as sp
from conftest import ROOT, SAMPLES, box, small_job


def test_a_packing_is_whole_and_comes_apart(packing):
    assert packing.placed == 9 and not packing.left_over and packing.stopped is None
    report = packing.check()
    assert report.ok and report and report.comes_apart and not report.findings
    assert report.min_gap >= 0.5 - 1e-6
    assert packing.plan.complete and len(packing.plan.steps) == 9
    taken = sorted(i for step in packing.plan.steps for i in step.placements)
    assert taken == list(range(9))
    assert all(step.path.ndim == 2 and step.path.shape[1] == 3 for step in packing.plan.steps)


def test_placements_are_a_structured_array(packing):
    placements = packing.placements
    assert placements.shape == (9,)
    assert placements["transform"].shape == (9, 4, 4)
    assert sorted(placements["number"]) == list(range(1, 10))
    assert set(placements["part"]) == {0, 1} and set(placements["tray"]) == {0}
    for row in placements:
        corners = packing.mesh(row["part"]).vertices @ row["transform"][:3, :3].T + row["transform"][:3, 3]
        assert (corners > -1e-6).all() and (corners < np.array(packing.size) + 1e-6).all()
    assert packing.tray_mesh().volume == pytest.approx(packing.density * np.prod(packing.size))


def test_the_same_placements_as_the_command_line(program, tmp_path):
    job = sp.Job.from_files(SAMPLES, tray=(200, 160, 150), gap=1, voxel=4, threads=2)
    packing = sp.pack(job)
    build = tmp_path / "build.json"
    subprocess.run([program, "pack", SAMPLES, "--tray", "200x160x150", "--gap", "1", "--voxel", "4", "-o", build,
                    "--progress", "none"], check=True, stdout=subprocess.DEVNULL)
    written = json.loads(build.read_text())
    assert packing.input_hash == written["input_hash"]
    theirs = [(p["part"], p["copy"], p["orientation"]) for p in written["trays"][0]["placements"]]
    ours = [(int(p["part"]), int(p["copy"]), int(p["orientation"])) for p in packing.placements]
    assert ours == theirs
    loaded = sp.load(build)
    assert np.array_equal(loaded.placements, packing.placements)


def test_files_out(packing, tmp_path):
    for name in ("build.3mf", "build.stl", "build.csv", "build.png", "build.html"):
        assert [str(path) for path in packing.save(tmp_path / name)] == [str(tmp_path / name)]
        assert (tmp_path / name).stat().st_size > 100
    with pytest.raises(sp.UsageError, match="3mf"):
        packing.save(tmp_path / "build.xyz")
    with pytest.raises(sp.Error):
        packing.save(tmp_path / "no" / "such" / "build.3mf")


def test_meshes_from_memory_are_written_beside_a_packing_file(packing, tmp_path):
    packing.save(tmp_path / "build.json")
    assert len(list((tmp_path / "build_meshes").iterdir())) == 2
    loaded = sp.load(tmp_path / "build.json")
    assert loaded.check().ok and loaded.plan.complete
    assert np.array_equal(loaded.placements, packing.placements)
    assert np.array_equal(loaded.mesh(0).vertices, packing.mesh(0).vertices)


def test_pictures(packing):
    picture = packing.render(160, 120)
    assert picture.shape == (120, 160, 3) and picture.dtype == np.uint8 and picture.std() > 5
    assert np.array_equal(picture, packing.render(160, 120, threads=1))
    cut = packing.render(160, 120, tray=0, section=("z", 5.0))
    assert not np.array_equal(picture, cut)
    with pytest.raises(sp.UsageError):
        packing.render(0, 0)
    html = packing._repr_html_()
    assert "data:image/png;base64," in html and "9 of 9 copies" in html and "http" not in html


def test_plans_are_made_anew():
    packing = sp.pack(small_job(interlock="off"))
    assert packing.plan is None and packing.plans == []
    (plan,) = packing.make_plans()
    assert plan.complete and packing.plan.complete
    with pytest.raises(ValueError, match="'any' or 'top'"):
        packing.make_plans(unpack="sideways")


def test_several_trays():
    packing = sp.pack(small_job(tray=(40, 25, 20), trays="all"))
    assert len(packing.trays) > 1 and len(packing.plans) == len(packing.trays)
    with pytest.raises(ValueError, match="plans"):
        packing.plan


def test_options_by_name():
    job = sp.Job(tray=(100, 90), open_height=True, wall_gap=np.float64(1.5), order="volume", rotations=45, seed=3)
    assert job.options["tray"] == (100, 90, 0) and job.options["rotations"] == "45" and job.get("seed") == 3
    job.set(gap="1.5", height_penalty="auto", refine=False)
    assert job.get("gap") == 1.5 and job.get("height_penalty") is None and job.get("refine") is False
    assert sp.Job(printer="formlabs-fuse1").get("tray") != sp.Job().get("tray")
    assert "wall_gap: " in sp.options_help()


@pytest.mark.parametrize("options, told, error", [
    ({"gpa": 1}, "'gap' is one", TypeError),
    ({"gap": -1}, "gap takes", ValueError),
    ({"gap": True}, "gap takes", ValueError),
    ({"gap": [1]}, "gap takes", ValueError),
    ({"seed": 1.5}, "seed takes", ValueError),
    ({"tray": 5}, "tray takes", ValueError),
    ({"order": "best"}, "order", ValueError),
    ({"refine": 1}, "refine takes", ValueError),
    ({"printer": "xerox"}, "no printer", ValueError),
    ({"unit": "mile"}, "unit", ValueError),
])
def test_wrong_options_are_told(options, told, error):
    with pytest.raises(error, match=told):
        sp.Job(**options)


@pytest.mark.parametrize("part, told", [
    ({"count": 0}, "count"), ({"scale": -1}, "scale"), ({"orientations": "sideways"}, "orientations"),
    ({"orientations": {"up": ["z"]}}, "axis"), ({"orientations": np.ones((1, 3, 3))}, "not a rotation"),
    ({"orientations": np.eye(3)}, r"\(k, 3, 3\)"),
])
def test_wrong_parts_are_told(part, told):
    with pytest.raises(ValueError, match=told):
        sp.Job().add(box(1, 1, 1), **part)


def test_orientations_hold():
    job = sp.Job(tray=(60, 60, 60))
    job.add(box(30, 4, 5), count=3, orientations="fixed")
    job.add(box(20, 6, 5), count=3, orientations="upright")
    job.add(box(22, 3, 4), count=2, orientations=[np.eye(3)])
    job.add(box(24, 3, 4), count=2, orientations={"up": ["+x"], "yaw": 180})
    for row in sp.pack(job).placements:
        turn = row["transform"][:3, :3]
        if row["part"] in (0, 2):
            assert np.allclose(turn, np.eye(3))
        if row["part"] == 1:
            assert np.allclose(turn[2], [0, 0, 1])
        if row["part"] == 3:
            assert np.allclose(turn[2], [1, 0, 0])


def test_bad_files_are_remarks_and_the_rest_is_packed(tmp_path):
    bad = tmp_path / "bad.stl"
    bad.write_text("solid nothing")
    job = sp.Job(tray=(60, 50, 60))
    job.add(bad)
    job.add(box(10, 10, 10), count=2)
    with pytest.warns(sp.Remark, match="bad.stl"):
        packing = sp.pack(job)
    assert packing.placed == 2
    (error,) = packing.unusable
    assert isinstance(error, sp.InputError) and error.file == str(bad) and error.cause
    (left,) = packing.left_over
    assert left["part"] == 0 and left["reason"] == "bad_file"
    with pytest.raises(sp.InputError) as raised:
        sp.load(tmp_path / "nothing.json")
    assert "nothing.json" in raised.value.file


def test_too_little_memory_is_told():
    with pytest.raises(MemoryError):
        sp.pack(small_job(voxel=0.1, memory="1M"))
    with pytest.raises(sp.UsageError, match="no parts"):
        sp.pack(sp.Job())


def test_progress_and_events():
    lines, events = [], []
    sp.pack(small_job(), progress=lines.append, on_event=events.append)
    assert {"search"} <= {line["phase"] for line in lines}
    placed = [event for event in events if event["kind"] == "copy_placed"]
    assert len(placed) >= 9 and placed[0]["transform"].shape == (4, 4)


def test_what_a_callback_raises_comes_through():
    def fail(_):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        sp.pack(small_job(), progress=fail)
    with pytest.raises(KeyError, match="mine"):
        sp.pack(small_job(), on_event=fail)


def test_ctrl_c_returns_the_best_so_far():
    job = small_job(open_height=True, improve=600)
    seen = []

    def interrupt(line):
        if line["phase"] == "improve" and not seen:
            seen.append(time.monotonic())
            signal.raise_signal(signal.SIGINT)

    packing = sp.pack(job, progress=interrupt)
    assert seen and time.monotonic() - seen[0] < 20
    assert packing.stopped == "cancelled" and packing.placed == 9 and packing.check().ok


def test_the_clock_ends_improving_and_placing():
    begun = time.monotonic()
    packing = sp.pack(small_job(open_height=True, improve=1))
    assert time.monotonic() - begun < 30
    assert packing.metrics["improvement"]["seconds"] >= 0.9
    packing = sp.pack(small_job(open_height=True, improve="rest", time_limit=2))
    assert packing.placed == 9


def test_other_threads_run_meanwhile():
    counted = [0]
    done = threading.Event()

    def count():
        while not done.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    sp.pack(small_job(open_height=True, improve_steps=60, voxel=1))
    done.set()
    thread.join()
    assert counted[0] > 5


def test_packs_in_several_threads_give_the_same():
    packings = [None] * 4

    def work(i):
        packings[i] = sp.pack(small_job())

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for packing in packings[1:]:
        assert np.array_equal(packing.placements, packings[0].placements)


def test_topping_up():
    base = sp.pack(small_job())
    job = sp.Job(onto=base, gap=0.5)
    job.add(box(8, 8, 8), count=4)
    more = sp.pack(job)
    assert more.placed == 13 and more.check().ok
    assert more.placements["fixed"].sum() == 9


def test_keep_outs_and_estimates():
    job = small_job(keep_out=[(0, 0, 0, 30, 50, 60)])
    packing = sp.pack(job)
    for row in packing.placements:
        corners = packing.mesh(row["part"]).vertices @ row["transform"][:3, :3].T + row["transform"][:3, 3]
        assert corners[:, 0].min() >= 30 - 1e-6
    guess = sp.estimate(small_job())
    assert guess["copies"] == 9 and guess["voxel"] == 2 and guess["memory"] > 0


def test_a_journal_is_gone_on_from(tmp_path):
    journal = tmp_path / "run.journal"
    first = sp.pack(small_job(), journal=journal)
    again = sp.pack(small_job(), journal=journal)
    assert np.array_equal(first.placements, again.placements)


def test_inspecting_files():
    files = sp.inspect(*sorted(SAMPLES.glob("*.stl")))
    assert len(files) >= 5
    for file in files:
        (part,) = file["objects"]
        assert file["unusable"] is None and part["watertight"] and part["mesh"].volume > 0


def test_generated_sets_and_printers():
    parts = sp.generate("tori", seed=1, copies=4)
    assert sum(count for _, _, count in parts) == 4
    assert all(mesh.inspect()["watertight"] for _, mesh, _ in parts)
    with pytest.raises(ValueError, match="no set"):
        sp.generate("cars")
    assert any(printer["name"] == "hp-mjf-5200" for printer in sp.printers())
