#include "spectralpack/files.hpp"

namespace spectralpack {
namespace {

void add_container(const ContainerSource& container, std::set<std::string>& files) {
    if (container.mesh) files.insert(container.mesh->file);
    for (const KeepOutSource& keep_out : container.keep_out) {
        if (keep_out.mesh) files.insert(keep_out.mesh->file);
    }
}

void add_parts(const Packing& packing, std::set<std::string>& files) {
    for (const PackedPart& part : packing.parts) {
        files.insert(part.mesh);
    }
}

}  // namespace

std::set<std::string> mesh_files(const Job& job) {
    std::set<std::string> files;
    for (const Part& part : job.parts) {
        files.insert(part.mesh.file());
    }
    for (const FixedSource& fixed : job.fixed) {
        files.insert(fixed.mesh.file);
    }
    for (const std::optional<Scene>& build : {job.onto, job.keep}) {
        if (build) add_parts(build->packing, files);
    }
    add_container(job.container, files);
    files.erase("");  // meshes in memory
    return files;
}

std::set<std::string> mesh_files(const Packing& packing) {
    std::set<std::string> files;
    add_parts(packing, files);
    add_container(container_source(packing), files);
    files.erase("");
    return files;
}

}  // namespace spectralpack
