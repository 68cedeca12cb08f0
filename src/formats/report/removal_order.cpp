#include <algorithm>
#include <array>
#include <cmath>

#include "formats/report/pages.hpp"
#include "formats/report/picture_svg.hpp"
#include "model/palette.hpp"

namespace spectralpack {
namespace {

constexpr double kKey = 10, kTableHead = 5.8, kStepRow = 6.3, kSecondLine = 4.6, kUnderStage = 9, kTitle = 10;
constexpr double kLine = 50;                            // mm: moves in one line
constexpr std::size_t kShortName = 12, kLongName = 32;  // characters that fit, in three columns and in two
constexpr double kLeastMove = 0.5;                      // mm: nobody sees less
constexpr std::size_t kMostMoves = 6;
constexpr const char* kThroughWalls = "‖";         // behind the number of such a step
constexpr double kStraight = 0.98, kPartOf = 0.1;  // of a move's length: along one axis alone; a share worth saying

struct Direction {
    int axis;
    bool up;
    const char *id, *words, *path;
};
// As seen from the front.
constexpr std::array<Direction, 6> kDirections{{
    {2, true, "au", "up", "M8 13.5V4M4.2 7.4L8 3.4l3.8 4M3 15h10"},
    {2, false, "ad", "down", "M8 2.5V12M4.2 8.6L8 12.6l3.8-4M3 1h10"},
    {0, false, "al", "left", "M13.5 8H3M6.6 4.2L2.6 8l4 3.8"},
    {0, true, "ar", "right", "M2.5 8H13M9.4 4.2L13.4 8l-4 3.8"},
    {1, true, "ab", "to the back", "M8 13.5V4M4.2 7.4L8 3.4l3.8 4"},
    {1, false, "af", "to the front", "M8 2.5V12M4.2 8.6L8 12.6l3.8-4"},
}};

std::string arrow(const Direction& direction) {
    return fmt::format("<svg viewBox=\"0 0 16 16\" class=\"arrow\"><use href=\"#{}\"/></svg>", direction.id);
}

const Direction& direction_of(int axis, bool up) {
    return *std::find_if(kDirections.begin(), kDirections.end(),
                         [&](const Direction& d) { return d.axis == axis && d.up == up; });
}

/// A move as arrows: one, or those that are made at once.
std::string move_text(const Vec3& move) {
    const double size = length(move);
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(move[axis]) >= kStraight * size) {
            return fmt::format("<span>{}<b>{:.0f}</b></span>", arrow(direction_of(axis, move[axis] > 0)), size);
        }
    }
    std::string text;
    for (const int axis : {2, 0, 1}) {
        if (std::abs(move[axis]) < kPartOf * size) continue;
        text += fmt::format("{}{}<b>{:.0f}</b>", text.empty() ? "" : "+", arrow(direction_of(axis, move[axis] > 0)),
                            std::abs(move[axis]));
    }
    return "<span>" + text + "</span>";
}

/// How long that text is in print, mm.
double text_length(const Vec3& move) {
    const double size = length(move);
    double sum = 1.6;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(move[axis]) < kPartOf * size) continue;
        sum += 4.2 + 1.75 * static_cast<double>(fmt::format("{:.0f}", std::abs(move[axis])).size());
    }
    return sum;
}

/// A name that is too long loses its middle: parts of a job often begin alike.
std::string shortened(const std::string& name, std::size_t most) {
    std::vector<std::size_t> begins;  // of characters, which may be several bytes
    for (std::size_t i = 0; i < name.size(); ++i) {
        if ((static_cast<unsigned char>(name[i]) & 0xc0) != 0x80) begins.push_back(i);
    }
    if (begins.size() <= most) return name;
    const std::size_t head = most / 3, tail = most - head - 1;
    return name.substr(0, begins[head]) + "…" + name.substr(begins[begins.size() - tail]);
}

/// Those that are worth saying; runs in one direction are one.
std::vector<Vec3> moves_of(const std::vector<Vec3>& path) {
    std::vector<Vec3> moves;
    for (const Vec3& move : path) {
        const double size = length(move);
        if (!(size >= kLeastMove)) continue;
        if (!moves.empty() && dot(moves.back(), move) > 0.999 * length(moves.back()) * size) {
            moves.back() = moves.back() + move;
        } else {
            moves.push_back(move);
        }
    }
    return moves;
}

struct Row {
    std::string html;
    double height = kStepRow;
};

class RemovalOrder {
  public:
    RemovalOrder(const SheetInput& sheet, std::size_t tray, int columns)
        : sheet_(sheet),
          index_(tray),
          tray_(sheet.packing.trays[tray]),
          layout_(sheet.contents.layout[tray]),
          columns_(columns),
          name_length_(columns == 2 ? kLongName : kShortName) {
        slab_of_.resize(tray_.placements.size());
        for (std::size_t slab = 0; slab < layout_.slabs.size(); ++slab) {
            for (const int placement : layout_.slabs[slab].placements) {
                slab_of_[static_cast<std::size_t>(placement)] = slab_name(slab);
            }
        }
        int most = 0;
        for (const Placement& placement : tray_.placements) {
            most = std::max(most, sheet_.numbers.of(placement));
        }
        number_width_ = 6.8 + 1.9 * static_cast<double>(std::to_string(most).size());
        add_rows();
    }

