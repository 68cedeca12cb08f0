import pathlib

import numpy as np
import pytest

import spectralpack as sp

ROOT = pathlib.Path(__file__).resolve().parents[2]
SAMPLES = ROOT / "data" / "samples"

CUBE_VERTICES = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=float)
CUBE_FACES = np.array([[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4],
                       [2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6], [1, 3, 5], [3, 7, 5]])


def box(x, y, z):
    return sp.Mesh(CUBE_VERTICES * [x, y, z], CUBE_FACES)


def small_job(**options):
    job = sp.Job(**{"tray": (60, 50, 60), "gap": 0.5, "threads": 2, **options})
    job.add(box(20, 12, 8), count=5, name="brick")
    job.add(box(31, 5, 4), count=4, name="bar")
    return job


@pytest.fixture(scope="session")
def packing():
    return sp.pack(small_job())


@pytest.fixture(scope="session")
def program():
    """The command line of the same build."""
    path = pathlib.Path(sp.__file__).resolve().parents[2] / "apps" / "cli" / "spectralpack"
    if not path.exists():
        pytest.skip("the command line is not built beside the package")
    return path
