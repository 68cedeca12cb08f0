#include "search/cpu/free/free_tiles.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

#include "search/cpu/tuning.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "search/cpu/free/free_tiles.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace spectralpack {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Sets in `blocked` the positions of a tile, whose corner is position (64 word, y, z), that some look finds to
/// collide. True when it ended early because all that is `wanted` collides.
bool BlockTile(const TileLooks& looks, const std::vector<TileLayer>& layers, int words, int word, int y, int z,
               const std::uint64_t* wanted, std::uint64_t* blocked) {
    constexpr int kRows = FreeTileReader::kRows;
    const hn::CappedTag<std::uint64_t, kRows> d;
    constexpr std::size_t kStep = hn::MaxLanes(d);
    constexpr std::size_t kVectors = kRows / kStep;
    hn::Vec<decltype(d)> known[kVectors];
    for (std::size_t v = 0; v < kVectors; ++v) {
        known[v] = hn::LoadU(d, blocked + v * kStep);
    }
    const auto columns = static_cast<unsigned>(words + 1);
    const auto take = [&](const DilatedRows& rows, int at_word, int at_y, const TileLook* look, const TileLook* end) {
        const std::uint64_t* levels[DilatedRows::kLevels];
        for (int level = 0; level < DilatedRows::kLevels; ++level) {
            levels[level] = rows.words + level * rows.table + at_word * rows.stride + at_y;
        }
        const std::ptrdiff_t next = rows.stride;
        hn::Vec<decltype(d)> so_far[kVectors];  // in registers
        for (std::size_t v = 0; v < kVectors; ++v) {
            so_far[v] = known[v];
        }
        for (; look != end; ++look) {
            const std::uint64_t* low = levels[look->level] + look->y;
            if (look->shift == 0) {
                for (std::size_t v = 0; v < kVectors; ++v) {
                    so_far[v] = hn::Or(so_far[v], hn::LoadU(d, low + v * kStep));
                }
                continue;
            }
            const auto down = hn::Set(d, std::uint64_t{look->shift});
            const auto rest = hn::Sub(hn::Set(d, std::uint64_t{64}), down);
            for (std::size_t v = 0; v < kVectors; ++v) {
                so_far[v] = hn::Or3(so_far[v], hn::Shr(hn::LoadU(d, low + v * kStep), down),
                                    hn::Shl(hn::LoadU(d, low + next + v * kStep), rest));
            }
        }
        for (std::size_t v = 0; v < kVectors; ++v) {
            known[v] = so_far[v];
        }
    };
    const auto all_collide = [&] {
        bool all = true;
        for (std::size_t v = 0; v < kVectors; ++v) {
            const auto open = hn::AndNot(known[v], hn::LoadU(d, wanted + v * kStep));
            all = all && hn::AllTrue(d, hn::Eq(open, hn::Zero(d)));
        }
        return all;
    };
    // Takes looks until all that is wanted collides: true then.
    const auto take_some = [&](const DilatedRows& rows, int at_word, int at_y, const TileLook* look,
                               const TileLook* end) {
        while (look < end) {
            const TileLook* const next = end - look > tuning::kLooksPerCheck ? look + tuning::kLooksPerCheck : end;
            take(rows, at_word, at_y, look, next);
            if (all_collide()) return true;
            look = next;
        }
        return false;
    };
    const auto take_group = [&](const TileLookGroup& group) {
        const auto at_layer = static_cast<unsigned>(z + group.z);  // below 0 is beyond all, too
        const int at_word = word + group.word, at_y = y + group.y;
        if (at_layer >= layers.size() || static_cast<unsigned>(at_word + 1) >= columns) return false;
        const TileLayer& layer = layers[at_layer];
        const DilatedRows& rows = *layer.all;
        const TileLook* const begin = looks.looks.data() + group.begin;
        const TileLook* const end = looks.looks.data() + group.end;
        // The first look from `from` on that reads row `row` or a later one.
        const auto from_row = [&](const TileLook* from, int row) {
            if (from == end || at_y + from->y >= row) return from;
            if (at_y + end[-1].y < row) return end;
            return std::lower_bound(from, end, row, [&](const TileLook& look, int r) { return at_y + look.y < r; });
        };
        const TileLook* const first = from_row(begin, rows.begin - (kRows - 1));
        const TileLook* const last = from_row(first, rows.end);
        if (layer.from > at_word || at_word >= layer.to) return take_some(rows, at_word, at_y, first, last);
        const TileLook* const out = std::min(last, from_row(first, layer.begin - (kRows - 1)));
        const TileLook* const in = std::min(last, from_row(out, layer.end));
        return take_some(rows, at_word, at_y, first, out) || take_some(*layer.without, at_word, at_y, out, in) ||
               take_some(rows, at_word, at_y, in, last);
    };
    const bool early = std::ranges::any_of(looks.spread, take_group) || std::ranges::any_of(looks.others, take_group);
    for (std::size_t v = 0; v < kVectors; ++v) {
        hn::StoreU(known[v], d, blocked + v * kStep);
    }
    return early;
}

}  // namespace HWY_NAMESPACE
}  // namespace spectralpack
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spectralpack {
namespace {

HWY_EXPORT(BlockTile);

/// A stride that visits 0 .. n - 1 in jumps of about the golden section, so that any first part is spread over all.
std::size_t spreading_stride(std::size_t n) {
    auto stride = static_cast<std::size_t>(0.618 * static_cast<double>(n)) | 1;
    while (std::gcd(stride, n) != 1) {
        ++stride;
    }
    return stride;
}

}  // namespace

FreeTiles::FreeTiles(const Tray& tray, std::shared_ptr<DilatedLayers> layers, const FreeQuery& query,
                     std::shared_ptr<const BitGrid> solid)
    : tray_(tray),
      shared_(std::move(layers)),
      solid_(std::move(solid)),
      layers_(static_cast<std::size_t>(tray.extent().z)) {
    static_assert(kRows == DilatedRows::kTogether);
    for (int axis = 0; axis < 3; ++axis) {
        origin_[axis] = -(solid_->extent()[axis] - 1) - query.padding;
        extent_[axis] = tray.extent()[axis] + solid_->extent()[axis] - 1 + 2 * query.padding;
    }
    if (!query.without) return;
    const VoxelBox out = intersection(tray.object(*query.without).box(), whole(tray.extent()));
    if (out.empty()) return;
    out_ = out;
    read_ = DilatedRows::read_for(out_, tray.extent());
    voxels_without_ = tray.omega_move(read_, query.without);
    without_.resize(static_cast<std::size_t>(out_.hi.z - out_.lo.z));
}

TileLooks FreeTiles::looks_for(const BitGrid& voxels) const {
    constexpr int kLevels = DilatedRows::kLevels;
    constexpr int kLongest = 2 << (kLevels - 1);
    struct Look {
        int word, y, z;
        std::uint8_t level, shift;

        bool operator==(const Look&) const = default;
    };
    std::vector<std::array<Look, 2> > all;  // of a run, at its ends; by z and y
    for (const Run& run : runs_along(voxels, 0).runs) {
        for (int done = 0; done < run.length; done += kLongest) {
            const int length = std::min(kLongest, run.length - done);
            const int level = std::min(static_cast<int>(std::bit_width(static_cast<unsigned>(length))), kLevels) - 1;
            const int begin = origin_.x + run.start.x + done + DilatedRows::kShift;
            const auto look = [&](int bit) {
                return Look{bit >> 6, origin_.y + run.start.y, origin_.z + run.start.z,
                            static_cast<std::uint8_t>(level), static_cast<std::uint8_t>(bit & 63)};
            };
            all.push_back({look(begin), look(begin + length - (1 << level))});
        }
    }
    const auto for_ends = [](const std::array<Look, 2>& ends, const auto& visit) {
        visit(ends[0]);
        if (ends[1] != ends[0]) visit(ends[1]);
    };
    TileLooks result;
    const auto append = [&](std::vector<TileLookGroup>& groups, const Look& look, bool join) {
        const std::size_t at = result.looks.size();
        if (!join || groups.empty() || groups.back().word != look.word || groups.back().z != look.z ||
            look.y - groups.back().y > std::numeric_limits<std::uint16_t>::max()) {
            groups.push_back({look.word, look.y, look.z, at, at});
        }
        result.looks.push_back({static_cast<std::uint16_t>(look.y - groups.back().y), look.level, look.shift});
        groups.back().end = at + 1;
    };
    std::vector<bool> taken(all.size(), false);
    const std::size_t stride = spreading_stride(all.size());
    for (std::size_t i = 0, at = 0; i < std::min(all.size(), tuning::kSpreadLooks);
         ++i, at = (at + stride) % all.size()) {
        for_ends(all[at], [&](const Look& look) { append(result.spread, look, false); });
        taken[at] = true;
    }
    // Layer by layer, of each the looks into its first word before those into the next.
    result.looks.reserve(2 * all.size());
    std::vector<Look> layer;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!taken[i]) for_ends(all[i], [&](const Look& look) { layer.push_back(look); });
        if (layer.empty() || (i + 1 < all.size() && all[i + 1][0].z == all[i][0].z)) continue;
        const auto [first, last] = std::ranges::minmax(layer, {}, &Look::word);
        for (int word = first.word; word <= last.word; ++word) {
            for (const Look& look : layer) {
                if (look.word == word) append(result.others, look, true);
            }
        }
        layer.clear();
    }
    return result;
}

