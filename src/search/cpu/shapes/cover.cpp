#include "search/cpu/shapes/cover.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "search/cpu/shapes/runs.hpp"
#include "voxel/split.hpp"

namespace spectralpack {
namespace {

using Word = BitGrid::Word;

/// A word of a row moved down by `by` voxels, those of the word behind it moved in; 0 <= by < 64.
Word moved_down(const Word* word, int by) { return *word >> by | word[1] << 1 << (63 - by); }

/// words[i] &= words[i + step], 0 behind the end; i in [0, count).
void erode_words(Word* words, std::size_t count, std::size_t step) {
    const std::size_t both = count - std::min(count, step);
    for (std::size_t i = 0; i < both; ++i) {
        words[i] &= words[i + step];
    }
    std::fill(words + both, words + count, Word{0});
}

/// Keeps the voxels v of which v + by e_axis is set too; 0 < by < 64.
void erode(BitGrid& bits, int axis, int by) {
    const Extent& n = bits.extent();
    if (n.empty()) return;
    const auto words = static_cast<std::size_t>(bits.words_per_row()), rows = static_cast<std::size_t>(n.y),
               layers = static_cast<std::size_t>(n.z), step = static_cast<std::size_t>(by);
    Word* all = bits.row(0, 0);
    if (axis == 0) {
        for (Word* row = all; row < all + words * rows * layers; row += words) {
            for (std::size_t w = 0; w + 1 < words; ++w) {
                row[w] &= moved_down(row + w, by);
            }
            row[words - 1] &= row[words - 1] >> by;
        }
    } else if (axis == 1) {
        for (std::size_t z = 0; z < layers; ++z) {
            erode_words(all + z * words * rows, words * rows, words * step);
        }
    } else {
        erode_words(all, words * rows * layers, words * rows * step);
    }
}

/// Where the corner of a piece of the form may lie for the piece to lie in the solid.
struct Fits {
    Form form;
    BitGrid corners;
};

/// All plates and cubes of `forms` that fit somewhere, the largest first.
std::vector<Fits> all_fits(const BitGrid& solid, const Forms& forms) {
    std::vector<Fits> result;
    BitGrid flat;  // corners of the smallest plates across z
    for (const int axes : {3, 5, 6, 7}) {
        if (axes == 7 && !forms.cubes) continue;
        const auto erode_all = [&](BitGrid& corners, int by, int among) {
            for (int axis = 0; axis < 3; ++axis) {
                if (among >> axis & 1) erode(corners, axis, by);
            }
        };
        const auto fits_in = [&](const Form& form) {
            bool fits = true;
            for (int axis = 0; axis < 3; ++axis) {
                fits = fits && form.size(axis) <= solid.extent()[axis];
            }
            return fits;
        };
        Form form{axes, Forms::kFirstPlate};
        if (!fits_in(form)) continue;
        BitGrid corners = axes == 7 ? std::move(flat) : solid;
        for (int by = 1; by < 1 << form.level; by *= 2) {
            erode_all(corners, by, axes == 7 ? 4 : axes);  // a cube holds plates
        }
        if (axes == 3 && forms.cubes) flat = corners;
        while (true) {
            if (corners.none()) break;
            result.push_back({form, corners});
            ++form.level;
            if (form.level > forms.last_plate || !fits_in(form)) break;
            erode_all(corners, 1 << (form.level - 1), axes);
        }
    }
    std::ranges::stable_sort(result, [](const Fits& a, const Fits& b) { return a.form.voxels() > b.form.voxels(); });
    return result;
}

/// Visits the words of a piece's voxels with a mask of those, until it answers false.
template <class Visit>
void for_each_word(BitGrid& bits, const Form& form, const VoxelIndex& corner, const Visit& visit) {
    const int length = form.size(0);
    const Word ones = (Word{1} << length) - 1;
    const int w = corner.x / 64, shift = corner.x % 64;
    for (int z = corner.z; z < corner.z + form.size(2); ++z) {
        for (int y = corner.y; y < corner.y + form.size(1); ++y) {
            Word* row = bits.row(y, z);
            if (!visit(row[w], ones << shift)) return;
            if (shift + length > 64 && !visit(row[w + 1], ones >> (64 - shift))) return;
        }
    }
}

/// Takes the piece with that corner if half of its rows are wanted whole.
void take(const Form& form, const VoxelIndex& corner, BitGrid& wanted, std::vector<VoxelIndex>& corners) {
    const bool straddles = corner.x % 64 + form.size(0) > 64;
    const int words = form.size(1) * form.size(2) * (straddles ? 2 : 1);
    int missing = 0;
    for_each_word(wanted, form, corner, [&](const Word& word, Word mask) {
        missing += (word & mask) != mask;
        return 2 * missing <= words;
    });
    if (2 * missing > words) return;
    for_each_word(wanted, form, corner, [](Word& word, Word mask) {
        word &= ~mask;
        return true;
    });
    corners.push_back(corner);
}

/// Takes pieces of one form whose middle is wanted: first those with a wanted voxel in the lower corner, then, for what
/// stands out above, in the upper corner. A word may be read behind the last of `wanted`.
void take_all(const Fits& fits, BitGrid& wanted, std::vector<VoxelIndex>& taken) {
    constexpr int kAtOnce = 8;  // words; where the forms before have left little, few are looked at by themselves
    const Form& form = fits.form;
    const Extent& n = wanted.extent();
    const int words = wanted.words_per_row(), count = (n.y - form.size(1) + 1) * words;
    const VoxelIndex last{form.size(0) - 1, form.size(1) - 1, form.size(2) - 1};
    const VoxelIndex middle{form.size(0) / 2, form.size(1) / 2, form.size(2) / 2};
    for (const VoxelIndex& to : {VoxelIndex{}, last}) {
        for (int z = 0; z + form.size(2) <= n.z; ++z) {
            const Word* corners = fits.corners.row(0, z);
            const Word* at = wanted.row(to.y, z + to.z);
            const Word* inside = wanted.row(middle.y, z + middle.z);
            const auto candidates = [&](int i) {
                return corners[i] & moved_down(at + i, to.x) & moved_down(inside + i, middle.x);
            };
            for (int first = 0; first < count; first += kAtOnce) {
                const int end = std::min(count, first + kAtOnce);
                Word any = 0;
                for (int i = first; i < end; ++i) {
                    any |= candidates(i);
                }
                for (int i = any == 0 ? end : first; i < end; ++i) {
                    Word behind = ~Word{0};
                    for (Word bits = candidates(i); bits != 0; bits = candidates(i) & behind) {
                        const int x = std::countr_zero(bits);
                        behind = x == 63 ? 0 : ~Word{0} << (x + 1);
                        take(form, {i % words * 64 + x, i / words, z}, wanted, taken);
                    }
                }
            }
        }
    }
}

/// Clears bits [begin, end) of a row.
void clear_stretch(Word* row, int begin, int end) {
    const Word from = ~Word{0} << (begin % 64), to = ~Word{0} >> (63 - (end - 1) % 64);
    const int first = begin / 64, last = (end - 1) / 64;
    if (first == last) {
        row[first] &= ~(from & to);
        return;
    }
    row[first] &= ~from;
    std::fill(row + first + 1, row + last, Word{0});
    row[last] &= ~to;
}

/// A form once it is turned.
Form turned(const Form& form, const AxisTurn& turn) {
    int axes = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        axes |= (form.axes >> turn.order[axis] & 1) << axis;
    }
    return {axes, form.level};
}

/// cover() of voxels that are `detail` to one of dx, in a grid that lies at `offset` from a position.
Pieces cover_at(const VoxelIndex& offset, const BitGrid& solid, BitGrid wanted, int detail = 1) {
    Pieces pieces = cover(solid, std::move(wanted), BitTables::forms_for(detail));
    for (VoxelIndex& corner : pieces.corners) {
        corner = corner + offset;
    }
    return pieces;
}

}  // namespace

