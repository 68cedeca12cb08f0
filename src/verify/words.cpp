#include "verify/words.hpp"

#include <charconv>

namespace spectralpack {

std::string short_number(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6);
    return {text, end.ptr};
}

std::string copy_name(const Packing& packing, const Placement& placement) {
    const auto i = static_cast<std::size_t>(placement.part);
    const std::string copy = "copy " + std::to_string(placement.copy) + " of ";
    if (placement.part < 0 || i >= packing.parts.size()) return copy + "part " + std::to_string(placement.part);
    const PackedPart& part = packing.parts[i];
    if (placement.copy < 0 || placement.copy >= part.count) return copy + part.name;
    return std::to_string(CopyNumbers(packing.parts).of(placement)) + " " + part.name;
}

std::string tray_name(int tray) { return "tray " + std::to_string(tray + 1); }

std::string tray_prefix(const Packing& packing, int tray) {
    return packing.trays.size() > 1 ? tray_name(tray) + ": " : "";
}

}  // namespace spectralpack
