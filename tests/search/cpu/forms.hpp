#pragma once
/// Forms and the voxels of pieces, for tests of what looks them up.

#include <vector>

#include "search/cpu/tables/bit_tables.hpp"
#include "search/random_scene.hpp"

namespace spectralpack::test {

/// One of them.
inline Form random_form(RandomStream& random, const Forms& forms) {
    const int axes = between(random, 1, forms.cubes ? 7 : 6);
    const bool run = axes == 1 || axes == 2 || axes == 4;
    return {axes, run ? between(random, 0, forms.run_levels) : between(random, Forms::kFirstPlate, forms.last_plate)};
}

template <class Visit>
void for_each_voxel_of(const Form& form, const VoxelIndex& corner, const Visit& visit) {
    for_each_voxel({form.size(0), form.size(1), form.size(2)}, [&](int x, int y, int z) {
        visit(corner + VoxelIndex{x, y, z});
    });
}

inline std::vector<Form> in_order(const Forms& forms) {
    std::vector<Form> all;
    forms.for_each([&](const Form& form) { all.push_back(form); });
    return all;
}

/// A bit of a row whose next word lies `next` words on.
inline bool bit_from(const std::uint64_t* word, std::ptrdiff_t next, int bit) {
    return word[bit / 64 * next] >> (bit % 64) & 1;
}

}  // namespace spectralpack::test
