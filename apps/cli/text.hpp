#pragma once
/// Numbers as people write and read them.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <spectralpack/spectralpack.hpp>

namespace spectralpack::cli {

/// "480x245x200" into a size in mm. Throws UsageError naming `option`.
Vec3 parse_size(const std::string& text, const char* option);

/// "mm", "inch" or "m" into mm. Throws UsageError naming --unit.
double parse_unit(const std::string& text);

/// "1600x1200" into the size of a picture. Throws UsageError naming --size.
void parse_picture_size(const std::string& text, RenderOptions& options);

/// Text from files as it can go to a terminal: control characters as '?'.
std::string printable(std::string text);

inline constexpr std::size_t kScreenWidth = 80;

/// "3 ring, 4 ring and 7 more", with the copies' numbers.
std::string copy_names(const Packing& packing, const TrayPacking& tray, const std::vector<int>& placements);

/// Columns that the text takes on a terminal: its characters.
std::size_t columns_of(std::string_view text);

/// In text to be wrapped, a space that stays in its line.
inline constexpr char kBond = '\x1f';

/// `text` in lines of at most `width` columns, broken at spaces; a longer word stands by itself.
std::string wrapped(const std::string& text, std::size_t width);

std::string duration_text(double seconds);   ///< "0.4 s", "12 s", "4 min 05 s", "2 h 07 min"
std::string bytes_text(std::int64_t bytes);  ///< "812 MB", "3.1 GB"
std::string percent_text(double share);      ///< "43.9 %"
/// "; 3 of them sideways through the walls", of a plan's steps; nothing for none.
std::string through_walls_text(std::size_t steps);
/// "; 80 copies that stood there before stay: they are not part of the order"; nothing for none.
std::string staying_text(std::size_t copies);
std::string length_text(double mm);  ///< at most three decimals, none that are zero
std::string gap_number(double mm);   ///< "2.0", "0.25": one decimal, more where it has more

}  // namespace spectralpack::cli
