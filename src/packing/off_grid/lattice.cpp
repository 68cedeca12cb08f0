#include "packing/off_grid/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace spectralpack {
namespace {

constexpr std::size_t kMostParts = 16;  // left over, of which lattices are tried
class LatticeSearch {
  public:
    LatticeSearch(OffGrid& off_grid, PartSurfaces& surfaces, const std::vector<Copy>& wanted,
                  const std::vector<PlacedCopy>& placed)
        : off_grid_(off_grid), surfaces_(surfaces), wanted_(wanted), room_(off_grid.room_at_start()) {
        for (const PlacedCopy& copy : placed) {
            volume_ += box_volume(copy.copy.part);
        }
        for (const Copy& copy : wanted) {
            ++counts_[copy.part];
        }
    }

    void try_part(int part) {
        const double gap = surfaces_.part(part).gap;
        for (const TurnedBox& turned : off_grid_.boxes_of(part)) {
            const Vec3 size = turned.box.size();
            std::map<int, TurnedBox> alike;
            std::int64_t members = 0;
            for (const auto& [other, count] : counts_) {
                if (surfaces_.part(other).gap != gap) continue;
                for (const TurnedBox& box : off_grid_.boxes_of(other)) {
                    if (!is_same(size, box.box.size())) continue;
                    alike.emplace(other, box);
                    members += count;
                    break;
                }
            }
            const double one = size.x * size.y * size.z;
            if (!(static_cast<double>(members) * one > volume_)) continue;  // all of them would be less
            const std::vector<Vec3> corners = room_.lattice(size, gap, members);
            if (static_cast<double>(corners.size()) * one > volume_) take(alike, corners, one);
        }
    }

    std::optional<Lattice> best() && { return std::move(best_); }

  private:
    double box_volume(int part) const { return off_grid_.boxes_of(part).front().box.volume(); }

    static bool is_same(const Vec3& a, const Vec3& b) {
        const Vec3 d = a - b;
        return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) <= kSameSize;
    }

    void take(const std::map<int, TurnedBox>& alike, const std::vector<Vec3>& corners, double one) {
        Lattice lattice;
        auto copy = wanted_.begin();
        for (const Vec3& corner : corners) {
            copy = std::find_if(copy, wanted_.end(), [&](const Copy& next) { return alike.contains(next.part); });
            if (copy == wanted_.end()) break;
            const TurnedBox& turned = alike.at(copy->part);
            if (!off_grid_.may_stand(copy->part, turned, corner)) continue;
            lattice.copies.push_back({*copy++, turned, corner});
        }
        const double volume = static_cast<double>(lattice.copies.size()) * one;
        if (!(volume > volume_)) return;
        for (const auto& [part, turned] : alike) {
            lattice.parts.insert(part);
        }
        volume_ = volume;
        best_ = std::move(lattice);
    }

    OffGrid& off_grid_;
    PartSurfaces& surfaces_;
    const std::vector<Copy>& wanted_;
    BoxRoom room_;
    std::map<int, int> counts_;  // of wanted copies, by part
    double volume_ = 0;          // of boxes, to surpass
    std::optional<Lattice> best_;
};

}  // namespace

std::optional<Lattice> find_lattice(OffGrid& off_grid, PartSurfaces& surfaces, const std::vector<Copy>& wanted,
                                    const std::vector<PlacedCopy>& placed, const std::vector<Copy>& left_over) {
    LatticeSearch search(off_grid, surfaces, wanted, placed);
    std::set<int> tried;
    for (const Copy& copy : left_over) {
        if (tried.size() < kMostParts && tried.insert(copy.part).second) search.try_part(copy.part);
    }
    return std::move(search).best();
}

}  // namespace spectralpack
