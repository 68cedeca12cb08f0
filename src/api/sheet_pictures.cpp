#include "api/sheet_pictures.hpp"

#include <atomic>
#include <map>

#include "core/stopped.hpp"
#include "model/palette.hpp"
#include "render/marks.hpp"
#include "render/render.hpp"

namespace spectralpack {
namespace {

constexpr double kPixels = 7, kSmallPixels = 10;  // a millimetre of print: 178 and 254 dots an inch
constexpr double kHurried = 0.5;                  // of these where there is no time
constexpr int kSamples = 2;                       // per pixel and axis
constexpr double kHeroMargin = 0.07, kStageMargin = 0.02;

int pixels(double millimetres, double a_millimetre) {
    return std::max(1, static_cast<int>(std::lround(millimetres * a_millimetre)));
}

class PictureMaker {
  public:
    PictureMaker(const Scene& scene, const Workers& workers, const DrawingTime& time)
        : packing_(scene.packing),
          meshes_(scene.meshes),
          workers_(workers),
          drawing_(workers.stopping_with(time.over)),
          hurry_(time.hurry) {
        try {
            held_.add(meshes_, drawing_);
        } catch (const Stopped&) {  // as all that follows
        }
    }

    int left_out() const { return left_out_; }

    std::vector<std::vector<Box>> boxes() const {
        std::vector<std::vector<Box>> result;
        for (const TrayPacking& tray : packing_.trays) {
            std::vector<Box>& boxes = result.emplace_back(tray.placements.size());
            workers_.for_each(static_cast<std::int64_t>(boxes.size()), [&](std::int64_t i) {
                const Placement& placement = tray.placements[static_cast<std::size_t>(i)];
                const Mesh& mesh = *meshes_.at(static_cast<std::size_t>(placement.part));
                Box& box = boxes[static_cast<std::size_t>(i)];
                for (const Triangle& triangle : mesh.triangles) {
                    for (const std::uint32_t vertex : triangle) {
                        box.add(placement.transform * mesh.vertices[vertex]);
                    }
                }
            });
        }
        return result;
    }

    TrayPictures tray(int index, const TrayLayout& layout, const std::vector<Box>& boxes) {
        TrayPictures pictures;
        pictures.whole = in_time([&] { return whole(index, layout); });
        for (const Slab& slab : layout.slabs) {
            pictures.slabs.push_back(in_time([&] { return top_view(index, layout, slab, boxes); }));
        }
        for (const int step : layout.stages) {
            pictures.stages.push_back(in_time([&] { return stage(index, layout, step); }));
        }
        return pictures;
    }

    /// By part; empty where there is no mesh.
    std::vector<std::string> thumbs() {
        std::vector<std::string> result(packing_.parts.size());
        workers_.for_each(static_cast<std::int64_t>(result.size()), [&](std::int64_t i) {
            const auto part = static_cast<std::size_t>(i);
            if (part >= meshes_.size() || !meshes_[part]) return;
            result[part] = in_time([&] {
                const Stage stage = set_part_stage(meshes_[part], part_colour(static_cast<int>(i)),
                                                   pixels(kThumbWidth, finer() * kSmallPixels),
                                                   pixels(kThumbHeight, finer() * kSmallPixels));
                return encode_png(paint(stage, held_, kSamples, drawing_, hurry_).image);
            });
        });
        return result;
    }

  private:
    /// What `draw` makes; nothing, which is counted, where the time is over.
    template <class Draw>
    auto in_time(const Draw& draw) -> decltype(draw()) {
        try {
            drawing_.check();
            return draw();
        } catch (const Stopped&) {
            ++left_out_;
            return {};
        }
    }

    double finer() const { return hurry_.stopped() ? kHurried : 1; }
    void begin_picture() { pixels_ = finer() * kPixels; }

    /// The tray in print of this size, on white and to scale.
    View view(int tray, double width, double height) const {
        View view;
        view.lens = Lens::parallel;
        view.backdrop = Backdrop::white;
        view.options.tray = tray;
        view.options.azimuth = kHeroAzimuth;
        view.options.elevation = kHeroElevation;
        view.options.width = pixels(width, pixels_);
        view.options.height = pixels(height, pixels_);
        return view;
    }

