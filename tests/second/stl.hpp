#pragma once
/// STL files for the second check, binary and text.

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

#include "triangles.hpp"

namespace second {

inline std::vector<std::array<Point, 3>> read_stl(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    if (!in.is_open()) throw std::runtime_error(path + " cannot be read");
    std::vector<std::array<Point, 3>> corners;
    std::uint32_t count = 0;
    if (bytes.size() >= 84) std::memcpy(&count, bytes.data() + 80, 4);
    if (bytes.size() >= 84 && bytes.size() == 84 + std::size_t{50} * count) {
        for (std::uint32_t i = 0; i < count; ++i) {
            float numbers[9];
            std::memcpy(numbers, bytes.data() + 84 + std::size_t{50} * i + 12, sizeof numbers);
            corners.push_back({Point(numbers[0], numbers[1], numbers[2]), Point(numbers[3], numbers[4], numbers[5]),
                               Point(numbers[6], numbers[7], numbers[8])});
        }
        return corners;
    }
    std::istringstream words(bytes);
    std::vector<Point> points;
    for (std::string word; words >> word;) {
        double x, y, z;
        if (word == "vertex" && words >> x >> y >> z) points.emplace_back(x, y, z);
    }
    if (points.empty() || points.size() % 3 != 0) throw std::runtime_error(path + " is no STL file");
    for (std::size_t i = 0; i < points.size(); i += 3) {
        corners.push_back({points[i], points[i + 1], points[i + 2]});
    }
    return corners;
}

}  // namespace second
