#pragma once
/// Constants that decide how long a search takes, never its answer, and why they are what they are.

#include <cstddef>
#include <cstdint>

namespace spectralpack::tuning {

// Tables of a tray

/// Objects that came or went, for which a fresh start is cheaper than following them one by one.
inline constexpr std::size_t kRebuildAfter = 512;
/// Objects that come until the cell of an older one is worked out anew: it has shrunk, but that takes some time.
inline constexpr std::size_t kAdditionsPerCell = 8;
/// Layers of voxels for which plates and cubes are made at a time, so that what is on the way to them stays in L2.
inline constexpr int kSlab = 32;

// Lists of a part

/// Cells of 8^3 voxels, or larger ones where there would be more: nearly all blocks are asked about all of them.
inline constexpr std::size_t kMostCells = 1600;
/// Cells of 4^3 voxels: none where a solid has fewer runs, since sums then cost little more than they do.
inline constexpr std::size_t kRunsWorthSmallCells = 200, kMostSmallCells = std::size_t{1} << 20;
/// Where no phi is above it, a small tray is a crowd: little lies in the open, and cells say nothing.
inline constexpr int kMostPhiOfCrowds = 21;
/// Look-ups of a batch: a position survives it or not. After pruning few are left, and batches double up to the last.
inline constexpr std::size_t kFirstBatch = 8, kLastBatch = 512;
/// Batches of pruning, the more the dearer the sum that comes next: one look-up for so many of its loads.
inline constexpr std::size_t kLeastPruning = 4, kMostPruning = 16, kLoadsPerPruningLookup = 8;
/// Look-ups for four positions one above the other, which empty half of the bricks, in pieces of so many voxels or
/// more.
inline constexpr std::size_t kStackLookups = 16;
inline constexpr int kLeastVoxelsInStacks = 4;
/// Look-ups into the crowd tables.
inline constexpr std::size_t kCrowdLookups = 64;
/// Pairs of loads between two looks at the limit; and in a bunch of neighbours, which share cache lines.
inline constexpr int kLoadsPerBatch = 24;
inline constexpr std::size_t kLoadsPerBunch = 2 * kLoadsPerBatch;

// The scan

/// Brick layers of a task: what tables hold of few stays in the caches for all orientations. Fewer where tasks are
/// begun in order, and those begun later may be spared.
inline constexpr int kLayersPerTask = 4, kLayersPerTaskInOrder = 2;
/// Batches of pruning that are made for all layers of a brick at once, since they leave out none.
inline constexpr std::size_t kBatchesForAllLayers = 1;
/// Where one in so many blocks of a pair of bricks, or of all positions, is reopened after objects went, what is known
/// of the others is not worth the trouble.
inline constexpr int kPartsReopened = 2;
/// Questions in vain after which stacks are asked about more rarely, and how many are left out at a stretch at most.
inline constexpr int kPatienceWithStacks = 4, kMostLeftOut = 24;
/// Cells between two looks at the limit.
inline constexpr std::size_t kCellsPerLook = 8;
/// Sums for copies go on until they are one of so many parts of the limit beyond it: the bounds that they leave still
/// rule out when the limit has risen, as it does from copy to copy.
inline constexpr std::int64_t kPartsBeyondLimit = 5;
/// Quads are asked about solids of that many runs at most. With more of them a sum is what takes the time, and a bound
/// takes more loads than rho itself does to pass the limit.
inline constexpr std::size_t kFewRuns = 128;
/// Loads of the sums of what is left, for each look-up that is made before them.
inline constexpr std::int64_t kLoadsPerLookup = 8;
/// Places that lost, to be offered to the next copy first.
inline constexpr std::size_t kSeeds = 8;

// Free positions

/// Looks that are spread over the solid: they decide most tiles. The others go on in the order of memory.
inline constexpr std::size_t kSpreadLooks = 64;
/// Looks between two questions whether all that is wanted collides.
inline constexpr std::ptrdiff_t kLooksPerCheck = 16;

}  // namespace spectralpack::tuning
