/// second_check PACKING.json: judges a packing of STL files without any of spectralpack's code, by docs/format.md and
/// docs/conventions.md alone. Pairs of triangles are CGAL's; plans are followed by sweeping triangles.
///
/// Prints one JSON object. Exit status: 0 sound, 1 something is wrong, 2 it cannot judge this one.

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>

#include "body.hpp"
#include "stl.hpp"

namespace second {
namespace {

using nlohmann::json;
using Corners = std::vector<std::array<Point, 3>>;

constexpr double kTouching = 1.1e-3;  // mm: an overlap of 0.001 is touching (docs/conventions.md)
constexpr double kRounding = 1e-5;    // mm
constexpr double kDensity = 1e-6;

struct Copy {
    int part, number;
    bool fixed;
    double gap;
    Body body;
};

std::array<std::array<double, 4>, 4> matrix(const json& rows) {
    if (rows.is_null()) return {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    return rows.get<std::array<std::array<double, 4>, 4>>();
}

Body place(const Corners& mesh, const json& transform) {
    const auto m = matrix(transform);
    const auto moved = [&](const Point& p) {
        const auto row = [&](int r) { return m[r][0] * p.x() + m[r][1] * p.y() + m[r][2] * p.z() + m[r][3]; };
        return Point(row(0), row(1), row(2));
    };
    std::vector<Triangle> triangles;
    for (const auto& corners : mesh) {
        triangles.emplace_back(moved(corners[0]), moved(corners[1]), moved(corners[2]));
    }
    Body body(std::move(triangles));
    if (body.volume() >= 0) return body;
    std::vector<Triangle> outward;  // the file's normals point inward
    for (const Triangle& t : body.triangles()) {
        outward.emplace_back(t[0], t[2], t[1]);
    }
    return Body(std::move(outward));
}

Body block(const std::array<double, 3>& min, const std::array<double, 3>& max) {
    Corners faces;
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool top : {false, true}) {
            const auto corner = [&](bool u, bool v) {
                std::array<double, 3> p;
                p[axis] = top ? max[axis] : min[axis];
                p[(axis + 1) % 3] = u ? max[(axis + 1) % 3] : min[(axis + 1) % 3];
                p[(axis + 2) % 3] = v ? max[(axis + 2) % 3] : min[(axis + 2) % 3];
                return Point(p[0], p[1], p[2]);
            };
            const Point a = corner(false, false), b = corner(true, false), c = corner(true, true),
                        d = corner(false, true);
            faces.push_back(top ? std::array{a, b, c} : std::array{a, c, b});
            faces.push_back(top ? std::array{a, c, d} : std::array{a, d, c});
        }
    }
    return place(faces, nullptr);
}

class Judge {
  public:
    explicit Judge(const std::filesystem::path& file) : folder_(file.parent_path()) {
        std::ifstream in(file);
        packing_ = json::parse(in);
        size_ = packing_["container"]["size"].get<std::array<double, 3>>();
        open_ = packing_["container"].value("open_height", false);
        physical_ = packing_["container"].value("physical", false);
        wall_gap_ = packing_["options"].value("wall-gap", 0.);
        const json& container = packing_["container"];
        if (container["mesh"].is_string()) {
            // Of a vessel the mesh is among the keep-outs, and the room in it is for them alone to bound.
            vessel_ = container.value("is", json()) == "vessel";
            if (!vessel_) container_ = std::make_unique<Body>(place(mesh(container["mesh"]), container["transform"]));
        }
        for (const json& keep_out : container["keep_out"]) {
            if (keep_out.contains("box")) {
                const auto corners = keep_out["box"].get<std::array<std::array<double, 3>, 2>>();
                std::array<double, 3> min, max;
                for (int axis = 0; axis < 3; ++axis) {
                    std::tie(min[axis], max[axis]) = std::minmax(corners[0][axis], corners[1][axis]);
                }
                keep_outs_.push_back(block(min, max));
            } else {
                keep_outs_.push_back(place(mesh(keep_out["mesh"]), keep_out.value("transform", json())));
            }
        }
    }

