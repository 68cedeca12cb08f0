#include "render/marks.hpp"

#include <algorithm>
#include <cmath>

#include "model/slabs.hpp"
#include "render/text.hpp"

namespace spectralpack {
namespace {

constexpr double kTextSize = 24;       // pixels, in a picture of 1200
constexpr double kMarksAside = 0.035;  // of the tray's diagonal, from its edges to bar and arrow
constexpr double kLeastFacing = 0.05;

double scale_of(int width, int height) { return std::min(width, height) / 1200.0; }

/// The bar's length: as much of 50 mm as is no longer than the tray's edge.
double bar_length(double edge) {
    for (const double length : {50.0, 20.0, 10.0, 5.0, 2.0, 1.0}) {
        if (length <= edge) return length;
    }
    return edge;
}

std::string millimetres(double length) {
    std::string text = std::to_string(length);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text + " mm";
}

class MarkPlacer {
  public:
    explicit MarkPlacer(const Stage& stage)

        : stage_(stage),
          camera_(stage.camera),
          mm_(stage.millimetre),
          box_(stage.containers.front()),
          aside_(kMarksAside * length(box_.size())) {}

    PictureMarks place() {
        const bool front = camera_.forward.y >= 0, right = camera_.forward.x <= 0;
        side_y_ = front ? box_.min.y : box_.max.y;
        side_x_ = right ? box_.max.x : box_.min.x;
        out_y_ = front ? -aside_ : aside_;
        out_x_ = right ? aside_ : -aside_;
        if (std::abs(camera_.forward.y) > kLeastFacing) {
            name({middle(0), side_y_ + 2.2 * out_y_, box_.min.z}, front ? "front" : "back");
        }
        if (std::abs(camera_.forward.x) > kLeastFacing) {
            name({side_x_ + 2.2 * out_x_, middle(1), box_.min.z}, right ? "right" : "left");
        }
        bar();
        arrow();
        layers();
        return std::move(marks_);
    }

  private:
    double middle(int axis) const { return (box_.min[axis] + box_.max[axis]) / 2; }

    void name(const Vec3& at, std::string text) {
        const PicturePoint seen = camera_.project(at);
        marks_.texts.push_back({seen.x, seen.y, std::move(text)});
    }

    /// Along the side that the camera looks at more, from its left end in the picture.
    void bar() {
        const int axis = std::abs(camera_.forward.y) >= std::abs(camera_.forward.x) ? 0 : 1;
        Vec3 from{box_.min.x, side_y_ + out_y_, box_.min.z};
        if (axis == 1) from = {side_x_ + out_x_, box_.min.y, box_.min.z};
        const double mm = bar_length(box_.size()[axis] / mm_);
        Vec3 to = from;
        to[axis] += mm * mm_;
        if (camera_.right[axis] < 0) {  // the axis runs to the left
            from[axis] = box_.max[axis];
            to[axis] = box_.max[axis] - mm * mm_;
        }
        const PicturePoint a = camera_.project(from), b = camera_.project(to);
        marks_.bar = {a.x, a.y, b.x, b.y};
        std::string text = millimetres(mm);
        const double half_text = 0.33 * text_size() * static_cast<double>(text.size());
        marks_.texts.push_back({a.x + half_text, std::max(a.y, b.y) + 0.9 * text_size(), std::move(text)});
    }

    /// A letter beside each layer that is drawn apart, left of the corner that is leftmost in the picture.
    void layers() {
        for (std::size_t i = 0; i < stage_.layers.size(); ++i) {
            const Vec3 corner = leftmost_corner(stage_.layers[i]);
            const PicturePoint seen = camera_.project(corner - 1.5 * aside_ * camera_.right);
            marks_.texts.push_back({seen.x, seen.y, slab_name(stage_.layers.size() - 1 - i)});
        }
    }

    double text_size() const { return kTextSize * scale_of(camera_.width, camera_.height); }

    Vec3 leftmost_corner(double z) const {
        Vec3 leftmost{box_.min.x, box_.min.y, z};
        for (int i = 0; i < 4; ++i) {
            const Vec3 corner{i & 1 ? box_.max.x : box_.min.x, i & 2 ? box_.max.y : box_.min.y, z};
            if (camera_.project(corner).x < camera_.project(leftmost).x) leftmost = corner;
        }
        return leftmost;
    }

    /// Beside the lower corner that is leftmost in the picture.
    void arrow() {
        const Vec3 from = leftmost_corner(box_.min.z) - aside_ * camera_.right + Vec3{0, 0, 0.5 * aside_};
        const double up = std::min(0.4 * box_.size().z, 0.25 * length(box_.size()));
        const PicturePoint a = camera_.project(from), b = camera_.project(from + Vec3{0, 0, up});
        marks_.arrow = {a.x, a.y, b.x, b.y};
        if (b.y > a.y - 12 * scale_of(camera_.width, camera_.height)) {
            marks_.arrow = {};  // seen from above: it would be a point
            return;
        }
        marks_.texts.push_back({b.x, b.y - 0.8 * text_size(), "Z"});
    }

    const Stage& stage_;
    const Camera& camera_;
    double mm_;
    Box box_;
    double aside_;
    double side_x_ = 0, side_y_ = 0, out_x_ = 0, out_y_ = 0;
    PictureMarks marks_;
};

}  // namespace

PictureMarks marks_of(const Stage& stage) { return MarkPlacer(stage).place(); }

void draw_marks(const PictureMarks& marks, Image& image) {
    const double scale = scale_of(image.width, image.height);
    draw_line(image, marks.bar, 5 * scale);
    const PictureLine& arrow = marks.arrow;
    if (arrow.y1 < arrow.y0) {
        const double head = 13 * scale;
        draw_line(image, arrow, 3 * scale);
        draw_line(image, {arrow.x1 - 0.6 * head, arrow.y1 + head, arrow.x1, arrow.y1}, 3 * scale);
        draw_line(image, {arrow.x1 + 0.6 * head, arrow.y1 + head, arrow.x1, arrow.y1}, 3 * scale);
    }
    for (const PictureText& text : marks.texts) {
        draw_text(image, text, {kTextSize * scale, 0.12});
    }
}

void draw_numbers(const Stage& stage, Picture& picture) {
    constexpr double kLeast = 13;  // pixels: smaller ones cannot be read
    const double size = std::max(kLeast, 22 * scale_of(picture.image.width, picture.image.height));
    for (const NumberPlace& place : number_places(stage, picture, {size, size})) {
        const int number = stage.copies[static_cast<std::size_t>(place.copy)].number;
        draw_text(picture.image, {place.x, place.y, std::to_string(number)}, {size, 0.2});
    }
}

}  // namespace spectralpack
