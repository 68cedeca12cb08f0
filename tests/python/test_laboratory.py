"""Strategies of one's own."""

import numpy as np
import pytest

import spectralpack as sp
from conftest import box


def test_best_placement_is_the_least_cost_of_the_free_positions():
    tray = sp.Tray((20, 18, 16), voxel=2)
    assert tray.extent == (10, 9, 8)
    shape = tray.shape(box(6, 4, 4), "90")
    first = tray.best_placement(shape)
    assert first.position == (0, 0, 0)
    tray.add(shape, first)
    best = tray.best_placement(shape, height_penalty=0)
    costs = []
    for orientation in shape.orientations:
        collision, proximity = tray.metric_fields(shape, orientation)
        assert collision.shape == proximity.shape
        free = np.argwhere(collision == 0)
        costs += [(proximity[tuple(q)], orientation, *q[::-1]) for q in free]
    least = min(costs)
    assert (best.proximity, best.orientation, *best.position[::-1]) == least


def test_what_stands_is_seen_and_can_go():
    tray = sp.Tray(20, voxel=2)
    shape = tray.shape(box(6, 4, 4), [np.eye(3)])
    copy = tray.add_at(shape, 0, (2, 3, 1))
    occupied = tray.occupied()
    assert occupied.dtype == bool and occupied.sum() == 3 * 2 * 2
    assert occupied[2:5, 3:5, 1:3].all()
    assert shape.voxels(0).shape == (3, 2, 2)
    tray.remove(copy)
    assert not tray.occupied().any()
    with pytest.raises(ValueError):
        tray.remove(copy)
    with pytest.raises(sp.UsageError):
        sp.Tray(20, voxel=4).best_placement(shape)


def test_a_full_tray_has_no_place():
    tray = sp.Tray(10, voxel=2)
    shape = tray.shape(box(10, 10, 10))
    tray.add(shape, tray.best_placement(shape))
    assert tray.best_placement(shape) is None


def test_orientations():
    assert sp.orientation_set("90").shape == (24, 3, 3)
    assert sp.orientation_set("none").shape == (1, 3, 3)
    turns = sp.orientation_set(45)
    assert np.allclose(turns @ turns.transpose(0, 2, 1), np.eye(3))
    with pytest.raises(sp.UsageError):
        sp.orientation_set("7")
