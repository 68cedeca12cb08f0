#pragma once
/// The plain method (Algorithm 1) on a GPU, in single precision by cuFFT, to measure engines against: all orientations
/// of an object at a time. Not an engine: it rounds, and it knows voxels of one size, without keep-out. All in voxels;
/// triples are x, y, z, and x goes fastest.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

/// Bits of a grid, row by row along x, each row of whole words.
struct GpuVoxels {
    const std::uint64_t* words = nullptr;
    int words_per_row = 0;
    int extent[3]{};
    int offset[3]{};  ///< of voxel (0,0,0) in the transform's grid, which is circular
};

struct GpuOrientation {
    GpuVoxels solid;    ///< A
    GpuVoxels widened;  ///< A+g
    bool same = false;  ///< they are: one transform serves both
    int candidates[3]{};
};

struct GpuBest {
    int index = 0;
    int position[3]{};
    std::int64_t proximity = 0;
    double cost = 0;
};

class GpuPlain {
  public:
    /// Transforms of nx * ny * nz, `orientations` at a time at most. Throws std::runtime_error, as all below.
    GpuPlain(int nx, int ny, int nz, int orientations);
    ~GpuPlain();
    GpuPlain(const GpuPlain&) = delete;
    GpuPlain& operator=(const GpuPlain&) = delete;

    /// For so many orientations; takes a moment, and is else done when first asked of as many.
    void plan(int orientations);

    /// The tray's objects, and their distance field, of the same extent (equation 3).
    void set_tray(const GpuVoxels& objects, const std::int32_t* phi);

    /// Least (rho + penalty, orientation, z, y, x) of what does not collide (equations 2, 4, 6). `penalties`: by layer.
    std::optional<GpuBest> best(const std::vector<GpuOrientation>& orientations, const std::vector<double>& penalties);

  private:
    struct Device;
    std::unique_ptr<Device> device_;
};
