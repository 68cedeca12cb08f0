#include "api/load_container.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

#include "formats/mesh_reader.hpp"
#include "geometry/mesh_edges.hpp"
#include "geometry/vessel.hpp"
#include "model/physical_surfaces.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/mesh_figures.hpp"

namespace spectralpack {
namespace {

/// Below the origin by more than this a container is not where it should be.
constexpr double kRounding = 1e-6;  ///< mm

/// What a mesh holds and what it is made of together are taken for a vessel where it holds more than this share of
/// them: a cup with a thick wall is one, a block with a dimple is not.
constexpr double kVesselHolds = 0.25;

std::string point_text(const Vec3& p) {
    char text[96];
    std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", p.x, p.y, p.z);
    return text;
}

LoadedMesh only_mesh(const std::string& file, const std::string& place, double unit, const StopToken& stop) {
    std::vector<LoadedMesh> meshes = read_meshes(file, unit, stop);
    if (meshes.size() != 1) {
        throw InputError(file, place, "holds " + std::to_string(meshes.size()) + " objects; one is needed here");
    }
    return std::move(meshes.front());
}

/// `in_file`: the mesh in the file's own coordinates, where people will look for the hole.
void require_closed(const Mesh& in_file, const StandingMesh& standing, const std::string& what) {
    const MeshFigures figures = inspect_mesh(in_file);
    if (figures.watertight() && signed_volume(*standing.surface) > 0) return;
    std::string cause = "cannot be " + what + ": the mesh is not closed";
    if (!figures.holes.empty()) {
        const BorderLoop& hole = figures.holes.front();
        cause += "; it is open at " + point_text(hole.place) + ", where " + std::to_string(hole.edges) +
                 " edges border a hole";
        if (figures.border_loops > 1) cause += ", and in " + std::to_string(figures.border_loops - 1) + " more places";
    } else if (figures.misdirected_place) {
        cause += "; neighbouring facets face opposite ways at " + point_text(*figures.misdirected_place);
    } else if (figures.watertight()) {
        cause = "cannot be " + what + ": the mesh encloses no volume";
    }
    throw InputError(standing.file, "", cause);
}

KeepOut load_keep_out(const KeepOutSource& source, double default_unit, const StopToken& stop) {
    if (!source.mesh) return {source.box};
    KeepOut keep_out;
    keep_out.mesh = load_standing_mesh(*source.mesh, default_unit, stop);
    keep_out.box = bounding_box(*keep_out.mesh->surface);
    if (!is_closed(*keep_out.mesh->surface, stop)) {
        const LoadedMesh loaded = only_mesh(source.mesh->file, source.mesh->place, default_unit, stop);
        require_closed(loaded.mesh, *keep_out.mesh, "a keep-out");
    }
    return keep_out;
}

std::string number_text(const char* format, double number) {
    char text[32];
    std::snprintf(text, sizeof text, format, number);
    return text;
}

std::string cm3_text(double volume) { return number_text("%.4g cm3", volume / 1000); }

/// Whether the container's mesh is a vessel, and then what it holds takes the mesh's place and the mesh becomes a
/// keep-out.
void settle_vessel(const MeshSource& source, const std::optional<ContainerIs>& is, Container& container,
                   Listener& listener) {
    StandingMesh& mesh = *container.mesh;
    const double material = signed_volume(*mesh.surface);
    std::optional<Cavity> cavity = largest_cavity(*mesh.surface);
    if (is == ContainerIs::vessel && !cavity) {
        throw InputError(mesh.file, source.place,
                         "holds nothing as it stands: what is filled into it would run out (--container-is solid "
                         "fills the mesh's own volume)");
    }
    const bool vessel =
        is ? *is == ContainerIs::vessel : cavity && cavity->volume > kVesselHolds * (cavity->volume + material);
    if (!vessel) {
        listener.on_warning(mesh.file + ": filled is the volume of the mesh itself, " + cm3_text(material) +
                            (cavity ? "; --container-is vessel fills what it holds, " + cm3_text(cavity->volume) : ""));
        return;
    }
    listener.on_warning(
        mesh.file + ": is a vessel; filled is what it holds, " + cm3_text(cavity->volume) +
        (cavity->open ? ", up to the brim at " + number_text("%.4g mm", cavity->brim) + "; what leaves, leaves over it"
                      : ", a hollow without an opening") +
        "; --container-is solid fills the mesh itself, " + cm3_text(material));
    container.is = ContainerIs::vessel;
    container.physical = container.physical || cavity->open;
    container.keep_out.push_back({bounding_box(*mesh.surface), mesh});
    mesh.surface = std::make_shared<const Mesh>(std::move(cavity->room));
    container.size = bounding_box(*mesh.surface).max;
}

}  // namespace

StandingMesh load_standing_mesh(const MeshSource& source, double default_unit, const StopToken& stop) {
    const double unit = source.unit.value_or(default_unit);
    const LoadedMesh loaded = only_mesh(source.file, source.place, unit, stop);
    StandingMesh standing{source.file, source.transform.value_or(Transform{loaded.unit.value_or(unit) * Mat3{}, {}})};
    standing.surface = std::make_shared<const Mesh>(transformed(loaded.mesh, standing.transform));
    return standing;
}

Container load_container(const ContainerSource& source, const Vec3& tray, double default_unit, Listener& listener,
                         const StopToken& stop) {
    Container container{tray};
    container.physical = source.physical;
    if (source.mesh) {
        StandingMesh mesh = load_standing_mesh(*source.mesh, default_unit, stop);
        require_closed(*mesh.surface, mesh, "a container");
        Box box = bounding_box(*mesh.surface);
        if (!source.mesh->transform) {
            mesh.transform.translation = mesh.transform.translation - box.min;
            mesh.surface = std::make_shared<const Mesh>(transformed(*mesh.surface, {Mat3{}, -box.min}));
            box = bounding_box(*mesh.surface);
        }
        if (std::min({box.min.x, box.min.y, box.min.z}) < -kRounding) {
            throw InputError(source.mesh->file, source.mesh->place,
                             "reaches to " + point_text(box.min) +
                                 " as its transform places it; the container's lower corner is the origin (without a "
                                 "transform it is moved there)");
        }
        container.size = box.max;
        container.mesh = std::move(mesh);
        settle_vessel(*source.mesh, source.is, container, listener);
    }
    for (const KeepOutSource& keep_out : source.keep_out) {
        container.keep_out.push_back(load_keep_out(keep_out, default_unit, stop));
    }
    return container;
}

Container container_of(const Job& job, Listener& listener, const StopToken& stop) {
    Container container = load_container(job.container, job.options.tray, job.unit, listener, stop);
    if (job.options.interlock == Interlock::off || opens_at_top(container)) return container;
    if (container.physical) {
        throw InputError(job.container.mesh->file, job.container.mesh->place,
                         "has no flat face at its top, where a physical container is open: nothing could leave it "
                         "(--interlock off packs it all the same)");
    }
    if (job.options.unpack == Unpack::top) {
        throw InputError(job.container.mesh->file, job.container.mesh->place,
                         "has no flat face at its top, through which --unpack top could take anything out");
    }
    return container;
}

void load_surfaces(Container& container) {
    const auto load = [](StandingMesh& standing) {
        standing = load_standing_mesh({standing.file, "", standing.transform}, 1);
    };
    if (container.mesh) load(*container.mesh);
    if (container.is == ContainerIs::vessel) {
        std::optional<Cavity> cavity = largest_cavity(*container.mesh->surface);
        if (!cavity) throw InputError(container.mesh->file, "", "as a vessel, it holds nothing");
        container.mesh->surface = std::make_shared<const Mesh>(std::move(cavity->room));
    }
    for (KeepOut& keep_out : container.keep_out) {
        if (!keep_out.mesh) continue;
        load(*keep_out.mesh);
        keep_out.box = bounding_box(*keep_out.mesh->surface);
    }
}

}  // namespace spectralpack
