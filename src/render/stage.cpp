#include "render/stage.hpp"

#include <map>
#include <numbers>
#include <string>

#include "model/palette.hpp"
#include "render/feature_edges.hpp"
#include "render/taking_apart.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

constexpr double kAside = 0.15;   // space between two trays of a row, of their width
constexpr double kBehind = 1.3;   // space between two rows, of the trays' height
constexpr double kSteepest = 15;  // degrees: seen from lower than this, rows would hide one another

const Vec3 kGrey{0.3, 0.3, 0.3};
const Vec3 kWhite{1, 1, 1};
constexpr double kPale = 0.72;   // of a pale copy's colour that is white
constexpr double kMuted = 0.75;  // of a copy's colour that is grey where another is what matters

std::array<Vec3, 8> corners(const Box& box) {
    std::array<Vec3, 8> result;
    for (std::size_t i = 0; i < 8; ++i) {
        result[i] = {i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z};
    }
    return result;
}

bool contains(const Box& outer, const Box& inner) {
    return min(outer.min, inner.min) == outer.min && max(outer.max, inner.max) == outer.max;
}

Box moved(const Box& box, const Transform& t) {
    Box result;
    for (const Vec3& corner : corners(box)) {
        result.add(t * corner);
    }
    return result;
}

/// Finite and not flat.
bool drawable(const Transform& t) {
    const double volume = determinant(t.linear);
    return std::isfinite(volume) && volume != 0 && std::isfinite(length(t.translation));
}

class StageBuilder {
  public:
    StageBuilder(const Packing& packing, const std::vector<std::shared_ptr<const Mesh>>& meshes, const View& view)
        : packing_(packing), meshes_(meshes), view_(view), options_(view.options), numbers_(packing.parts) {}

    Stage build() {
        choose_trays();
        take_apart();
        measure();
        set_out();
        normalize();
        cut();
        stage_.backdrop = view_.backdrop;
        stage_.camera = fit(stage_corners());
        return std::move(stage_);
    }

  private:
    void choose_trays() {
        const auto count = static_cast<int>(packing_.trays.size());
        if (options_.tray < -1 || options_.tray >= count) {
            // A packing without trays is still a container to show.
            if (options_.tray != 0 || count != 0) {
                throw UsageError("there is no tray " + std::to_string(options_.tray + 1) + ": the packing has " +
                                 std::to_string(count) + ", counted from 1");
            }
        }
        if (count == 0) {
            trays_.push_back(nullptr);
            return;
        }
        for (int i = 0; i < count; ++i) {
            if (options_.tray == -1 || options_.tray == i) {
                trays_.push_back(&packing_.trays[static_cast<std::size_t>(i)]);
            }
        }
    }

    /// Where each tray's copies are drawn.
    void take_apart() {
        if (options_.step && trays_.size() > 1) {
            throw UsageError("a step is one tray's: choose the tray, the packing has " + std::to_string(trays_.size()));
        }
        for (const TrayPacking* tray : trays_) {
            shown_copies_.emplace_back(tray ? tray->placements.size() : 0);
            if (!tray) continue;
            if (options_.step) {
                shown_copies_.back() = shown_step(*tray);
            } else if (options_.explode) {
                shown_copies_.back() = exploded(*tray);
            }
        }
    }

    std::vector<ShownCopy> shown_step(const TrayPacking& tray) const {
        if (!tray.disassembly) {
            throw UsageError("the packing has no disassembly plan, so how it comes apart cannot be drawn");
        }
        const auto steps = static_cast<int>(tray.disassembly->steps.size());
        if (*options_.step < 0 || *options_.step > steps) {
            throw UsageError("there is no step " + std::to_string(*options_.step) + ": the plan has " +
                             std::to_string(steps) + ", counted from 1");
        }
        return show_step(tray, *options_.step);
    }

