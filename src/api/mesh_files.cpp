#include "api/mesh_files.hpp"

namespace spectralpack {

std::set<std::string> mesh_files_of(const Job& job) {
    std::set<std::string> files;
    const auto add = [&](const std::string& file) {
        if (!file.empty()) files.insert(file);
    };
    for (const Part& part : job.parts) {
        add(part.mesh.file());
    }
    for (const FixedSource& fixed : job.fixed) {
        add(fixed.mesh.file);
    }
    if (job.onto) {
        for (const PackedPart& part : job.onto->packing.parts) {
            add(part.mesh);
        }
    }
    if (job.container.mesh) add(job.container.mesh->file);
    for (const KeepOutSource& keep_out : job.container.keep_out) {
        if (keep_out.mesh) add(keep_out.mesh->file);
    }
    return files;
}

}  // namespace spectralpack