/// Those of layers begin .. end - 1 that lie in the tray.
void FreeTiles::make_layers(int begin, int end) {
    for (int z = std::max(0, begin); z < std::min(end, tray_.extent().z); ++z) {
        TileLayer& layer = layers_[static_cast<std::size_t>(z)];
        if (layer.all) continue;
        layer.all = &shared_->layer(tray_, z);
        if (layer.all->words && out_.lo.z <= z && z < out_.hi.z) leave_out(layer, z);
    }
}

/// Of the layer's tables what the object that is out has something in, made anew without it.
void FreeTiles::leave_out(TileLayer& layer, int z) {
    const DilatedRows& all = *layer.all;
    layer.begin = out_.lo.y;
    layer.end = out_.hi.y;
    layer.from = DilatedRows::first_word(out_.lo.x) - 1;
    layer.to = DilatedRows::last_word(out_.hi.x) + 1;
    const int first_row = layer.begin - (kRows - 1), rows = layer.end + kRows - 1 - first_row;
    const int columns = layer.to + 1 - layer.from;

    Without& without = without_[static_cast<std::size_t>(z - out_.lo.z)];
    without.words = std::make_unique_for_overwrite<DilatedRows::Word[]>(DilatedRows::words_in(columns, rows));
    DilatedRows& part = without.rows;
    part.lie_in(without.words.get(), layer.from, columns, first_row, rows);
    for (int level = 0; level < DilatedRows::kLevels; ++level) {
        for (int word = layer.from; word <= layer.to; ++word) {
            std::copy_n(all.words + level * all.table + word * all.stride + first_row, rows,
                        part.words + level * part.table + word * part.stride + first_row);
        }
    }
    part.make(layer_of(out_, z), voxels_without_, read_.lo);
    layer.without = &part;
}

FreeTileReader::Told FreeTiles::tell(int i, int j, int z, const Rows& wanted) {
    const int y = kRows * j, rows = std::min(kRows, extent_.y - y), bits = std::min(64, extent_.x - 64 * i);
    Told told;
    Rows blocked;
    blocked.fill(~std::uint64_t{0});
    std::fill_n(blocked.begin(), rows, bits == 64 ? 0 : ~std::uint64_t{0} << bits);
    if (looks_.spread.empty()) looks_ = looks_for(*solid_);
    make_layers(z + origin_.z, z + origin_.z + solid_->extent().z);
    const bool early =
        HWY_DYNAMIC_DISPATCH(BlockTile)(looks_, layers_, shared_->words(), i, y, z, wanted.data(), blocked.data());
    if (early) {
        told.known = blocked;
        return told;
    }
    told.known.fill(~std::uint64_t{0});
    std::transform(blocked.begin(), blocked.end(), told.free.begin(), [](std::uint64_t word) { return ~word; });
    return told;
}

}  // namespace spectralpack
#endif
