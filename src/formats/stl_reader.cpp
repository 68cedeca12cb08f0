/// STL, binary and ASCII. The format has no unit and no connectivity: three corners for every
/// facet.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/stopped.hpp"
#include "formats/mesh_parsers.hpp"
#include "formats/number_text.hpp"
#include "formats/text_lines.hpp"
#include "geometry/mesh_weld.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

constexpr std::size_t kHeader = 84;  ///< 80 bytes of anything and a 32-bit count
constexpr std::size_t kFacet = 50;   ///< normal, three corners (floats), two bytes of anything

static_assert(std::endian::native == std::endian::little, "binary STL is little endian");

std::uint32_t stated_count(std::string_view bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + kHeader - sizeof count, sizeof count);
    return count;
}

bool looks_like_text(std::string_view bytes) {
    return std::all_of(bytes.begin(), bytes.begin() + std::min<std::ptrdiff_t>(std::ssize(bytes), 512),
                       [](char c) { return static_cast<unsigned char>(c) >= ' ' || (c >= '\t' && c <= '\r'); });
}

/// Facets are welded as they are read: all their corners apart would take more room than the file.
Mesh weld_facets(const MeshBytes& source, std::size_t count) {
    constexpr std::size_t kBatch = VertexWelder::kBatch / 3;
    Mesh mesh;
    mesh.triangles.resize(count);
    VertexWelder welder(count / 2 + 2);  // a closed surface has about half as many vertices as facets
    const char* facet = source.bytes.data() + kHeader;
    std::array<Vec3, 3 * kBatch> corners;
    for (std::size_t i = 0; i < count; i += kBatch) {
        throw_if_stopped(source.stop);
        const std::size_t batch = std::min(kBatch, count - i);
        for (std::size_t k = 0; k < batch; ++k, facet += kFacet) {
            std::array<float, 9> c;
            std::memcpy(c.data(), facet + 12, sizeof c);
            float not_finite = 0;  // 0 * x is 0 for finite x, else NaN
            for (const float coordinate : c) {
                not_finite += 0 * coordinate;
            }
            if (not_finite != 0) {
                throw InputError(source.file, "facet " + std::to_string(i + k + 1),
                                 "a coordinate is not a finite number");
            }
            corners[3 * k] = {c[0], c[1], c[2]};
            corners[3 * k + 1] = {c[3], c[4], c[5]};
            corners[3 * k + 2] = {c[6], c[7], c[8]};
        }
        welder.add({corners.data(), 3 * batch}, mesh.triangles[i].data());
    }
    mesh.vertices = welder.take();
    return mesh;
}

LoadedMesh parse_binary(const MeshBytes& source) {
    const std::string_view bytes = source.bytes;
    if (bytes.size() < kHeader) {
        throw InputError(source.file, "", "the file is shorter than an STL header");
    }
    const std::uint64_t stated = stated_count(bytes);
    const std::uint64_t held = (bytes.size() - kHeader) / kFacet;
    if (stated > held) {
        throw InputError(source.file, "byte 80",
                         looks_like_text(bytes) ? "the file is text, but not an ASCII STL"
                                                : "the header promises " + std::to_string(stated) +
                                                      " facets, the file has room for " + std::to_string(held));
    }
    const std::size_t trailing = bytes.size() - kHeader - stated * kFacet;
    if (trailing >= kFacet) {
        throw InputError(
            source.file, "byte 80",
            "the header promises " + std::to_string(stated) + " facets, the file holds " + std::to_string(held));
    }
    if (stated > kMostTriangles) throw InputError(source.file, "byte 80", "there are too many facets");
    LoadedMesh loaded;
    if (trailing > 0) {
        loaded.warnings.push_back({"has " + std::to_string(trailing) + " bytes after its last facet, which are ignored",
                                   "have bytes after their last facet, which are ignored"});
    }
    loaded.mesh = weld_facets(source, stated);
    return loaded;
}

/// Key words in any case, any white space, several solids (together one object), free text after
/// 'solid' and 'endsolid'.
class AsciiStl {
  public:
    explicit AsciiStl(const MeshBytes& source) : source_(source), lines_(source.bytes, source.stop) {}

    LoadedMesh parse() {
        while (next_line()) {
            if (equal_ignoring_case(words_[0], "solid")) {
                parse_solid();
            } else {
                fail("expected 'solid', found " + quoted_excerpt(words_[0]));
            }
        }
        weld_equal_vertices(loaded_.mesh, source_.stop);
        return std::move(loaded_);
    }

  private:
    bool next_line() {
        while (lines_.next()) {
            split_words(lines_.line(), words_);
            if (!words_.empty()) return true;
        }
        return false;
    }

    void expect_line() {
        if (!next_line()) fail("the file ends in the middle of a solid");
    }

    void expect_words(std::size_t at, std::initializer_list<const char*> expected) {
        for (const char* word : expected) {
            if (at >= words_.size() || !equal_ignoring_case(words_[at], word)) {
                fail("expected '" + std::string(word) + "', found " +
                     (at < words_.size() ? quoted_excerpt(words_[at]) : "the end of the line"));
            }
            ++at;
        }
    }

    void parse_solid() {
        for (;;) {
            expect_line();
            if (equal_ignoring_case(words_[0], "endsolid")) return;
            expect_words(0, {"facet"});
            expect_line();
            expect_words(0, {"outer", "loop"});
            for (int corner = 0; corner < 3; ++corner) {
                expect_line();
                parse_vertex();
            }
            expect_line();
            expect_words(0, {"endloop"});
            expect_line();
            expect_words(0, {"endfacet"});
            if (loaded_.mesh.triangles.size() >= kMostTriangles) fail("there are too many facets");
            const auto end = static_cast<std::uint32_t>(loaded_.mesh.vertices.size());
            loaded_.mesh.triangles.push_back({end - 3, end - 2, end - 1});
        }
    }

    void parse_vertex() {
        expect_words(0, {"vertex"});
        if (words_.size() != 4) fail("a vertex has three coordinates separated by spaces");
        Vec3 vertex;
        for (int axis = 0; axis < 3; ++axis) {
            vertex[axis] = lines_.coordinate(source_.file, words_[static_cast<std::size_t>(axis) + 1]);
        }
        loaded_.mesh.vertices.push_back(vertex);
    }

    [[noreturn]] void fail(const std::string& cause) const { lines_.fail(source_.file, cause); }

    const MeshBytes& source_;
    TextLines lines_;
    std::vector<std::string_view> words_;
    LoadedMesh loaded_;
};

/// 'solid' alone proves nothing, some programs begin binary headers with it: the next line must go
/// on as text does.
bool is_ascii(std::string_view bytes) {
    if (bytes.size() >= kHeader && bytes.size() == kHeader + kFacet * std::uint64_t{stated_count(bytes)}) {
        return false;
    }
    TextLines lines(bytes.substr(0, 4096));
    std::vector<std::string_view> words;
    bool in_solid = false;
    while (lines.next()) {
        split_words(lines.line(), words);
        if (words.empty()) continue;
        if (in_solid) return equal_ignoring_case(words[0], "facet") || equal_ignoring_case(words[0], "endsolid");
        if (!equal_ignoring_case(words[0], "solid")) return false;
        in_solid = true;
    }
    return in_solid && looks_like_text(bytes);
}

}  // namespace

std::vector<ParsedMesh> parse_stl(const MeshBytes& source) {
    if (is_ascii(source.bytes)) return {{AsciiStl(source).parse(), true}};
    return {{parse_binary(source), true}};
}

}  // namespace spectralpack
