#include "formats/report/html.hpp"

#include <cstdio>

#include "formats/xml_text.hpp"

namespace spectralpack {

std::string escaped(const std::string& text) { return xml_attribute(text); }

std::string base64(const std::string& bytes) {
    static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        }
        for (int shift = 18; shift >= 0; shift -= 6) {
            text += kDigits[group >> shift & 63];
        }
    }
    for (std::size_t pad = (3 - bytes.size() % 3) % 3; pad > 0; --pad) {
        text[text.size() - pad] = '=';
    }
    return text;
}

std::string picture_link(const std::string& png) { return "data:image/png;base64," + base64(png); }

std::string with_unit(double value, int decimals, const char* unit) {
    return fmt::format("{:.{}f}\u202f{}", value, decimals, unit);
}

std::string day_of(const std::string& date) {
    static constexpr const char* kMonths[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                              "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
    int year = 0, month = 0, day = 0;
    const bool is_date = date.size() == 10 && std::sscanf(date.c_str(), "%4d-%2d-%2d", &year, &month, &day) == 3;
    if (!is_date || month < 1 || month > 12) return date;
    return fmt::format("{}\u00a0{}", day, kMonths[month - 1]);
}

std::string counted(std::size_t count, const char* one) {
    return fmt::format("{}\u00a0{}{}", count, one, count == 1 ? "" : "s");
}

}  // namespace spectralpack
