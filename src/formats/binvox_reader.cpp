/// binvox (Patrick Min's voxel format, version 1): the solid voxels' outer faces become the mesh. A
/// voxel's edge is the header's scale divided by the largest dimension.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/stopped.hpp"
#include "formats/mesh_parsers.hpp"
#include "formats/number_text.hpp"
#include "formats/text_lines.hpp"
#include "geometry/mesh_weld.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

/// A few bytes of run lengths can stand for very many faces; so many take a gibibyte.
constexpr std::size_t kMostFaces = 12'000'000;
constexpr std::int64_t kMostVoxels = std::int64_t{1} << 32;

class BinvoxParser {
  public:
    explicit BinvoxParser(const MeshBytes& source) : source_(source), lines_(source.bytes, source.stop) {}

    LoadedMesh parse() {
        parse_header();
        read_runs();
        LoadedMesh loaded;
        loaded.mesh = boundary();
        const double edge = scale_ / static_cast<double>(*std::max_element(dim_.begin(), dim_.end()));
        for (Vec3& vertex : loaded.mesh.vertices) {
            vertex = translate_ + edge * vertex;
        }
        return loaded;
    }

  private:
    /// '#binvox 1', then dim, translate and scale in any order, then 'data' and the bytes.
    void parse_header() {
        next_line();
        if (words_[0] != "#binvox" || words_.size() < 2 || words_[1] != "1") {
            fail("is not a binvox file of version 1");
        }
        for (;;) {
            next_line();
            if (words_[0] == "data") break;
            if (words_[0] == "dim" && words_.size() == 4) {
                // The order of the bytes: y runs fastest, then z, then x.
                dim_ = {dimension(words_[1]), dimension(words_[3]), dimension(words_[2])};
            } else if (words_[0] == "translate" && words_.size() == 4) {
                for (int axis = 0; axis < 3; ++axis) {
                    translate_[axis] = lines_.coordinate(source_.file, words_[static_cast<std::size_t>(axis) + 1]);
                }
            } else if (words_[0] == "scale" && words_.size() == 2) {
                scale_ = lines_.coordinate(source_.file, words_[1]);
                if (!(scale_ > 0)) fail("the scale must be above 0");
            } else {
                fail("expected dim, translate, scale or data, found " + quoted_excerpt(lines_.line()));
            }
        }
        if (dim_[0] == 0) fail("the dimensions are missing");
    }

    void next_line() {
        do {
            if (!lines_.next()) fail("the file ends in its header");
            split_words(lines_.line(), words_);
        } while (words_.empty());
    }

    std::int64_t dimension(std::string_view word) const {
        const auto value = parse_integer(word);
        if (!value || *value < 1 || *value > 65'536) {
            fail(quoted_excerpt(word) + " is not a dimension from 1 to 65536");
        }
        return *value;
    }

    /// Pairs of a value and how often it comes; all voxels must be there before anything is set
    /// aside for them.
    void read_runs() {
        const std::string_view data = lines_.rest();
        const std::int64_t voxels = dim_[0] * dim_[1] * dim_[2];
        std::int64_t promised = 0;
        for (std::size_t i = 1; i < data.size(); i += 2) {
            promised += static_cast<unsigned char>(data[i]);
        }
        if (promised != voxels || data.size() % 2 != 0 || voxels > kMostVoxels) {
            throw InputError(source_.file, "data",
                             "there are " + std::to_string(promised) + " voxels where the dimensions need " +
                                 std::to_string(voxels));
        }
        solid_.reserve(static_cast<std::size_t>(voxels));
        StopPoll poll(source_.stop);
        for (std::size_t i = 0; i < data.size(); i += 2) {
            poll.step();
            solid_.insert(solid_.end(), static_cast<unsigned char>(data[i + 1]), data[i] != 0);
        }
    }

    bool is_solid(const std::array<std::int64_t, 3>& at) const {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (at[axis] < 0 || at[axis] >= dim_[axis]) return false;
        }
        return solid_[static_cast<std::size_t>((at[0] * dim_[2] + at[2]) * dim_[1] + at[1])];
    }

    /// In units of voxels.
    Mesh boundary() const {
        Mesh mesh;
        VertexWelder welder(1024);
        std::array<std::int64_t, 3> at;
        for (at[0] = 0; at[0] < dim_[0]; ++at[0]) {
            for (at[2] = 0; at[2] < dim_[2]; ++at[2]) {
                throw_if_stopped(source_.stop);
                for (at[1] = 0; at[1] < dim_[1]; ++at[1]) {
                    if (!is_solid(at)) continue;
                    for (std::size_t axis = 0; axis < 3; ++axis) {
                        for (const int side : {0, 1}) {
                            auto neighbour = at;
                            neighbour[axis] += side == 1 ? 1 : -1;
                            if (!is_solid(neighbour)) add_face(mesh, welder, at, static_cast<int>(axis), side);
                        }
                    }
                }
            }
        }
        mesh.vertices = welder.take();
        return mesh;
    }

    void add_face(Mesh& mesh, VertexWelder& welder, const std::array<std::int64_t, 3>& at, int axis, int side) const {
        if (mesh.triangles.size() >= 2 * kMostFaces) {
            throw InputError(source_.file, "data", "its surface has too many faces");
        }
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        std::array<Vec3, 4> corners;
        for (int i = 0; i < 4; ++i) {
            Vec3& corner = corners[static_cast<std::size_t>(i)];
            for (int k = 0; k < 3; ++k) {
                corner[k] = static_cast<double>(at[static_cast<std::size_t>(k)]);
            }
            corner[axis] += side;
            corner[u] += i == 1 || i == 2 ? 1 : 0;
            corner[v] += i >= 2 ? 1 : 0;
        }
        if (side == 0) std::swap(corners[1], corners[3]);  // counter-clockwise from outside
        std::array<std::uint32_t, 4> index;
        welder.add(corners, index.data());
        mesh.triangles.push_back({index[0], index[1], index[2]});
        mesh.triangles.push_back({index[0], index[2], index[3]});
    }

    [[noreturn]] void fail(const std::string& cause) const { lines_.fail(source_.file, cause); }

    const MeshBytes& source_;
    TextLines lines_;
    std::vector<std::string_view> words_;
    std::array<std::int64_t, 3> dim_{};  ///< x, y, z
    Vec3 translate_;
    double scale_ = 1;
    std::vector<bool> solid_;
};

}  // namespace

std::vector<ParsedMesh> parse_binvox(const MeshBytes& source) { return {{BinvoxParser(source).parse(), true}}; }

}  // namespace spectralpack
