#include "jobs/names.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>

namespace spectralpack::server {
namespace {

constexpr std::size_t kIdLength = 12, kMostNameBytes = 200;
constexpr std::string_view kIdLetters = "abcdefghijklmnopqrstuvwxyz0123456789";

/// The number of bytes of the character that `text` begins with; 0 where it is no UTF-8.
std::size_t character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const unsigned first = byte(0);
    const std::size_t length = first < 0x80                    ? 1
                               : first >= 0xC2 && first < 0xE0 ? 2
                               : first >= 0xE0 && first < 0xF0 ? 3
                               : first >= 0xF0 && first < 0xF5 ? 4
                                                               : 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) return 0;
    }
    const bool overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
    const bool beyond = (first == 0xED && byte(1) >= 0xA0) || (first == 0xF4 && byte(1) >= 0x90);
    return overlong || beyond ? 0 : length;
}

int digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

}  // namespace

bool is_job_id(std::string_view text) {
    return text.size() == kIdLength && text.find_first_not_of(kIdLetters) == std::string_view::npos;
}

std::string new_job_id() {
    std::random_device random;
    std::uniform_int_distribution<std::size_t> letter(0, kIdLetters.size() - 1);
    std::string id;
    while (id.size() < kIdLength) {
        id += kIdLetters[letter(random)];
    }
    return id;
}

std::string problem_of_name(std::string_view name) {
    if (name.empty()) return "a file needs a name";
    if (name.size() > kMostNameBytes) return "the file's name is longer than 200 bytes";
    if (name.front() == '.') return "a file's name may not begin with a dot";
    for (std::size_t i = 0; i < name.size();) {
        const std::size_t bytes = character(name.substr(i));
        if (bytes == 0) return "the file's name is not UTF-8";
        const auto first = static_cast<unsigned char>(name[i]);
        if (first == '/' || first == '\\') return "a file's name has no folders in it";
        if (first < 0x20 || first == 0x7F) return "the file's name holds a control character";
        i += bytes;
    }
    return "";
}

FileKind kind_of(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos) return FileKind::other;
    std::string ending(name.substr(dot));
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    constexpr std::array<std::string_view, 6> kMeshes{".stl", ".3mf", ".obj", ".ply", ".off", ".binvox"};
    if (std::find(kMeshes.begin(), kMeshes.end(), ending) != kMeshes.end()) return FileKind::mesh;
    return ending == ".csv" ? FileKind::set : ending == ".json" ? FileKind::job : FileKind::other;
}

bool percent_decoded(std::string_view text, std::string& decoded) {
    decoded.clear();
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            decoded += text[i];
            continue;
        }
        const int high = i + 1 < text.size() ? digit(text[i + 1]) : -1;
        const int low = i + 2 < text.size() ? digit(text[i + 2]) : -1;
        if (high < 0 || low < 0) return false;
        decoded += static_cast<char>(16 * high + low);
        i += 2;
    }
    return true;
}

}  // namespace spectralpack::server
