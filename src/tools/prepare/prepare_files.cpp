#include "tools/prepare/prepare_files.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <optional>
#include <utility>

#include "core/atomic_file.hpp"
#include "formats/csv.hpp"
#include "formats/file_bytes.hpp"
#include "formats/number_text.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack::tools {
namespace {

constexpr const char* kColumns =
    "file,object,outcome,detail,mesh,triangles_before,triangles_after,size_x,size_y,size_z,volume,scale,repairs";
constexpr std::size_t kColumnCount = 13;

// A journal's row is the file's bytes, its time, how many rows the file has, and a report's row.
constexpr std::size_t kStampCount = 3;
constexpr const char* kJournalName = "spectralpack prepare 1";

std::string row_text(const PreparedRow& row) {
    return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(row.file), row.object,
                       csv_field(row.outcome), csv_field(row.detail), csv_field(row.mesh), row.triangles_before,
                       row.triangles_after, row.size.x, row.size.y, row.size.z, row.volume, row.scale,
                       csv_field(row.repairs));
}

std::string file_text(const PreparedFile& file) {
    std::string text;
    for (const PreparedRow& row : file.rows) {
        text += fmt::format("{},{},{},", file.bytes, file.modified, file.rows.size()) + row_text(row);
    }
    return text;
}

/// Rows of what was written whole: the end may be torn.
std::vector<CsvRow> whole_rows(const std::string& name, std::string_view text) {
    for (;;) {
        const std::size_t end = text.rfind('\n');
        if (end == std::string_view::npos) return {};
        text = text.substr(0, end + 1);
        try {
            return parse_csv(name, text);
        } catch (const InputError&) {
            text = text.substr(0, end);  // the last line's start is inside a quoted field
        }
    }
}

/// Reads numbers field by field and remembers whether all of them were numbers.
class Fields {
  public:
    explicit Fields(const std::vector<std::string>& fields) : fields_(fields) {}

    std::string text() { return fields_[at_++]; }
    std::int64_t integer() {
        const auto value = parse_integer(fields_[at_++]);
        good_ = good_ && value;
        return value.value_or(0);
    }
    double number() {
        const auto value = parse_number(fields_[at_++]);
        good_ = good_ && value;
        return value.value_or(0);
    }
    bool good() const { return good_; }

  private:
    const std::vector<std::string>& fields_;
    std::size_t at_ = 0;
    bool good_ = true;
};

PreparedRow read_row(Fields& fields) {
    PreparedRow row;
    row.file = fields.text();
    row.object = static_cast<int>(fields.integer());
    row.outcome = fields.text();
    row.detail = fields.text();
    row.mesh = fields.text();
    row.triangles_before = fields.integer();
    row.triangles_after = fields.integer();
    row.size.x = fields.number();
    row.size.y = fields.number();
    row.size.z = fields.number();
    row.volume = fields.number();
    row.scale = fields.number();
    row.repairs = fields.text();
    return row;
}

/// The files of which every row is there; a later one takes the place of an earlier one.
std::map<std::string, PreparedFile> read_files(const std::vector<CsvRow>& rows) {
    std::map<std::string, PreparedFile> files;
    PreparedFile file;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        if (rows[i].fields.size() != kStampCount + kColumnCount) continue;
        Fields fields(rows[i].fields);
        const std::int64_t bytes = fields.integer(), modified = fields.integer(), count = fields.integer();
        PreparedRow row = read_row(fields);
        if (!fields.good()) continue;
        if (file.rows.empty() || file.rows.front().file != row.file || file.bytes != bytes ||
            file.modified != modified) {
            file = {bytes, modified, {}};
        }
        const std::string name = row.file;
        file.rows.push_back(std::move(row));
        if (static_cast<std::int64_t>(file.rows.size()) == count) files[name] = std::exchange(file, {});
    }
    return files;
}

}  // namespace

void write_prepare_report(const std::vector<PreparedRow>& rows, const std::filesystem::path& path) {
    std::string text = std::string(kColumns) + "\n";
    for (const PreparedRow& row : rows) {
        text += row_text(row);
    }
    replace_file(path, text);
}

PrepareJournal::PrepareJournal(std::filesystem::path path, const std::string& settings) : path_(std::move(path)) {
    std::string begin = csv_field(kJournalName) + "," + csv_field(settings) + "\n";
    if (std::filesystem::exists(path_)) {
        const std::vector<CsvRow> rows = whole_rows(path_.string(), FileBytes(path_).view());
        if (!rows.empty() && rows[0].fields != std::vector<std::string>{kJournalName, settings}) {
            throw UsageError(path_.string() + ": was begun with other options (" +
                             (rows[0].fields.size() == 2 ? rows[0].fields[1] : "not a journal of this program") +
                             "; now " + settings + "): use another folder, or remove the file to begin anew");
        }
        files_ = read_files(rows);
    }
    for (const auto& [name, file] : files_) {
        begin += file_text(file);
    }
    replace_file(path_, begin);
    out_.open(path_, std::ios::app | std::ios::binary);
}

void PrepareJournal::add(const std::string& name, PreparedFile file) {
    errno = 0;
    out_ << file_text(file) << std::flush;
    if (!out_) throw write_failure(path_);
    files_[name] = std::move(file);
}

}  // namespace spectralpack::tools
