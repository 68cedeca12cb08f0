"""Arrays in and out: shapes, types, lifetime."""

import gc

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from hypothesis.extra import numpy as arrays

import spectralpack as sp
from conftest import CUBE_FACES, CUBE_VERTICES, box


@pytest.mark.parametrize("real", [np.float32, np.float64, np.int16])
@pytest.mark.parametrize("whole", [np.int32, np.int64, np.uint32, np.uint8])
@pytest.mark.parametrize("order", ["C", "F"])
def test_any_layout_gives_the_same_mesh(real, whole, order):
    vertices = np.array(CUBE_VERTICES * [2, 3, 4], dtype=real, order=order)
    mesh = sp.Mesh(vertices, np.array(CUBE_FACES, dtype=whole, order=order))
    assert np.array_equal(mesh.vertices, vertices)
    assert np.array_equal(mesh.faces, CUBE_FACES)
    assert mesh.volume == pytest.approx(24)
    assert mesh.area == pytest.approx(52)
    assert mesh.bounds == ((0, 0, 0), (2, 3, 4))


def test_lists_and_strided_arrays_will_do():
    assert sp.Mesh(CUBE_VERTICES.tolist(), CUBE_FACES.tolist()).volume == pytest.approx(1)
    wide = np.zeros((8, 6))
    wide[:, ::2] = CUBE_VERTICES
    assert sp.Mesh(wide[:, ::2], CUBE_FACES[::-1]).volume == pytest.approx(1)


@given(arrays.arrays(np.float64, st.tuples(st.integers(0, 40), st.just(3)),
                     elements=st.floats(-1e6, 1e6)), st.data())
@settings(max_examples=50, deadline=None)
def test_round_trip(vertices, data):
    n = len(vertices)
    faces = data.draw(arrays.arrays(np.int64, st.tuples(st.integers(0, 30 if n else 0), st.just(3)),
                                    elements=st.integers(0, max(0, n - 1))))
    mesh = sp.Mesh(vertices, faces)
    assert np.array_equal(mesh.vertices, vertices)
    assert np.array_equal(mesh.faces, faces)


@pytest.mark.parametrize("vertices, faces, told", [
    (np.zeros((4, 2)), CUBE_FACES, r"vertices must have the shape \(n, 3\), not \(4, 2\)"),
    (np.zeros(12), CUBE_FACES, r"vertices must have the shape \(n, 3\), not \(12,\)"),
    (CUBE_VERTICES, np.zeros((5, 4), dtype=int), r"faces must have the shape \(m, 3\), not \(5, 4\)"),
    (CUBE_VERTICES, [[0, 1, 8]], r"faces\[0\] names vertex 8, and there are 8"),
    (CUBE_VERTICES, [[0, 1, 2], [0, -1, 2]], r"faces\[1\] names vertex -1"),
    (CUBE_VERTICES * [1, 1, np.nan], CUBE_FACES, r"vertices\[0\] is not finite"),
])
def test_wrong_shapes_are_told(vertices, faces, told):
    with pytest.raises(ValueError, match=told):
        sp.Mesh(vertices, faces)


@pytest.mark.parametrize("vertices, faces", [
    (CUBE_VERTICES, CUBE_FACES * 1.0), ("cube", CUBE_FACES), (CUBE_VERTICES, None), (None, CUBE_FACES),
])
def test_wrong_types_are_told(vertices, faces):
    with pytest.raises(TypeError):
        sp.Mesh(vertices, faces)


def test_views_keep_the_mesh_alive_and_are_read_only():
    vertices = box(2, 3, 4).vertices
    faces = box(2, 3, 4).faces
    gc.collect()
    junk = [box(9, 9, 9) for _ in range(100)]
    assert vertices.max() == 4 and faces.max() == 7 and junk
    assert not vertices.flags.owndata
    with pytest.raises(ValueError):
        vertices[0, 0] = 1


def test_anything_with_vertices_and_faces_is_a_mesh():
    class Tri:
        vertices, faces = CUBE_VERTICES, CUBE_FACES

    assert sp.voxelize(Tri(), 0.5).all()
    with pytest.raises(TypeError, match="vertices and .faces"):
        sp.voxelize(3, 0.5)


def test_voxels_are_indexed_x_y_z():
    voxels, corner = sp.voxelize(box(2, 3, 4), 1.0, return_corner=True)
    assert voxels.dtype == bool and voxels.shape == (2, 3, 4) and voxels.all()
    assert corner == (0, 0, 0)
    bar = sp.voxelize(box(1, 1, 1).transformed([[5, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]), 1.0)
    assert bar.shape == (5, 1, 1)


def test_distance():
    away = np.eye(4)
    away[0, 3] = 5
    value, a, b = sp.distance(box(1, 1, 1), box(1, 1, 1), pose_b=away)
    assert value == pytest.approx(4)
    assert a[0] == pytest.approx(1) and b[0] == pytest.approx(5)


def test_inspect_says_what_is_wrong():
    assert box(1, 2, 3).inspect()["watertight"]
    open_box = sp.Mesh(CUBE_VERTICES, CUBE_FACES[1:])
    assert not open_box.inspect()["watertight"] and open_box.inspect()["holes"] == 1