    std::vector<ShownCopy> exploded(const TrayPacking& tray) {
        std::vector<Box> boxes;
        for (const Placement& placement : tray.placements) {
            boxes.push_back(moved(bounding_box(*mesh_of(placement)), placement.transform));
        }
        const ExplodedTray apart =
            show_exploded(boxes, packing_.container.size, options_.azimuth, options_.elevation, *options_.explode);
        floors_.push_back(apart.floors);
        return apart.copies;
    }

    /// The copy's own transform, moved to where it is drawn.
    Transform pose_of(std::size_t tray, std::size_t i) const {
        Transform pose = trays_[tray]->placements[i].transform;
        pose.translation = pose.translation + shown_copies_[tray][i].offset;
        return pose;
    }

    bool is_drawn(std::size_t tray, std::size_t i) const {
        return shown_copies_[tray][i].drawn && look_of(i) != Look::gone && drawable(pose_of(tray, i));
    }

    Look look_of(std::size_t i) const { return i < view_.looks.size() ? view_.looks[i] : Look::strong; }

    Vec3 colour_of(std::size_t tray, std::size_t i) const {
        const Placement& placement = trays_[tray]->placements[i];
        const Vec3 colour = copy_colour(placement.part, placement.copy);
        if (look_of(i) == Look::pale) return kPale * kWhite + (1 - kPale) * colour;
        if (!options_.step || *options_.step == 0) return colour;
        return shown_copies_[tray][i].leaving ? from_oklch(0.68, 0.2, 40) : kMuted * kGrey + (1 - kMuted) * colour;
    }

    const std::shared_ptr<const Mesh>& mesh_of(const Placement& placement) const {
        const auto part = static_cast<std::size_t>(placement.part);
        if (part >= meshes_.size() || !meshes_[part]) {
            throw UsageError("the packing places part " + std::to_string(placement.part) +
                             ", of which there is no mesh");
        }
        return meshes_[part];
    }

    /// Box of a tray with all that is in it, in container coordinates. Exact only where a copy's
    /// turned box leaves the container, which saves going through all vertices of all copies.
    void measure() {
        shown_ = {{0, 0, 0}, packing_.container.size};
        if (!floors_.empty()) shown_.max.z = 0;  // what is drawn apart reaches as high as it does
        for (const std::vector<double>& floors : floors_) {
            shown_.max.z = std::max(shown_.max.z, floors.back());
        }
        std::map<const Mesh*, Box> boxes;
        for (std::size_t tray = 0; tray < trays_.size(); ++tray) {
            for (std::size_t i = 0; i < shown_copies_[tray].size(); ++i) {
                const Mesh& mesh = *mesh_of(trays_[tray]->placements[i]);
                const auto [box, fresh] = boxes.try_emplace(&mesh);
                if (fresh) box->second = bounding_box(mesh);
                const Transform pose = pose_of(tray, i);
                if (!is_drawn(tray, i) || contains(shown_, moved(box->second, pose))) continue;
                for (const Triangle& triangle : mesh.triangles) {
                    for (const std::uint32_t vertex : triangle) {
                        shown_.add(pose * mesh.vertices[vertex]);
                    }
                }
            }
        }
        const double size = length(shown_.size());
        if (!(size > 0) || !std::isfinite(size)) {
            throw UsageError("the tray has no size that could be drawn");
        }
    }

    /// Picks the number of trays to a row that brings the furthest tray nearest.
    void set_out() {
        const double angle = options_.azimuth * std::numbers::pi / 180;
        const Vec3 size = shown_.size(), right{std::cos(angle), std::sin(angle), 0};
        const Vec3 back{-right.y, right.x, 0};
        const auto extent = [&](const Vec3& axis) { return std::abs(axis.x) * size.x + std::abs(axis.y) * size.y; };
        to_right_ = (1 + kAside) * extent(right) * right;
        to_back_ = (extent(back) + kBehind * size.z) * back;

        const auto count = static_cast<int>(trays_.size());
        const int least = options_.elevation < kSteepest ? count : 1;
        double nearest = 0;
        int best = 0;
        for (int columns = count; columns >= least; --columns) {
            columns_ = columns;
            const std::vector<Vec3> points = stage_corners();
            const Camera camera = fit(points);
            double furthest = 0;
            for (const Vec3& point : points) {
                furthest = std::max(furthest, length(camera.eye - point));
            }
            if (best == 0 || furthest < nearest) {
                best = columns;
                nearest = furthest;
            }
        }
        columns_ = best;
    }

