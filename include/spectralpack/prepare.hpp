#pragma once
/// Making a benchmark of any folder of meshes (appendix B.1).

#include <cstdint>
#include <filesystem>
#include <map>

#include "prepare/prepare_mesh.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/events.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

struct PrepareOptions {
    PrepareRules rules;
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
                       const PrepareOptions& options, Listener& listener, const StopToken& stop);

/// "kept", "unusable", "open", "inconsistent", "non-manifold", "no volume".
const char* prepared_name(Prepared outcome);

}  // namespace spectralpack
