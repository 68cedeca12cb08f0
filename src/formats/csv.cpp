#include "formats/csv.hpp"

#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

class CsvParser {
  public:
    CsvParser(const std::string& file, std::string_view text, char separator)
        : file_(file), text_(text), separator_(separator), ends_{separator, '\r', '\n', '"'} {
        if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
    }

    std::vector<CsvRow> parse() {
        std::vector<CsvRow> rows;
        while (at_ < text_.size()) {
            CsvRow row;
            row.line = line_;
            do {
                row.fields.push_back(field());
            } while (take(separator_));
            end_of_row();
            if (row.fields.size() > 1 || !row.fields[0].empty()) rows.push_back(std::move(row));
        }
        return rows;
    }

  private:
    bool take(char c) {
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }

    std::string field() {
        if (take('"')) return quoted_field();
        const std::size_t end = std::min(text_.find_first_of(ends_, at_), text_.size());
        if (end < text_.size() && text_[end] == '"') fail("a quote inside a field that does not start with one");
        std::string field(text_.substr(at_, end - at_));
        at_ = end;
        return field;
    }

    std::string quoted_field() {
        const int start = line_;
        std::string field;
        while (at_ < text_.size()) {
            const char c = text_[at_++];
            if (c == '"' && !take('"')) return field;
            if (c == '\n' || (c == '\r' && text_.substr(at_, 1) != "\n")) ++line_;
            field += c;
        }
        line_ = start;
        fail("a quoted field is not ended");
    }

    void end_of_row() {
        if (at_ >= text_.size()) return;
        const bool cr = take('\r'), lf = take('\n');
        if (!cr && !lf) fail("text after the closing quote of a field");
        ++line_;
    }

    [[noreturn]] void fail(const std::string& cause) const {
        throw InputError(file_, "line " + std::to_string(line_), cause);
    }

    const std::string& file_;
    std::string_view text_;
    char separator_;
    std::string ends_;  ///< of a field without quotes, or what may not be in it
    std::size_t at_ = 0;
    int line_ = 1;
};

}  // namespace

std::vector<CsvRow> parse_csv(const std::string& file, std::string_view text, char separator) {
    return CsvParser(file, text, separator).parse();
}

std::string csv_field(std::string_view field) {
    const bool plain = field.find_first_of(",\"\r\n") == std::string_view::npos &&
                       (field.empty() || (field.front() != ' ' && field.back() != ' '));
    if (plain) return std::string(field);
    std::string quoted = "\"";
    for (const char c : field) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

}  // namespace spectralpack