    json judge() {
        count();
        for (std::size_t t = 0; t < packing_["trays"].size(); ++t) {
            tray_ = t;
            judge_tray(packing_["trays"][t]);
        }
        return {{"ok", findings_.empty()}, {"copies", copies_}, {"pairs", pairs_},
                {"steps", steps_},         {"sweeps", sweeps_}, {"findings", findings_}};
    }

  private:
    const Corners& mesh(const std::string& name) {
        const auto [entry, is_new] = meshes_.try_emplace(name);
        if (is_new) entry->second = read_stl((folder_ / name).string());
        return entry->second;
    }

    void find(const std::string& what) { findings_.push_back("tray " + std::to_string(tray_) + ": " + what); }
    std::string name(std::size_t i) const {
        return "placement " + std::to_string(i) + " (part " + std::to_string(copies_of_tray_[i].part) + ", copy " +
               std::to_string(copies_of_tray_[i].number) + ")";
    }

    /// Every copy is somewhere, once.
    void count() {
        std::set<std::pair<int, int>> seen;
        const auto see = [&](const json& copy) {
            if (!seen.emplace(copy["part"].get<int>(), copy["copy"].get<int>()).second) {
                find("part " + copy["part"].dump() + " copy " + copy["copy"].dump() + " is there twice");
            }
        };
        for (const json& tray : packing_["trays"]) {
            std::ranges::for_each(tray["placements"], see);
        }
        std::ranges::for_each(packing_["unplaced"], see);
        for (std::size_t part = 0; part < packing_["parts"].size(); ++part) {
            const auto count = std::ranges::count_if(seen, [&](auto& copy) { return copy.first == int(part); });
            if (count != packing_["parts"][part]["count"].get<int>()) {
                find("of part " + std::to_string(part) + " there are " + std::to_string(count) + " copies");
            }
        }
    }

    void judge_tray(const json& tray) {
        copies_of_tray_.clear();
        double volume = 0;
        for (const json& placement : tray["placements"]) {
            const json& part = packing_["parts"].at(placement["part"].get<std::size_t>());
            copies_of_tray_.push_back({placement["part"].get<int>(), placement["copy"].get<int>(),
                                       placement["fixed"].get<bool>(), part["gap"].get<double>(),
                                       place(mesh(part["mesh"].get<std::string>()), placement["transform"])});
            judge_transform(placement, part);
            volume += copies_of_tray_.back().body.volume();
            ++copies_;
        }
        if (!container_ && !vessel_ && volume > 0) {
            const double density = volume / (size_[0] * size_[1] * size_[2]);
            if (std::abs(density - tray["density"].get<double>()) > kDensity) {
                find("the density is " + std::to_string(density));
            }
        }
        for (std::size_t i = 0; i < copies_of_tray_.size(); ++i) {
            judge_walls(i);
            for (std::size_t k = 0; k < i; ++k) {
                judge_pair(i, k);
            }
        }
        if (!tray["disassembly"].is_null()) follow(tray["disassembly"]);
    }

    void judge_transform(const json& placement, const json& part) {
        const auto m = matrix(placement["transform"]);
        const Vector rows[] = {{m[0][0], m[0][1], m[0][2]}, {m[1][0], m[1][1], m[1][2]}, {m[2][0], m[2][1], m[2][2]}};
        const double scale = part["scale"].get<double>() * part["unit"].get<double>();
        double worst = 0;
        for (int r = 0; r < 3; ++r) {
            for (int c = 0; c < 3; ++c) {
                worst = std::max(worst, std::abs(rows[r] * rows[c] / (scale * scale) - (r == c ? 1 : 0)));
            }
        }
        if (worst > 1e-6 || CGAL::determinant(rows[0], rows[1], rows[2]) <= 0) {
            find(name(copies_of_tray_.size() - 1) + " is not turned and scaled as it should be");
        }
    }