    Camera fit(const std::vector<Vec3>& points) const {
        if (view_.lens == Lens::parallel) {
            return fit_parallel_camera(points, options_.azimuth, options_.elevation, options_.width, options_.height,
                                       view_.margin);
        }
        return fit_camera(points, options_.azimuth, options_.elevation, options_.width, options_.height);
    }

    Vec3 tray_origin(std::size_t tray) const {
        const auto i = static_cast<int>(tray);
        return (i % columns_) * to_right_ + (i / columns_) * to_back_;
    }

    /// Corners of all trays' boxes: in millimetres, or in stage units once those are chosen.
    std::vector<Vec3> stage_corners() const {
        std::vector<Vec3> result;
        for (std::size_t i = 0; i < trays_.size(); ++i) {
            for (const Vec3& corner : corners(shown_)) {
                result.push_back(to_stage_ * (corner + tray_origin(i)));
            }
        }
        return result;
    }

    void normalize() {
        Box all;
        for (const Vec3& corner : stage_corners()) {
            all.add(corner);
        }
        const double scale = 2 / length(all.size());
        to_stage_.linear = scale * Mat3{};
        to_stage_.translation = -(0.5 * scale) * (all.min + all.max);
        stage_.floor = to_stage_.translation.z + scale * shown_.min.z;

        stage_.millimetre = scale;

        for (std::size_t tray = 0; tray < trays_.size(); ++tray) {
            Transform place = to_stage_;
            place.translation = to_stage_ * tray_origin(tray);
            stage_.containers.push_back({place * Vec3{}, place * packing_.container.size});
            outline_walls(tray, place);
            for (std::size_t i = 0; i < shown_copies_[tray].size(); ++i) {
                if (!is_drawn(tray, i)) continue;
                const Placement& placement = trays_[tray]->placements[i];
                stage_.copies.push_back({staged_mesh(mesh_of(placement)), place * pose_of(tray, i), colour_of(tray, i),
                                         numbers_.of(placement), static_cast<int>(i), placement.fixed, look_of(i)});
            }
        }
    }

    int staged_mesh(const std::shared_ptr<const Mesh>& mesh) {
        const auto [index, fresh] = known_.try_emplace(mesh.get(), static_cast<int>(stage_.meshes.size()));
        if (fresh) stage_.meshes.push_back(mesh);
        return index->second;
    }

    /// A section keeps what lies behind its plane as the camera sees it.
    void cut() {
        if (view_.slab) {
            const double base = to_stage_.translation.z, mm = stage_.millimetre;
            stage_.kept = Kept{2, base + mm * view_.slab->first, base + mm * view_.slab->second};
        }
        if (!options_.section) return;
        if (trays_.size() > 1) throw UsageError("a section is one tray's: choose the tray");
        const Section& section = *options_.section;
        const double size = packing_.container.size[section.axis];
        if (!(section.at >= 0 && section.at <= size)) {
            throw UsageError("a section lies inside the tray, which is " + std::to_string(std::lround(size)) +
                             " mm long that way");
        }
        Kept kept{section.axis};
        const double at = to_stage_.translation[section.axis] + stage_.millimetre * section.at;
        (fit(stage_corners()).forward[section.axis] > 0 ? kept.low : kept.high) = at;
        stage_.kept = kept;
        stage_.hatched_cuts = true;
    }