Pieces cover(const BitGrid& solid, BitGrid wanted, const Forms& forms) {
    Pieces pieces;
    // What a corner's row moves in from the row behind is beyond where the form fits.
    wanted.words().push_back(0);
    const auto end_form = [&](const Form& form) {
        const std::uint32_t begin = pieces.forms.empty() ? 0 : pieces.forms.back().end;
        const auto end = static_cast<std::uint32_t>(pieces.corners.size());
        if (end > begin) pieces.forms.push_back({form, begin, end});
    };
    for (const Fits& fits : all_fits(solid, forms)) {
        take_all(fits, wanted, pieces.corners);
        end_form(fits.form);
    }
    const Runs rest = fewest_runs(wanted);
    pieces.corners.reserve(pieces.corners.size() + rest.runs.size());
    for (int level = forms.run_levels; level >= 0; --level) {
        const int size = 1 << level,
                  longest = level < forms.run_levels ? 2 * size - 1 : std::numeric_limits<int>::max();
        for (const Run& run : rest.runs) {
            if (run.length < size || run.length > longest) continue;
            for (int done = 0; done < run.length; done += size) {
                VoxelIndex& corner = pieces.corners.emplace_back(run.start);
                corner[rest.axis] += std::min(done, run.length - size);
            }
        }
        end_form({1 << rest.axis, level});
    }
    return pieces;
}

CoveredVoxels cover(const WidenedVoxels& wide, int detail, const Workers& workers) {
    if (detail == 1) return {cover_at(wide.offset, *wide.voxels, *wide.voxels), {}};
    const CoarseVoxels core = filled_voxels(*wide.voxels, wide.offset, detail);
    BitGrid skin = *wide.voxels;
    for (const Run& run : runs_along(core.voxels, 0).runs) {
        VoxelIndex first;
        for (int axis = 0; axis < 3; ++axis) {
            first[axis] = detail * (run.start[axis] + core.offset[axis]) - wide.offset[axis];
        }
        for (int row = 0; row < detail * detail; ++row) {
            clear_stretch(skin.row(first.y + row % detail, first.z + row / detail), first.x,
                          first.x + detail * run.length);
        }
    }
    CoveredVoxels result;
    workers.for_each(2, [&](std::int64_t i) {
        if (i == 0) result.pieces = cover_at(wide.offset, *wide.voxels, std::move(skin), detail);
        if (i == 1) result.core = cover_at(core.offset, core.voxels, core.voxels);
    });
    return result;
}

Pieces turned(const Pieces& pieces, const AxisTurn& turn, const Extent& grid) {
    Pieces result;
    result.forms.reserve(pieces.forms.size());
    result.corners.reserve(pieces.corners.size());
    for (const Pieces::OfForm& of : pieces.forms) {
        result.forms.push_back({turned(of.form, turn), of.begin, of.end});
        const TurnedCorners there(turn, grid, {of.form.size(0), of.form.size(1), of.form.size(2)});
        for (const VoxelIndex& corner : pieces.corners_of(of)) {
            result.corners.push_back(there(corner));
        }
    }
    return result;
}

}  // namespace spectralpack
