#pragma once
/// What the allocator holds though nobody uses it.

namespace spectralpack {

/// Gives memory that was freed back to the system, where the allocator can: it lies scattered, and what comes next may
/// want larger pieces. Takes milliseconds.
void give_back_freed();

}  // namespace spectralpack