    void outline_walls(std::size_t tray, const Transform& place) {
        const Container& container = packing_.container;
        if (tray < floors_.size()) {
            for (const double floor : floors_[tray]) {
                outline_floor(floor, place);
                if (tray == 0) stage_.layers.push_back((place * Vec3{0, 0, floor}).z);
            }
            return;
        }
        if (view_.outlines) outline(container.mesh, {{}, container.size}, place);
        for (const KeepOut& keep_out : container.keep_out) {
            if (view_.outlines) outline(keep_out.mesh, keep_out.box, place);
            const bool is_mesh = keep_out.mesh && keep_out.mesh->surface;
            const auto mesh = is_mesh ? keep_out.mesh->surface : std::make_shared<const Mesh>(box_of(keep_out.box));
            stage_.keep_outs.push_back({staged_mesh(mesh), place, {}});
        }
    }

    void outline_floor(double height, const Transform& place) {
        const Vec3& size = packing_.container.size;
        const std::array<Vec3, 4> corners{Vec3{0, 0, height}, Vec3{size.x, 0, height}, Vec3{size.x, size.y, height},
                                          Vec3{0, size.y, height}};
        for (std::size_t i = 0; i < 4; ++i) {
            stage_.edges.emplace_back(place * corners[i], place * corners[(i + 1) % 4]);
        }
    }

    static Mesh box_of(const Box& box) {
        Mesh mesh;
        for (const Vec3& corner : corners(box)) {
            mesh.vertices.push_back(corner);
        }
        mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                          {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
        return mesh;
    }

    /// A mesh without sharp edges, and one that has not been loaded, are shown by their boxes.
    void outline(const std::optional<StandingMesh>& mesh, const Box& box, const Transform& place) {
        std::vector<std::pair<Vec3, Vec3>> edges;
        if (mesh && mesh->surface) edges = feature_edges(*mesh->surface);
        for (const auto& [from, to] : edges) {
            stage_.edges.emplace_back(place * from, place * to);
        }
        if (edges.empty()) stage_.outlined.push_back({place * box.min, place * box.max});
    }

    const Packing& packing_;
    const std::vector<std::shared_ptr<const Mesh>>& meshes_;
    const View& view_;
    const RenderOptions& options_;
    CopyNumbers numbers_;
    std::vector<const TrayPacking*> trays_;             ///< null: a packing without trays
    std::vector<std::vector<ShownCopy>> shown_copies_;  ///< by tray and placement
    std::vector<std::vector<double>> floors_;           ///< by tray that is drawn apart: heights of its layers, mm
    std::map<const Mesh*, int> known_;                  ///< index into Stage::meshes; looked up only
    Box shown_;
    Vec3 to_right_, to_back_;  ///< from a tray to the next of its row, and to the next row
    int columns_ = 1;
    Transform to_stage_;
    Stage stage_;
};

}  // namespace

Stage set_stage(const Packing& packing, const std::vector<std::shared_ptr<const Mesh>>& meshes, const View& view) {
    return StageBuilder(packing, meshes, view).build();
}

Stage set_part_stage(const std::shared_ptr<const Mesh>& mesh, const Vec3& colour, int width, int height) {
    constexpr double kAzimuth = 35, kElevation = 28, kPartMargin = 0.02;
    const Box box = bounding_box(*mesh);
    const double size = length(box.size());
    Stage stage;
    stage.backdrop = Backdrop::white;
    stage.meshes = {mesh};
    StagedCopy copy;
    copy.colour = colour;
    if (size > 0 && std::isfinite(size)) {
        const double scale = 2 / size;
        copy.pose = {scale * Mat3{}, -(0.5 * scale) * (box.min + box.max)};
        stage.millimetre = scale;
        stage.copies = {copy};
    }
    std::vector<Vec3> points;
    for (const Vec3& vertex : mesh->vertices) {
        points.push_back(copy.pose * vertex);
    }
    if (points.empty()) points = {{-1, -1, -1}, {1, 1, 1}};
    stage.camera = fit_parallel_camera(points, kAzimuth, kElevation, width, height, kPartMargin);
    return stage;
}

}  // namespace spectralpack
