#include "formats/set_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/atomic_file.hpp"
#include "formats/csv.hpp"
#include "formats/date.hpp"
#include "formats/file_bytes.hpp"
#include "formats/number_text.hpp"
#include "formats/part_orientations.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/names.hpp"
#include "spectralpack/typed_text.hpp"

namespace spectralpack {
namespace {

std::string trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

enum Column : std::size_t { kMesh, kName, kCount, kScale, kUnit, kGap, kPriority, kDue, kValue, kOrientations };

struct ColumnName {
    Column column;
    const char* name;
    const char* also = "";
};

constexpr std::array<ColumnName, 10> kColumns{{{kMesh, "mesh", "file"},
                                               {kName, "name"},
                                               {kCount, "count", "quantity"},
                                               {kScale, "scale"},
                                               {kUnit, "unit"},
                                               {kGap, "gap"},
                                               {kPriority, "priority"},
                                               {kDue, "due"},
                                               {kValue, "value"},
                                               {kOrientations, "orientations"}}};

std::string known_columns() {
    std::string list;
    for (const ColumnName& column : kColumns) {
        list += (list.empty() ? "" : ", ") + std::string(column.name);
        if (*column.also) list += " (or " + std::string(column.also) + ")";
    }
    return list;
}

/// Spreadsheets of countries with a decimal comma separate columns by semicolons.
char separator_of(std::string_view text) {
    const std::string_view header = text.substr(0, text.find_first_of("\r\n", text.find_first_not_of("\r\n")));
    return header.find(';') != std::string_view::npos && header.find(',') == std::string_view::npos ? ';' : ',';
}

class SetParser {
  public:
    SetParser(std::string file, std::string_view text)
        : file_(std::move(file)), separator_(separator_of(text)), rows_(parse_csv(file_, text, separator_)) {}

    std::vector<SetRow> parse() {
        if (rows_.empty()) throw InputError(file_, "", "the set is empty: a header like 'mesh,count' is needed");
        parse_header(rows_.front());
        if (rows_.size() == 1) throw InputError(file_, "", "the set names no part: there is nothing below its header");
        std::vector<SetRow> set;
        for (std::size_t i = 1; i < rows_.size(); ++i) {
            row_ = &rows_[i];
            set.push_back(parse_row());
        }
        return set;
    }

  private:
    void parse_header(const CsvRow& header) {
        row_ = &header;
        width_ = header.fields.size();
        for (std::size_t i = 0; i < width_; ++i) {
            const std::string name = lower_case(trimmed(header.fields[i]));
            if (name.empty()) {
                unnamed_.push_back(i);
                continue;
            }
            const auto known =
                std::ranges::find_if(kColumns, [&](const ColumnName& c) { return name == c.name || name == c.also; });
            if (known == kColumns.end()) {
                fail("unknown column " + quoted_excerpt(header.fields[i]) + "; known are " + known_columns());
            }
            std::optional<std::size_t>& place = places_[known->column];
            if (place) fail("the column '" + std::string(known->name) + "' is there twice");
            place = i;
        }
        if (!places_[kMesh]) fail("there is no column 'mesh'; known are " + known_columns());
    }

    SetRow parse_row() const {
        if (row_->fields.size() != width_) {
            fail("there are " + std::to_string(row_->fields.size()) + " fields where the header has " +
                 std::to_string(width_));
        }
        for (const std::size_t i : unnamed_) {
            if (!trimmed(row_->fields[i]).empty()) {
                fail(quoted_excerpt(row_->fields[i]) + " stands in a column without a name");
            }
        }
        SetRow row;
        row.line = row_->line;
        row.mesh = row_->fields[*places_[kMesh]];
        if (trimmed(row.mesh).empty()) fail("the mesh is not named");
        row.name = text(kName);
        if (places_[kCount]) row.count = count();
        row.scale = number(kScale, 1, above_zero, "above 0");
        if (const std::string word = lower_case(text(kUnit)); !word.empty()) {
            const auto unit = from_string<LengthUnit>(word);
            if (!unit) fail("unit " + quoted_excerpt(text(kUnit)) + " is none of mm, inch, m");
            row.unit = in_mm(*unit);
        }
        if (!text(kGap).empty()) row.gap = number(kGap, 0, from_zero, "from 0");
        row.priority = number(kPriority, 0, any, "");
        row.value = number(kValue, 1, from_zero, "from 0");
        row.due = text(kDue);
        if (!row.due.empty() && !is_date(row.due)) {
            fail("due " + quoted_excerpt(row.due) + " is not a date like 2026-12-01");
        }
        if (const std::string words = lower_case(text(kOrientations)); !words.empty()) {
            const auto orientations = part_orientations_in(words);
            if (!orientations) {
                fail("orientations " + quoted_excerpt(text(kOrientations)) +
                     " are none of any, upright, fixed, nor axes that may point up, like +z -z");
            }
            row.orientations = *orientations;
        }
        return row;
    }

    /// Empty where the column is missing.
    std::string text(Column column) const {
        return places_[column] ? trimmed(row_->fields[*places_[column]]) : std::string();
    }

    static bool above_zero(double number) { return number > 0; }
    static bool from_zero(double number) { return number >= 0; }
    static bool any(double) { return true; }

    /// `by_default` where nothing is said.
    double number(Column column, double by_default, bool (*accepted)(double), const char* range) const {
        std::string said = text(column);
        if (said.empty()) return by_default;
        if (separator_ == ';') std::ranges::replace(said, ',', '.');
        const auto number = parse_number(said);
        if (number && std::isfinite(*number) && accepted(*number)) return *number;
        fail(std::string(kColumns[column].name) + " " + quoted_excerpt(text(column)) + " is not a number" +
             (*range ? " " : "") + range);
    }

    int count() const {
        const auto count = parse_integer(text(kCount));
        if (!count || *count < 1 || *count > std::numeric_limits<int>::max()) {
            fail("count " + quoted_excerpt(text(kCount)) + " is not a whole number from 1");
        }
        return static_cast<int>(*count);
    }

    [[noreturn]] void fail(const std::string& cause) const {
        throw InputError(file_, "line " + std::to_string(row_->line), cause);
    }

    std::string file_;
    char separator_;
    std::vector<CsvRow> rows_;
    const CsvRow* row_ = nullptr;  ///< that is being read
    std::size_t width_ = 0;
    std::array<std::optional<std::size_t>, kColumns.size()> places_;  ///< by column
    std::vector<std::size_t> unnamed_;                                ///< as spreadsheets leave some behind
};

}  // namespace

std::vector<SetRow> parse_set(const std::string& file, std::string_view text) { return SetParser(file, text).parse(); }

std::vector<SetRow> read_set(const std::filesystem::path& path) {
    return parse_set(path.string(), FileBytes(path).view());
}

void write_set(const std::vector<SetRow>& rows, const std::filesystem::path& path) {
    std::string text = "mesh,count,scale\n";
    for (const SetRow& row : rows) {
        text += csv_field(row.mesh) + "," + std::to_string(row.count) + "," + fmt::format("{}", row.scale) + "\n";
    }
    replace_file(path, text);
}

}  // namespace spectralpack