    /// `first`: what is free on the first page; 0: it is a page of its own.
    std::vector<std::string> pages(double first) const {
        std::vector<std::string> pages;
        const bool shared = first > 0;
        std::size_t next = 0;
        while (pages.empty() || next < rows_.size()) {
            const double room = (pages.empty() && shared ? first - kTitle : kBody) - kKey - kTableHead;
            const double with_stages = room - (layout_.stages.empty() ? 0 : layout_.stage_height + kUnderStage);
            std::size_t end = fill(next, with_stages);
            const bool last = end == rows_.size();
            if (!last) end = fill(next, room);
            Html html;
            if (pages.empty() && shared) html.add("<h2 class=\"sec\">Removal order</h2>");
            html.add("{}{}", key(), tables(next, end, last ? with_stages : room));
            if (last) html.add("{}", stages());
            pages.push_back(html.take());
            next = end;
            if (!last && next == rows_.size()) {
                pages.push_back(stages());  // they found no room below the list
            }
        }
        return pages;
    }

  private:
    void add_rows() {
        const std::vector<RemovalStep>& steps = tray_.disassembly->steps;
        // Who stands with whom: 0 in the tray, else the step that one left in, from 1 on.
        std::vector<std::size_t> with(tray_.placements.size(), 0);
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const auto stands_with = with[static_cast<std::size_t>(steps[i].placements.front())];
            const bool group = steps[i].placements.size() > 1;
            for (const int placement : steps[i].placements) {
                with[static_cast<std::size_t>(placement)] = i + 1;
            }
            const bool parting = stands_with > 0;
            bool ends = parting;  // nobody of the group is left after this step
            for (std::size_t k = i + 1; ends && k < steps.size(); ++k) {
                ends = with[static_cast<std::size_t>(steps[k].placements.front())] == 0;
            }
            add_step(i, parting || group, group, ends);
        }
    }

    void add_step(std::size_t index, bool framed, bool group, bool ends) {
        const RemovalStep& step = tray_.disassembly->steps[index];
        const std::vector<Vec3> moves = moves_of(step.path);
        const char* frame = framed ? "g" : "";
        const char* top = group ? " g1" : "";
        const char* bottom = ends && !group ? " g9" : "";
        std::string way = "<span class=\"fr\">free</span>";
        std::vector<std::string> more;  // lines below
        if (moves.size() == 1) {
            way = move_text(moves.front());
        } else if (moves.size() > kMostMoves) {
            way = fmt::format("<span class=\"fr\">by hand</span>");
        } else if (!moves.empty()) {
            way = fmt::format("<span class=\"fr\">{} moves</span>", moves.size());
            double used = kLine;
            for (const Vec3& move : moves) {
                used += text_length(move);
                if (used > kLine) {
                    more.emplace_back();
                    used = text_length(move);
                }
                more.back() += move_text(move);
            }
        }
        Row row;
        const bool through_walls =
            std::ranges::binary_search(tray_.disassembly->through_walls, static_cast<int>(index));
        const std::string number = fmt::format("{}{}", index + 1, through_walls ? kThroughWalls : "");
        if (group) {
            row.html = fmt::format(
                "<tr class=\"{}{}{}\"><td class=\"st\">{}</td><td colspan=\"3\" class=\"nm\"><b>{} copies as one "
                "group</b></td><td class=\"mv\">{}</td></tr>",
                frame, top, more.empty() ? "" : " many", number, step.placements.size(), way);
        } else {
            const Placement& placement = tray_.placements[static_cast<std::size_t>(step.placements.front())];
            row.html = fmt::format(
                "<tr class=\"{}{}{}\"><td class=\"st\">{}</td><td class=\"nu\"><i style=\"background:{}\"></i>{}</td><td "
                "class=\"nm\">{}</td><td class=\"sl\">{}</td><td class=\"mv\">{}</td></tr>",
                frame, more.empty() ? bottom : "", more.empty() ? "" : " many", number,
                part_colour_text(placement.part), sheet_.numbers.of(placement),
                escaped(shortened(sheet_.packing.parts[static_cast<std::size_t>(placement.part)].name, name_length_)),
                slab_of_[static_cast<std::size_t>(step.placements.front())], way);
        }
        for (std::size_t i = 0; i < more.size(); ++i) {
            const bool last = i + 1 == more.size();
            row.html += fmt::format("<tr class=\"nb{} {}{}\"><td></td><td colspan=\"4\" class=\"mm\">{}</td></tr>",
                                    last ? "" : " many", frame, last ? bottom : "", more[i]);
            row.height += kSecondLine;
        }
        if (group) {
            row.html += fmt::format(
                "<tr class=\"nb {}\"><td></td><td colspan=\"4\" class=\"mm\">then parted outside, steps {} to "
                "{}:</td></tr>",
                frame, index + 2, parted_by(index) + 1);
            row.height += kSecondLine;
        }
        rows_.push_back(std::move(row));
    }

    /// The last step that takes a copy out of the group that leaves in this one.
    std::size_t parted_by(std::size_t group) const {
        const std::vector<RemovalStep>& steps = tray_.disassembly->steps;
        const std::vector<int>& members = steps[group].placements;
        std::size_t last = group;
        for (std::size_t i = group + 1; i < steps.size(); ++i) {
            if (std::binary_search(members.begin(), members.end(), steps[i].placements.front())) last = i;
        }
        return last;
    }

    /// The rows that fit so many columns of this height, from `begin` on: the end of those.
    std::size_t fill(std::size_t begin, double height) const {
        for (int column = 0; column < columns_; ++column) {
            begin = column_end(begin, height);
        }
        return begin;
    }

    std::size_t column_end(std::size_t begin, double height) const {
        double used = 0;
        while (begin < rows_.size() && used + rows_[begin].height <= height) {
            used += rows_[begin++].height;
        }
        return begin;
    }

    /// Columns as even as rows allow, none higher than `height`.
    std::string tables(std::size_t begin, std::size_t end, double height) const {
        double least = 0, sum = 0;
        for (std::size_t i = begin; i < end; ++i) {
            sum += rows_[i].height;
        }
        for (least = sum / columns_; least < height && fill(begin, least) < end;) {
            least += 1;
        }
        Html html;
        html.add("<div class=\"cols c{}\">", columns_);
        for (int column = 0; column < columns_ && begin < end; ++column) {
            const std::size_t stop = std::min(end, column_end(begin, std::min(least, height)));
            html.add(
                "<table class=\"rem\" style=\"--nu:{:.1f}mm\"><thead><tr><th class=\"st\">Step</th><th class=\"nu\">No.</th><th class=\"nm\">Part</th>"
                "<th class=\"sl\">Slab</th><th class=\"mv\">Way, mm</th></tr></thead><tbody>\n",
                number_width_);
            for (; begin < stop; ++begin) {
                html.add("{}\n", rows_[begin].html);
            }
            html.add("</tbody></table>");
        }
        html.add("</div>\n");
        return html.take();
    }

    std::string key() const {
        Html html;
        html.add("<p class=\"key\">");
        for (const Direction& direction : kDirections) {
            html.add("<span>{}{}</span>", arrow(direction), direction.words);
        }
        html.add("<span class=\"x\">Seen from the front of the printer.{}</span></p>\n", about_walls());
        return html.take();
    }

    std::string about_walls() const {
        if (sheet_.packing.container.physical) return " The walls stay; all leaves over the top.";
        std::string text;
        if (!tray_.disassembly->through_walls.empty()) {
            text = fmt::format(" {} : sideways through the walls.", kThroughWalls);
        }
        const std::size_t stay = staying(tray_).size();
        if (stay > 0) text += fmt::format(" {} from before {}.", stay, stay == 1 ? "stays" : "stay");
        return text;
    }

    std::string stages() const {
        if (layout_.stages.empty()) return "";
        Html html;
        html.add("<div class=\"stages\">");
        for (std::size_t i = 0; i < layout_.stages.size(); ++i) {
            const int step = layout_.stages[i];
            const std::vector<bool> left = left_after(tray_, step);
            html.add("<figure style=\"--h:{:.1f}mm\">{}<figcaption>after step {}: <b>{}</b> left</figcaption></figure>",
                     layout_.stage_height,
                     picture_svg(sheet_.contents.pictures[index_].stages[i], "stage",
                                 fmt::format("What is left after step {}", step)),
                     step, std::count(left.begin(), left.end(), true));
        }
        html.add("</div>\n");
        return html.take();
    }

    const SheetInput& sheet_;
    std::size_t index_;
    const TrayPacking& tray_;
    const TrayLayout& layout_;
    int columns_;
    std::size_t name_length_;
    double number_width_ = 0;           ///< of the column of numbers, mm
    std::vector<std::string> slab_of_;  ///< by placement
    std::vector<Row> rows_;
};

}  // namespace

std::vector<std::string> removal_pages(const SheetInput& sheet, std::size_t tray, double first, int columns) {
    if (!sheet.packing.trays[tray].disassembly || sheet.packing.trays[tray].disassembly->steps.empty()) return {};
    return RemovalOrder(sheet, tray, columns).pages(first);
}

std::string arrow_symbols() {
    Html html;
    html.add("<svg width=\"0\" height=\"0\" style=\"position:absolute\">");
    for (const Direction& direction : kDirections) {
        html.add("<symbol id=\"{}\" viewBox=\"0 0 16 16\"><path d=\"{}\"/></symbol>", direction.id, direction.path);
    }
    html.add("</svg>\n");
    return html.take();
}

}  // namespace spectralpack
