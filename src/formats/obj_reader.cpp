/// Wavefront OBJ: vertices and faces. The file is one object, whatever groups it names; normals,
/// texture coordinates and materials are of no interest, and no other file is opened.

#include "formats/mesh_parsers.hpp"
#include "formats/number_text.hpp"
#include "formats/polygon_faces.hpp"
#include "formats/text_lines.hpp"

namespace spectralpack {
namespace {

class ObjParser {
  public:
    explicit ObjParser(const MeshBytes& source) : source_(source), lines_(source.bytes, source.stop) {}

    LoadedMesh parse() {
        while (next_statement()) {
            if (words_[0] == "v") {
                parse_vertex();
            } else if (words_[0] == "f" || words_[0] == "fo") {
                parse_face();
            }
        }
        LoadedMesh loaded;
        loaded.mesh.triangles = faces_.triangles(
            vertices_, [&](std::uint32_t line, const std::string& cause) { fail_at_line(source_.file, line, cause); },
            source_.stop);
        loaded.mesh.vertices = std::move(vertices_);
        return loaded;
    }

  private:
    /// A line without its comment; a backslash at the end joins the next one.
    bool next_statement() {
        while (lines_.next()) {
            statement_line_ = static_cast<std::uint32_t>(lines_.number());
            std::string_view line = lines_.line();
            if (line.ends_with('\\')) {
                joined_.clear();
                while (line.ends_with('\\')) {
                    joined_ += line.substr(0, line.size() - 1);
                    joined_ += ' ';
                    line = lines_.next() ? lines_.line() : std::string_view();
                }
                joined_ += line;
                line = joined_;
            }
            split_words(line.substr(0, line.find('#')), words_);
            if (!words_.empty()) return true;
        }
        return false;
    }

    /// x y z, perhaps followed by a weight or a colour.
    void parse_vertex() {
        if (words_.size() < 4) lines_.fail(source_.file, "a vertex has three coordinates");
        vertices_.push_back({lines_.coordinate(source_.file, words_[1]), lines_.coordinate(source_.file, words_[2]),
                             lines_.coordinate(source_.file, words_[3])});
        if (vertices_.size() > kMostVertices) lines_.fail(source_.file, "there are too many vertices");
    }

    /// Each corner is v, v/vt, v//vn or v/vt/vn; indices start at 1, negative ones count back from
    /// the last.
    void parse_face() {
        corners_.clear();
        for (std::size_t i = 1; i < words_.size(); ++i) {
            const std::string_view word = words_[i].substr(0, words_[i].find('/'));
            const auto index = parse_integer(word);
            if (!index) lines_.fail(source_.file, quoted_excerpt(words_[i]) + " is not a vertex of a face");
            if (*index == 0) lines_.fail(source_.file, "vertex index 0: indices start at 1");
            corners_.push_back(*index > 0 ? *index - 1 : std::ssize(vertices_) + *index);
        }
        faces_.add(corners_, statement_line_);
    }

    const MeshBytes& source_;
    TextLines lines_;
    std::string joined_;
    std::uint32_t statement_line_ = 0;
    std::vector<std::string_view> words_;
    std::vector<std::int64_t> corners_;
    std::vector<Vec3> vertices_;
    PolygonFaces faces_;
};

}  // namespace

std::vector<ParsedMesh> parse_obj(const MeshBytes& source) { return {{ObjParser(source).parse()}}; }

}  // namespace spectralpack
