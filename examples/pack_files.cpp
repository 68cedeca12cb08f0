// Packs mesh files, folders, sets or a job file, as the command line names them, and writes the packing.
//
//     pack_files OUTPUT PART...
//
// OUTPUT: ends in .3mf, .json, .stl, .csv or .png; PART: mesh.stl, mesh.stl:12, a folder, set.csv, job.json
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "spectralpack/files.hpp"
#include "spectralpack/pack.hpp"

namespace sp = spectralpack;

namespace {

// What could not be used of the inputs; the rest is packed.
void tell(const std::vector<sp::InputError>& unusable) {
    for (const sp::InputError& error : unusable) {
        std::fprintf(stderr, "%s\n", error.what());
    }
}

int pack_files(const std::filesystem::path& output, const std::vector<std::string>& arguments) {
    const sp::ExpandedInputs inputs = sp::expand_inputs(arguments, "");

    sp::Job job;
    job.parts = inputs.parts;
    job.options.gap = 1;
    const sp::PackResult result = sp::pack(job);
    tell(result.unusable);

    std::printf("%lld of %lld copies placed, density %.3f\n", static_cast<long long>(result.packing.metrics.placed),
                static_cast<long long>(result.packing.metrics.copies), result.packing.metrics.density);
    constexpr int kAllThreads = 0;
    for (const std::filesystem::path& file : sp::write_output({result.packing, result.meshes}, output, kAllThreads)) {
        std::printf("wrote %s\n", file.c_str());
    }
    return result.unusable.empty() ? 0 : 3;
}

}  // namespace

int main(int count, char** words) {
    if (count < 3) {
        std::fprintf(stderr, "usage: pack_files OUTPUT PART...\n");
        return 2;
    }
    try {
        return pack_files(words[1], {words + 2, words + count});
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
