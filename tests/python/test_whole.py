"""The package as a whole: import time, memory, cost of the way through Python, types."""

import pathlib
import resource
import subprocess
import sys

import pytest

import spectralpack as sp
from conftest import ROOT, box


def test_nothing_leaks_over_many_packs():
    job = sp.Job(tray=(30, 30, 30), threads=1, interlock="off", refine=False)
    job.add(box(10, 8, 6), count=2)

    def run(times):
        for _ in range(times):
            packing = sp.pack(job, progress=lambda _: None)
            assert packing.placements["transform"].sum() > 0
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    before = run(1000)
    assert run(9000) - before < 8 * 1024, "kB"


def test_references_are_given_back():
    mesh = box(10, 8, 6)
    before = sys.getrefcount(mesh)
    for _ in range(100):
        job = sp.Job()
        job.add(mesh)
        mesh.vertices, mesh.faces
    del job
    assert sys.getrefcount(mesh) == before


def test_documents_are_there():
    for name in sp.__all__:
        if name != "__version__":
            assert getattr(sp, name).__doc__, name
    for method in (sp.Job.add, sp.Packing.save, sp.Packing.render, sp.Tray.best_placement):
        assert len(method.__doc__) > 80


def test_stubs_name_what_is_there():
    stub = (pathlib.Path(sp.__file__).parent / "_core.pyi").read_text()
    from spectralpack import _core
    for name in dir(_core):
        if not name.startswith("__"):
            assert f"class {name}" in stub or f"def {name}(" in stub, name
    for cls in (sp.Job, sp.Mesh, sp.Packing, sp.Plan, sp.Step, sp.CheckReport, sp.Finding, sp.Tray, sp.Shape, sp.Placement):
        body = stub.split(f"class {cls.__name__}")[1].split("\nclass ")[0]
        for name in vars(cls):
            if not name.startswith("_"):
                assert f"def {name}(" in body, f"{cls.__name__}.{name}"


def test_examples_are_typed():
    pytest.importorskip("mypy")
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", *map(str, sorted((ROOT / "examples" / "python").glob("*.py")))],
        capture_output=True, text=True, env={"MYPYPATH": str(pathlib.Path(sp.__file__).parents[1]), "PATH": "/usr/bin:/bin"})
    assert done.returncode == 0, done.stdout + done.stderr
