#pragma once
/// Copies that are changed by hand, judged among those that stand near them.

#include <set>
#include <string>
#include <vector>

#include <spectralpack/change.hpp>

#include "jobs/text_files.hpp"

namespace spectralpack::server {

/// From the `changes` of openapi.json, which count trays from 1. Throws UsageError.
std::vector<CopyChange> changes_from(const Json& changes);
Transform transform_from(const Json& matrix);

/// The position of a copy among the tray's placements. Throws UsageError where it does not stand there.
std::size_t placement_of(const Packing& packing, std::size_t tray, int part, int copy);

/// For each copy of the scene, a box around it: never smaller than its own. `tray` from 0.
std::vector<Box> boxes_around(const Scene& scene, std::size_t tray);

double distance_of(const Box& a, const Box& b);

/// What the check finds of these copies of a tray: touching, too near, outside. In words; empty: they may stand so.
/// Of the others only those near to them are looked at.
std::vector<std::string> faults_of(const Scene& scene, std::size_t tray, const std::set<std::size_t>& placements);

}  // namespace spectralpack::server