    /// Keep-outs that are boxes get a mesh with their stage.
    Picture picture_of(const Stage& stage) {
        held_.add(stage.meshes, drawing_);
        return paint(stage, held_, kSamples, drawing_, hurry_);
    }

    SheetPicture sheet_picture(const Stage& stage, const Picture& picture, bool numbered) const {
        SheetPicture result;
        result.png = encode_png(picture.image);
        result.width = picture.image.width;
        result.height = picture.image.height;
        result.millimetre = pixels_;
        if (!numbered) return result;
        for (const NumberPlace& place :
             number_places(stage, picture, {kNumberSize * pixels_, kPaleNumberSize * pixels_})) {
            const StagedCopy& copy = stage.copies[static_cast<std::size_t>(place.copy)];
            result.numbers.push_back({copy.number, place.x, place.y, copy.look == Look::strong});
        }
        return result;
    }

    SheetPicture whole(int tray, const TrayLayout& layout) {
        begin_picture();
        View view = this->view(tray, kHeroWidth, layout.hero_height);
        view.margin = kHeroMargin;
        const Stage stage = set_stage(packing_, meshes_, view);
        SheetPicture result = sheet_picture(stage, picture_of(stage), true);
        const PictureMarks marks = marks_of(stage);
        result.bar = {marks.bar.x0, marks.bar.y0, marks.bar.x1, marks.bar.y1};
        if (marks.arrow.y1 < marks.arrow.y0)
            result.arrow = {marks.arrow.x0, marks.arrow.y0, marks.arrow.x1, marks.arrow.y1};
        for (const PictureText& text : marks.texts) {
            result.texts.push_back({text.x, text.y, text.text});
        }
        return result;
    }

    /// What lies in the slab and what reaches in, from above; front below.
    SheetPicture top_view(int tray, const TrayLayout& layout, const Slab& slab, const std::vector<Box>& boxes) {
        begin_picture();
        const Vec3& size = packing_.container.size;
        View view = this->view(tray, layout.map_width, layout.map_width * size.y / size.x);
        view.margin = 0;
        view.options.azimuth = 0;
        view.options.elevation = 90;
        view.outlines = false;
        view.slab = {slab.low, slab.high};
        for (const Box& box : boxes) {
            view.looks.push_back(box.max.z > slab.low && box.min.z < slab.high ? Look::pale : Look::gone);
        }
        for (const int placement : slab.placements) {
            view.looks[static_cast<std::size_t>(placement)] = Look::strong;
        }
        const Stage stage = set_stage(packing_, meshes_, view);
        return sheet_picture(stage, picture_of(stage), true);
    }

    SheetPicture stage(int tray, const TrayLayout& layout, int step) {
        begin_picture();
        View view = this->view(tray, kStageWidth, layout.stage_height);
        view.margin = kStageMargin;
        for (const bool left : left_after(packing_.trays[static_cast<std::size_t>(tray)], step)) {
            view.looks.push_back(left ? Look::strong : Look::gone);
        }
        const Stage stage = set_stage(packing_, meshes_, view);
        return sheet_picture(stage, picture_of(stage), false);
    }

    const Packing& packing_;
    const PartMeshes& meshes_;
    const Workers& workers_;
    Workers drawing_;
    const StopToken& hurry_;
    std::atomic<int> left_out_ = 0;
    double pixels_ = kPixels;  // a millimetre, of the picture being made
    RayMeshes held_;
};

}  // namespace

int add_pictures(const Scene& scene, ReportContents& contents, const Workers& workers, const DrawingTime& time) {
    PictureMaker maker(scene, workers, time);
    const std::vector<std::vector<Box>> boxes = maker.boxes();
    contents.layout = sheet_layout(scene.packing, boxes);
    for (std::size_t tray = 0; tray < scene.packing.trays.size(); ++tray) {
        contents.pictures.push_back(maker.tray(static_cast<int>(tray), contents.layout[tray], boxes[tray]));
    }
    contents.thumbs = maker.thumbs();
    return maker.left_out();
}

}  // namespace spectralpack
