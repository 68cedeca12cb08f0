#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "formats/csv.hpp"
#include "formats/packing_file.hpp"

namespace spectralpack {

void write_transforms_csv(const Packing& packing, const std::filesystem::path& path, std::size_t first) {
    std::string text = "tray,part,name,copy,orientation,m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23,number\r\n";
    const CopyNumbers numbers(packing.parts);
    for (std::size_t tray = 0; tray < packing.trays.size(); ++tray) {
        for (const Placement& placement : packing.trays[tray].placements) {
            const PackedPart& part = packing.parts.at(static_cast<std::size_t>(placement.part));
            fmt::format_to(std::back_inserter(text), "{},{},{},{},{}", first + tray, placement.part,
                           csv_field(part.name), placement.copy, placement.orientation);
            for (int row = 0; row < 3; ++row) {
                const Vec3& r = placement.transform.linear.rows[row];
                fmt::format_to(std::back_inserter(text), ",{},{},{},{}", r.x, r.y, r.z,
                               placement.transform.translation[row]);
            }
            fmt::format_to(std::back_inserter(text), ",{}\r\n", numbers.of(placement));
        }
    }
    replace_file(path, text);
}

}  // namespace spectralpack
