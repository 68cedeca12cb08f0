/// Object File Format (Geomview's OFF), ASCII: vertices and faces; normals and colours are skipped.

#include "formats/mesh_parsers.hpp"
#include "formats/number_text.hpp"
#include "formats/polygon_faces.hpp"
#include "formats/text_lines.hpp"

namespace spectralpack {
namespace {

class OffParser {
  public:
    explicit OffParser(const MeshBytes& source) : source_(source), lines_(source.bytes, source.stop) {}

    LoadedMesh parse() {
        parse_header();
        const std::int64_t vertices = count(0), faces = count(1);
        LoadedMesh loaded;
        for (std::int64_t i = 0; i < vertices; ++i) {
            expect_line();
            if (words_.size() < 3) lines_.fail(source_.file, "a vertex has three coordinates");
            loaded.mesh.vertices.push_back({lines_.coordinate(source_.file, words_[0]),
                                            lines_.coordinate(source_.file, words_[1]),
                                            lines_.coordinate(source_.file, words_[2])});
        }
        PolygonFaces polygons;
        for (std::int64_t i = 0; i < faces; ++i) {
            expect_line();
            parse_face(polygons);
        }
        loaded.mesh.triangles = polygons.triangles(
            loaded.mesh.vertices,
            [&](std::uint32_t line, const std::string& cause) { fail_at_line(source_.file, line, cause); },
            source_.stop);
        return loaded;
    }

  private:
    bool next_line() {
        while (lines_.next()) {
            split_words(lines_.line().substr(0, lines_.line().find('#')), words_);
            if (!words_.empty()) return true;
        }
        return false;
    }

    void expect_line() {
        if (!next_line()) lines_.fail(source_.file, "the file ends before all its vertices and faces");
    }

    /// The key word (ST: texture, C: colour, N: normal before OFF), then the counts, on its line or
    /// the next. The key word may be missing.
    void parse_header() {
        expect_line();
        if (words_[0].ends_with("OFF")) {
            const std::string_view prefix = words_[0].substr(0, words_[0].size() - 3);
            if (prefix.find_first_not_of("STCN") != std::string_view::npos) {
                lines_.fail(source_.file, quoted_excerpt(words_[0]) + ": only three dimensions can be read");
            }
            words_.erase(words_.begin());
            if (words_.empty()) expect_line();
            if (words_[0] == "BINARY") lines_.fail(source_.file, "binary OFF cannot be read");
        }
        if (words_.size() < 2) lines_.fail(source_.file, "expected the numbers of vertices and faces");
    }

    /// Nothing is reserved by it: each vertex and face must be there, on a line of its own.
    std::int64_t count(std::size_t word) const {
        const auto value = parse_integer(words_[word]);
        if (!value || *value < 0 || *value > static_cast<long long>(kMostVertices)) {
            lines_.fail(source_.file, quoted_excerpt(words_[word]) + " is not a number of vertices or faces");
        }
        return *value;
    }

    void parse_face(PolygonFaces& polygons) {
        const auto size = parse_integer(words_[0]);
        if (!size || *size < 1 || *size >= std::ssize(words_)) {
            lines_.fail(source_.file, "a face has a number of corners and as many indices");
        }
        corners_.clear();
        for (std::size_t i = 1; i <= static_cast<std::size_t>(*size); ++i) {
            const auto index = parse_integer(words_[i]);
            if (!index) lines_.fail(source_.file, quoted_excerpt(words_[i]) + " is not a vertex of a face");
            corners_.push_back(*index);
        }
        polygons.add(corners_, static_cast<std::uint32_t>(lines_.number()));
    }

    const MeshBytes& source_;
    TextLines lines_;
    std::vector<std::string_view> words_;
    std::vector<std::int64_t> corners_;
};

}  // namespace

std::vector<ParsedMesh> parse_off(const MeshBytes& source) { return {{OffParser(source).parse()}}; }

}  // namespace spectralpack
