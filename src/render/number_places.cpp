#include <algorithm>
#include <cmath>

#include "render/marks.hpp"

namespace spectralpack {
namespace {

constexpr double kDigitWidth = 0.66, kDigitHeight = 0.74;  // of the text's height: DejaVu Sans Bold
constexpr double kLeastRoom = 0.42;  // of half the number's height, from its middle to the copy's edge in sight
constexpr double kNumberRim = 0.12;  // of the text's height, between two numbers
constexpr std::size_t kMostTries = 400;

struct Pixel {
    float room = 0;  ///< to the nearest pixel that shows something else
    int at = 0;
};

/// For each pixel the distance to the nearest one that shows something else, in steps of 1 and 1.4 (Borgefors,
/// "Distance transformations in digital images", 1986).
std::vector<float> rooms(const std::vector<int>& seen, int width, int height) {
    std::vector<float> room(seen.size());
    const auto sweep = [&](int from, int to, int step) {
        for (int y = from; y != to; y += step) {
            for (int i = 0; i < width; ++i) {
                const int x = step > 0 ? i : width - 1 - i;
                const auto at =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
                float least = step > 0 ? 1e9f : room[at];
                for (const auto& [dx, dy, far] :
                     {std::tuple{-1, 0, 1.0f}, {-1, -1, 1.4f}, {0, -1, 1.0f}, {1, -1, 1.4f}}) {
                    const int nx = x + step * dx, ny = y + step * dy;
                    if (nx < 0 || ny < 0 || nx >= width || ny >= height) {
                        least = std::min(least, 1.0f);
                        continue;
                    }
                    const auto next =
                        static_cast<std::size_t>(ny) * static_cast<std::size_t>(width) + static_cast<std::size_t>(nx);
                    least = std::min(least, seen[next] == seen[at] ? room[next] + far : 1.0f);
                }
                room[at] = least;
            }
        }
    };
    sweep(0, height, 1);
    sweep(height - 1, -1, -1);
    return room;
}

struct Rectangle {
    double x0, y0, x1, y1;
    bool meets(const Rectangle& o) const { return x0 < o.x1 && o.x0 < x1 && y0 < o.y1 && o.y0 < y1; }
};

}  // namespace

std::vector<NumberPlace> number_places(const Stage& stage, const Picture& picture, const NumberSizes& sizes) {
    const int width = picture.image.width, height = picture.image.height;
    const std::vector<float> room = rooms(picture.seen, width, height);
    std::vector<std::vector<Pixel>> pixels(stage.copies.size());
    for (std::size_t i = 0; i < picture.seen.size(); ++i) {
        if (picture.seen[i] >= 0)
            pixels[static_cast<std::size_t>(picture.seen[i])].push_back({room[i], static_cast<int>(i)});
    }
    std::vector<int> order(stage.copies.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = static_cast<int>(i);
    }
    const auto size_of = [&](int copy) { return pixels[static_cast<std::size_t>(copy)].size(); };
    const auto is_pale = [&](int copy) { return stage.copies[static_cast<std::size_t>(copy)].look == Look::pale; };
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        if (is_pale(a) != is_pale(b)) return is_pale(b);
        return size_of(a) != size_of(b) ? size_of(a) > size_of(b) : a < b;
    });

    std::vector<NumberPlace> places;
    std::vector<Rectangle> taken;
    for (const int copy : order) {
        const double size = is_pale(copy) ? sizes.pale : sizes.strong;
        const auto digits =
            static_cast<double>(std::to_string(stage.copies[static_cast<std::size_t>(copy)].number).size());
        const double half_width = size * (digits * kDigitWidth / 2 + kNumberRim),
                     half_height = size * (kDigitHeight / 2 + kNumberRim);
        std::vector<Pixel>& own = pixels[static_cast<std::size_t>(copy)];
        std::erase_if(own, [&](const Pixel& p) { return p.room < kLeastRoom * half_height; });
        std::sort(own.begin(), own.end(),
                  [](const Pixel& a, const Pixel& b) { return a.room != b.room ? a.room > b.room : a.at < b.at; });
        const std::size_t step = std::max<std::size_t>(1, own.size() / kMostTries);
        for (std::size_t i = 0; i < own.size(); i += step) {
            const double x = own[i].at % width + 0.5, y = own[i].at / width + 0.5;
            const Rectangle box{x - half_width, y - half_height, x + half_width, y + half_height};
            if (box.x0 < 0 || box.y0 < 0 || box.x1 > width || box.y1 > height) continue;
            if (std::any_of(taken.begin(), taken.end(), [&](const Rectangle& other) { return box.meets(other); }))
                continue;
            taken.push_back(box);
            places.push_back({copy, x, y});
            break;
        }
    }
    return places;
}

}  // namespace spectralpack
