#include "formats/set_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

#include "core/atomic_file.hpp"
#include "formats/csv.hpp"
#include "formats/file_bytes.hpp"
#include "formats/number_text.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

std::string trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

class SetParser {
  public:
    SetParser(std::string file, std::vector<CsvRow> rows) : file_(std::move(file)), rows_(std::move(rows)) {}

    std::vector<SetRow> parse() {
        if (rows_.empty()) throw InputError(file_, "", "the set is empty: a header 'mesh,count,scale' is needed");
        parse_header(rows_.front());
        std::vector<SetRow> set;
        for (std::size_t i = 1; i < rows_.size(); ++i) {
            set.push_back(parse_row(rows_[i]));
        }
        return set;
    }

  private:
    void parse_header(const CsvRow& header) {
        columns_ = header.fields.size();
        for (std::size_t i = 0; i < columns_; ++i) {
            const std::string name = trimmed(header.fields[i]);
            std::optional<std::size_t>* column = name == "mesh"    ? &mesh_
                                                 : name == "count" ? &count_
                                                 : name == "scale" ? &scale_
                                                                   : nullptr;
            if (!column) {
                fail(header, "unknown column " + quoted_excerpt(name) + "; known are mesh, count, scale" +
                                 (name.find(';') != std::string::npos ? ", separated by commas" : ""));
            }
            if (*column) fail(header, "the column '" + name + "' is there twice");
            *column = i;
        }
        if (!mesh_) fail(header, "there is no column 'mesh'");
    }

    SetRow parse_row(const CsvRow& row) const {
        if (row.fields.size() != columns_) {
            fail(row, "there are " + std::to_string(row.fields.size()) + " fields where the header has " +
                          std::to_string(columns_));
        }
        SetRow result;
        result.line = row.line;
        result.mesh = row.fields[*mesh_];
        if (trimmed(result.mesh).empty()) fail(row, "the mesh is not named");
        if (count_) {
            const auto count = parse_integer(trimmed(row.fields[*count_]));
            if (!count || *count < 1 || *count > std::numeric_limits<int>::max()) {
                fail(row, "count " + quoted_excerpt(row.fields[*count_]) + " is not a whole number from 1");
            }
            result.count = static_cast<int>(*count);
        }
        if (scale_) {
            const auto scale = parse_number(trimmed(row.fields[*scale_]));
            if (!scale || !std::isfinite(*scale) || *scale <= 0) {
                fail(row, "scale " + quoted_excerpt(row.fields[*scale_]) + " is not a number above 0");
            }
            result.scale = *scale;
        }
        return result;
    }

    [[noreturn]] void fail(const CsvRow& row, const std::string& cause) const {
        throw InputError(file_, "line " + std::to_string(row.line), cause);
    }

    std::string file_;
    std::vector<CsvRow> rows_;
    std::size_t columns_ = 0;
    std::optional<std::size_t> mesh_, count_, scale_;
};

}  // namespace

std::vector<SetRow> parse_set(const std::string& file, std::string_view text) {
    return SetParser(file, parse_csv(file, text)).parse();
}

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
