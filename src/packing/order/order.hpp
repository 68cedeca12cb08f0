#pragma once
/// In which order copies are tried (section 3.3).

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "packing/tray/placed_copy.hpp"
#include "spectralpack/options.hpp"

namespace spectralpack {

/// `copies` but those in `out`, in their order.
std::vector<Copy> without(const std::vector<Copy>& copies, const std::set<Copy>& out);

// Those that are placed; in the order of `placed`.
std::set<Copy> copies_in(const std::vector<PlacedCopy>& placed);
std::vector<Copy> order_of(const std::vector<PlacedCopy>& placed);

/// What ordering needs to know of a part.
struct PartSize {
    int part = 0;
    int count = 0;
    double box_volume = 0;  ///< of the scaled mesh's box in file orientation, mm^3
    double priority = 0;    ///< higher goes first
    std::string due = {};   ///< "2026-12-01": of equal priority, earlier goes first; empty: last
    double volume = 0;      ///< of the scaled mesh, mm^3
    double value = 1;       ///< what a copy is worth
};

/// Every copy of every part, in the order to try them. `parts` in input order.
///  size:   box volume, largest first; ties by input position, then copy (paper's first-fit decreasing)
///  volume: volume, largest first; ties as before
///  mixed:  geometric mean of box volume and volume, largest first; ties as before
///  input:  as given
///  random: a permutation of the input order that only `seed` decides
/// Before that, in every order: higher priority first, then earlier due date.
std::vector<Copy> order_copies(const std::vector<PartSize>& parts, Order order, std::uint64_t seed);

/// By what serves `goal` in a tray that cannot hold all: by box volume, largest first (fair); by volume, largest first;
/// by box volume, smallest first (copies); by value per box volume, most first. Ties, priorities and due dates as
/// above.
std::vector<Copy> order_copies(const std::vector<PartSize>& parts, Goal goal);

/// Which parts go first whatever the order, by part: lower ranks first, and only copies of equal rank may change
/// places. `parts` in any order; parts that are not among them rank 0.
std::vector<int> urgency_ranks(const std::vector<PartSize>& parts);

/// Another order, not far from `copies`: each copy goes back by up to a fifth of their number, at random, and none
/// passes one of another rank.
std::vector<Copy> perturbed(const std::vector<Copy>& copies, const std::vector<int>& ranks, RandomStream& random);

/// Appendix A.2: 4 where the boxes of all copies come to more than 1.2 times the container (it will be full),
/// else 1e8 (keep it low).
double automatic_height_penalty(const std::vector<PartSize>& parts, double container_volume);

}  // namespace spectralpack