    void judge_walls(std::size_t i) {
        const Copy& copy = copies_of_tray_[i];
        const double wall_gap = copy.fixed ? 0 : wall_gap_;
        const Box box = copy.body.box();
        for (int axis = 0; axis < 3; ++axis) {
            const double above = axis == 2 && open_ ? 0 : wall_gap;
            if (box.min[axis] < wall_gap - kRounding - (wall_gap > 0 ? 0 : kTouching) ||
                box.max[axis] > size_[axis] - above + kRounding + (above > 0 ? 0 : kTouching)) {
                if (!vessel_) find(name(i) + " stands out of the tray or too near to its walls");
            }
        }
        if (container_) {
            if (!lies_wholly_in(copy.body, *container_, kTouching)) find(name(i) + " is not in the container");
            judge_apart(i, *container_, wall_gap, "the container", false);
        }
        for (const Body& keep_out : keep_outs_) {
            judge_apart(i, keep_out, wall_gap, "a keep-out", true);
        }
    }

    void judge_pair(std::size_t i, std::size_t k) {
        const Copy &a = copies_of_tray_[i], &b = copies_of_tray_[k];
        judge_apart(i, b.body, a.fixed && b.fixed ? 0 : std::max(a.gap, b.gap), name(k), true);
    }

    void judge_apart(std::size_t i, const Body& other, double gap, const std::string& what, bool solid) {
        const Body& body = copies_of_tray_[i].body;
        const double apart = body.box().apart(other.box());
        if (apart > gap) return;
        ++pairs_;
        const double least = distance(body, other, std::max(gap, 1e-6));
        if (least == 0 && cross(body, other, Vector(0, 0, 0), kTouching)) return find(name(i) + " runs into " + what);
        if (solid && (lies_in(body, other, least == 0, kTouching) || lies_in(other, body, least == 0, kTouching))) {
            return find(name(i) + " and " + what + " lie in each other");
        }
        if (gap > 0 && least < gap - kRounding) {
            find(name(i) + " is " + std::to_string(least) + " mm from " + what + ", not " + std::to_string(gap));
        }
    }

    /// Replays a plan: docs/format.md, "Disassembly plans".
    void follow(const json& plan) {
        const bool from_the_top = plan.value("unpack", "any") == "top";
        std::set<int> through_walls;
        if (from_the_top) through_walls = plan.value("through_walls", std::set<int>());
        std::vector<int> together(copies_of_tray_.size(), 0);  // -1: gone
        std::vector<bool> alone(copies_of_tray_.size(), false);
        int subassemblies = 1;
        for (std::size_t s = 0; s < plan["steps"].size(); ++s) {
            const auto moved = plan["steps"][s]["placements"].get<std::set<std::size_t>>();
            const std::string step = "step " + std::to_string(s);
            ++steps_;
            if (moved.empty() || *moved.rbegin() >= together.size()) return find(step + " moves nothing that is there");
            const int of = together[*moved.begin()];
            for (const std::size_t i : moved) {
                if (together[i] != of || of < 0) return find(step + " moves what is gone or stands apart");
                if (copies_of_tray_[i].fixed) return find(step + " moves a fixed copy");
            }
            const bool walls = of == 0 && (physical_ || (from_the_top && !through_walls.contains(int(s))));
            std::vector<std::size_t> left;
            for (std::size_t i = 0; i < together.size(); ++i) {
                if (together[i] == of && !moved.contains(i)) left.push_back(i);
            }
            if (moved.size() > 1 && left.empty()) return find(step + " moves all that stands together");
            follow_step(step, moved, left, plan["steps"][s]["path"], walls);
            const int now = moved.size() == 1 ? -1 : subassemblies++;
            for (const std::size_t i : moved) {
                together[i] = now;
                alone[i] = now == -1;
            }
        }
        if (!plan["complete"].get<bool>()) return;
        for (std::size_t i = 0; i < alone.size(); ++i) {
            if (!alone[i] && !copies_of_tray_[i].fixed) find("the plan is complete without " + name(i));
        }
    }

