#pragma once
/// Pictures of packings: ray-traced on the CPU, the same bytes for any number of threads.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "spectralpack/packing.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  ///< row by row from the top, 3 bytes a pixel
};

/// A look inside: what lies between the camera and this plane is cut away.
struct Section {
    int axis = 2;   ///< 0 to 2: the plane stands across x, y or z
    double at = 0;  ///< mm from the container's lower corner
};

/// How long pictures may take that belong to a run's files.
struct DrawingTime {
    StopToken hurry = {};  ///< once requested, they are drawn plainly, without shadows
    StopToken over = {};   ///< once requested, what is not drawn is left out
};

struct RenderOptions {
    int width = 1600, height = 1200;
    double azimuth = 35;    ///< degrees: where the camera stands round the container; 0 looks along
                            ///< +y, 90 along -x
    double elevation = 28;  ///< degrees above it, in [-90, 90]; from below there is no floor
    int tray = -1;          ///< which tray; -1: all, side by side
    int samples = 3;        ///< per pixel and axis, against jagged edges
    /// The tray in layers of about 50 mm, one above the other (>= 0): at 1 so far apart that none hides the next.
    std::optional<double> explode = {};
    /// The disassembly plan's step from 1 on: its copies highlighted half way, with what is left of
    /// those they stood together with. 0: the whole tray. Needs one tray to be chosen.
    std::optional<int> step = {};
    std::optional<Section> section = {};  ///< needs one tray to be chosen
    bool marks = true;                    ///< a scale bar of 50 mm, the z arrow, "front" and "right"
    bool numbers = true;                  ///< the copies' numbers, where there is room
};

/// A shaded picture: each copy in its own colour (copies of one part in neighbouring shades), the container outlined,
/// ambient occlusion and a soft shadow on the floor. `threads` <= 0: all the machine has. Throws UsageError for options
/// out of range, and where a disassembly plan is to be drawn and a tray has none.
Image render(const Scene& scene, const RenderOptions& options, int threads);

/// The bytes of a PNG file.
std::string encode_png(const Image& image);

/// Throws ResourceError when the file cannot be written.
void write_png(const Image& image, const std::filesystem::path& path);

/// render() into a PNG file.
void write_picture(const Scene& scene, const std::filesystem::path& path, const RenderOptions& options, int threads);

}  // namespace spectralpack
