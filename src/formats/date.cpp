#include "formats/date.hpp"

#include <charconv>
#include <chrono>

namespace spectralpack {

bool is_date(std::string_view text) {
    bool digits = text.size() == 10;
    for (std::size_t i = 0; i < text.size() && digits; ++i) {
        digits = i == 4 || i == 7 ? text[i] == '-' : text[i] >= '0' && text[i] <= '9';
    }
    if (!digits) return false;
    const auto number = [&](std::size_t at, std::size_t size) {
        unsigned value = 0;
        std::from_chars(text.data() + at, text.data() + at + size, value);
        return value;
    };
    return std::chrono::year_month_day(std::chrono::year(static_cast<int>(number(0, 4))),
                                       std::chrono::month(number(5, 2)), std::chrono::day(number(8, 2)))
        .ok();
}

}  // namespace spectralpack
