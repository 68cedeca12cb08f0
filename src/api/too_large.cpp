#include "api/too_large.hpp"

#include <algorithm>
#include <cmath>

#include "api/check_options.hpp"
#include "api/short_number.hpp"
#include "geometry/convex_hull.hpp"
#include "geometry/minimum_box.hpp"

namespace spectralpack {
namespace {

/// From few to many: more take longer to search.
constexpr const char* kFiner[] = {"90", "90+box", "45", "30", "15"};

/// The paper's tray stands in the list, but is no machine.
constexpr const char* kNoMachine = "paper";

bool fits_in_one(const Mesh& mesh, double to_mm, const std::vector<Mat3>& orientations, const Vec3& room) {
    return std::ranges::any_of(orientations,
                               [&](const Mat3& turn) { return fits(turned_size(mesh, turn, to_mm), room); });
}

/// A mesh of the same size however it is turned.
Mesh outline_of(const Mesh& mesh) {
    Mesh outline;
    outline.vertices = convex_hull(mesh.vertices).vertices;
    if (outline.vertices.empty()) return mesh;
    for (std::uint32_t i = 0; i < outline.vertices.size(); ++i) {
        outline.triangles.push_back({i, i, i});
    }
    return outline;
}

/// Rotations that let it fit; empty where none of the usual ones does.
std::string finer_rotations(const TurnablePart& part, const Mesh& outline, const Vec3& room,
                            const std::string& rotations) {
    const Mat3 frame = minimum_box_frame(part.mesh);
    for (const char* finer : kFiner) {
        if (rotations == finer) continue;
        if (fits_in_one(outline, part.to_mm, orientation_set(parse_rotations(finer), part.may, frame), room)) {
            return finer;
        }
    }
    return "";
}

/// The smallest that takes it; null where none does.
const Printer* larger_printer(const TurnablePart& part, const Mesh& outline, std::span<const Printer> own) {
    const Printer* smallest = nullptr;
    const auto volume = [](const Printer& printer) { return printer.size.x * printer.size.y * printer.size.z; };
    for (const std::span<const Printer> list : {own, printers()}) {
        for (const Printer& printer : list) {
            const double walls = 2 * printer.wall_gap();
            if (printer.name == kNoMachine || (smallest && volume(*smallest) <= volume(printer))) continue;
            const Vec3 room = printer.size - Vec3{walls, walls, walls};
            if (fits_in_one(outline, part.to_mm, part.orientations, room)) smallest = &printer;
        }
    }
    return smallest;
}

std::string length_text(double mm) { return short_number(std::round(mm * 100) / 100); }

std::string size_text(const Vec3& size) {
    const std::string base = length_text(size.x) + " x " + length_text(size.y);
    return std::isinf(size.z) ? base + " mm, at any height" : base + " x " + length_text(size.z) + " mm";
}

/// It would fit, had the job not said how it may stand.
bool fits_when_free(const TurnablePart& part, const Mesh& outline, const Vec3& room, const std::string& rotations) {
    if (part.may.kind == PartOrientations::Kind::any) return false;
    return fits_in_one(outline, part.to_mm, orientation_set(parse_rotations(rotations), {}), room);
}

}  // namespace

Vec3 turned_size(const Mesh& mesh, const Mat3& turn, double to_mm) {
    Box box;
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            box.add(turn * (to_mm * mesh.vertices[vertex]));
        }
    }
    return box.size();
}

std::string why_too_large(const TurnablePart& part, const Vec3& room, const PackOptions& options, bool box,
                          std::span<const Printer> own) {
    if (fits_in_one(part.mesh, part.to_mm, part.orientations, room)) return "";
    const std::string why =
        size_text(turned_size(part.mesh, Mat3{}, part.to_mm)) + ", and there is room for " + size_text(room);
    const Mesh outline = outline_of(part.mesh);
    if (fits_when_free(part, outline, room, rotations_of(options))) {
        return why + ". It fits where it may be turned as --rotations says, and not just as its orientations do";
    }
    const std::string rotations = finer_rotations(part, outline, room, rotations_of(options));
    if (!rotations.empty()) return why + ". It fits with --rotations " + rotations;
    const Printer* printer = box ? larger_printer(part, outline, own) : nullptr;
    return printer ? why + ". It fits into " + printer->title + ": --printer " + printer->name : why;
}

}  // namespace spectralpack
