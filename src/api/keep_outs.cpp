#include "api/keep_outs.hpp"

#include <string>

#include "api/check_options.hpp"
#include "api/short_number.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

std::string corner_text(const Vec3& p) { return short_number(p.x) + "," + short_number(p.y) + "," + short_number(p.z); }

bool reaches_into(const Box& keep_out, const Vec3& size) {
    for (int axis = 0; axis < 3; ++axis) {
        if (keep_out.max[axis] <= 0 || keep_out.min[axis] >= size[axis]) return false;
    }
    return true;
}

}  // namespace

void warn_of_keep_outs(const Container& container, Listener& listener) {
    const Vec3& size = container.size;
    for (const KeepOut& keep_out : container.keep_out) {
        if (reaches_into(keep_out.box, size)) continue;
        const std::string what = keep_out.mesh ? keep_out.mesh->file + " (a keep-out)" : "keep-out";
        listener.on_warning(what + " " + corner_text(keep_out.box.min) + "," + corner_text(keep_out.box.max) +
                            " lies outside the tray of " + short_number(size.x) + " x " + short_number(size.y) + " x " +
                            short_number(size.z) + " mm and keeps nothing free");
    }
}

void require_free(const BitGrid& blocked, const Container& container, const PackOptions& options) {
    if (blocked.extent().empty() || blocked.count() < blocked.extent().count()) return;
    std::string what = "no voxel of " + short_number(voxel_size(options)) + " mm is wholly free";
    if (options.wall_gap > 0) what += " and " + short_number(options.wall_gap) + " mm from the walls";
    // A vessel stands among the keep-outs itself.
    const std::size_t own = container.is == ContainerIs::vessel ? 1 : 0;
    if (container.mesh && container.keep_out.size() == own) {
        throw InputError(container.mesh->file, "", "as a container, " + what);
    }
    throw UsageError("the keep-outs leave no room in " + (container.mesh ? container.mesh->file : "the tray") + ": " +
                     what);
}

}  // namespace spectralpack
