#pragma once
/// Making a benchmark of any meshes (appendix B.1): they are judged, simplified and scaled.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "spectralpack/events.hpp"
#include "spectralpack/mesh.hpp"
#include "spectralpack/names.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack::tools {

struct PrepareRules {
    Vec3 tray{480, 245, 200};      ///< mm; what is larger as it lies is scaled down to fit
    double least_side = 2;         ///< mm; what fits into a cube of this side is scaled up to it
    std::size_t triangles = 4000;  ///< meshes of more are simplified
};

/// What became of a mesh.
enum class Prepared {
    kept,
    unusable,      ///< its file cannot be read, or it encloses nothing
    open,          ///< it has border edges
    inconsistent,  ///< neighbouring facets face opposite ways
    non_manifold,  ///< an edge has more than two facets
    no_volume,     ///< its signed volume is not positive
};

struct PreparedMesh {
    Prepared outcome = Prepared::kept;
    std::string detail;  ///< why it was dropped, or what simplification could not do; in words
    Mesh mesh;           ///< mm, box minimum at the origin; empty where dropped
    double scale = 1;    ///< uniform; applied
};

/// `mesh` in millimetres, after the repairs that are safe. Kept are closed, consistently oriented meshes whose
/// edges have two facets each and whose signed volume is positive; shells may meet and cross. Simplification must
/// leave all that as it is, the box to 2 % of its longest side and the volume to 3 %; where it does not, more
/// triangles are kept, in the end all of them.
PreparedMesh prepare_mesh(const Mesh& mesh, const PrepareRules& rules);

struct PrepareOptions {
    PrepareRules rules = {};
    double unit = 1;  ///< millimetres per unit for files that do not say
    int threads = 0;  ///< 0: all the machine has
};

struct PrepareSummary {
    std::filesystem::path set_file;           ///< names the meshes that were kept
    std::filesystem::path report_file;        ///< what became of every mesh
    std::int64_t files = 0;                   ///< mesh files in the folder
    std::int64_t done = 0;                    ///< of them, with those of earlier runs
    std::int64_t earlier = 0;                 ///< done by earlier runs
    std::map<Prepared, std::int64_t> meshes;  ///< by what became of them
    StopReason stopped = StopReason::none;
};

/// Reads every mesh file of `folder` and its folders, and writes what prepare_mesh() keeps as binary STL in
/// millimetres under the same path in `output`, with set.csv and report.csv. Files are done a few at a time, in
/// parallel. A run that was stopped or killed is continued by the next one with the same options, which does only
/// files that are new or changed since: `output`/journal.csv remembers. What cannot be used is a row of the report,
/// never an error. Throws InputError where `folder` cannot be read, UsageError where `output` lies in it or was
/// begun with other options, ResourceError where it cannot be written.
PrepareSummary prepare(const std::filesystem::path& folder, const std::filesystem::path& output,
                       const PrepareOptions& options, const Control& control = {});

}  // namespace spectralpack::tools

namespace spectralpack {

template <>
inline constexpr Words<6> kWords<tools::Prepared>{"kept",         "unusable",     "open",
                                                  "inconsistent", "non-manifold", "no volume"};

}  // namespace spectralpack