    void follow_step(const std::string& step, const std::set<std::size_t>& moved, const std::vector<std::size_t>& left,
                     const json& path, bool walls) {
        Vector offset(0, 0, 0);
        std::vector<const Body*> in_the_way;
        for (const std::size_t i : left) {
            in_the_way.push_back(&copies_of_tray_[i].body);
        }
        const std::vector<Body> built = walls ? walls_below_the_top() : std::vector<Body>();
        for (const Body& wall : built) {
            in_the_way.push_back(&wall);
        }
        for (const json& leg : path) {
            const auto l = leg.get<std::array<double, 3>>();
            const Vector way(l[0], l[1], l[2]);
            for (const std::size_t i : moved) {
                const Body here = shifted(copies_of_tray_[i].body, offset);
                for (std::size_t k = 0; k < in_the_way.size(); ++k) {
                    ++sweeps_;
                    if (!cross(here, *in_the_way[k], way, kTouching)) continue;
                    return find(step + ": " + name(i) + " runs into " + (k < left.size() ? name(left[k]) : "a wall"));
                }
            }
            offset = offset + way;
        }
        if (left.empty() && !walls) return;
        Box out, rest;
        for (const std::size_t i : moved) {
            out.add(copies_of_tray_[i].body.box().moved(offset));
        }
        for (const std::size_t i : left) {
            rest.add(copies_of_tray_[i].body.box());
        }
        if (!left.empty() && out.apart(rest) < -kTouching) find(step + " does not end outside of what is left");
        if (walls && out.min[2] < size_[2] - kTouching) find(step + " does not end above the top");
    }

    static Body shifted(const Body& body, const Vector& by) {
        std::vector<Triangle> triangles;
        for (const Triangle& t : body.triangles()) {
            triangles.emplace_back(t[0] + by, t[1] + by, t[2] + by);
        }
        return Body(std::move(triangles));
    }

    /// What is really there besides copies, or as if it were: floor, sides, keep-outs. The top is open.
    std::vector<Body> walls_below_the_top() {
        std::vector<Body> walls = keep_outs_;
        if (container_) {
            std::vector<Triangle> below;
            for (const Triangle& t : container_->triangles()) {
                const double top = container_->box().max[2] - kRounding;
                if (t[0].z() < top || t[1].z() < top || t[2].z() < top) below.push_back(t);
            }
            walls.push_back(Body(std::move(below)));
        } else if (!vessel_) {
            constexpr double kThick = 1000;
            for (int axis = 0; axis < 2; ++axis) {
                std::array<double, 3> min{-kThick, -kThick, -kThick},
                    max{size_[0] + kThick, size_[1] + kThick, size_[2]};
                max[axis] = 0;
                walls.push_back(block(min, max));
                max[axis] = size_[axis] + kThick;
                min[axis] = size_[axis];
                walls.push_back(block(min, max));
            }
            walls.push_back(block({-kThick, -kThick, -kThick}, {size_[0] + kThick, size_[1] + kThick, 0}));
        }
        return walls;
    }

    std::filesystem::path folder_;
    json packing_;
    std::array<double, 3> size_;
    bool open_, physical_, vessel_ = false;
    double wall_gap_;
    std::unique_ptr<Body> container_;
    std::vector<Body> keep_outs_;
    std::map<std::string, Corners> meshes_;

    std::size_t tray_ = 0;
    std::vector<Copy> copies_of_tray_;
    long copies_ = 0, pairs_ = 0, steps_ = 0, sweeps_ = 0;
    std::vector<std::string> findings_;
};

}  // namespace
}  // namespace second

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: second_check PACKING.json\n", stderr);
        return 2;
    }
    try {
        const nlohmann::json verdict = second::Judge(argv[1]).judge();
        std::cout << verdict.dump(1) << '\n';
        return verdict["ok"].get<bool>() ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << "second_check: " << error.what() << '\n';
        return 2;
    }
}
