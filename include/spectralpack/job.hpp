#pragma once
/// What is to be packed, and into what: parts, container and options of one run.
///
/// Meshes come from files or from memory (MeshInput). Lengths are millimetres. A mesh's own unit is `unit` millimetres,
/// unless its file says otherwise. A transform goes from the mesh's own coordinates to the container's, whose lower
/// corner is the origin, z up; it holds unit and scale.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "spectralpack/error.hpp"
#include "spectralpack/geometry.hpp"
#include "spectralpack/mesh.hpp"
#include "spectralpack/options.hpp"
#include "spectralpack/orientations.hpp"
#include "spectralpack/packing.hpp"
#include "spectralpack/printers.hpp"
#include "spectralpack/stop.hpp"

namespace spectralpack {

/// A mesh file (usable from the working directory), or triangles at hand: moved in, or shared with the caller.
class MeshInput {
  public:
    MeshInput() = default;
    MeshInput(std::string file) : source_(std::move(file)) {}
    MeshInput(const char* file) : source_(std::string(file)) {}
    MeshInput(Mesh mesh) : source_(std::make_shared<const Mesh>(std::move(mesh))) {}
    MeshInput(std::shared_ptr<const Mesh> mesh) : source_(std::move(mesh)) {}
    /// The caller keeps the mesh and does not change it as long as the job or a result of it lives.
    static MeshInput borrowed(const Mesh& mesh) { return std::shared_ptr<const Mesh>(std::shared_ptr<void>(), &mesh); }

    /// Empty for a mesh in memory.
    const std::string& file() const {
        static const std::string none;
        const auto* file = std::get_if<std::string>(&source_);
        return file ? *file : none;
    }
    /// Null for a file.
    std::shared_ptr<const Mesh> mesh() const {
        const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&source_);
        return mesh ? *mesh : nullptr;
    }

  private:
    std::variant<std::string, std::shared_ptr<const Mesh>> source_;
};

/// Scales of parts are within these: what is smaller or larger comes to numbers that transforms cannot hold.
inline constexpr double kLeastScale = 1e-9, kMostScale = 1e9;

/// A mesh to pack, how often, and its constraints. The objects of a file (a 3MF may hold several) become parts of
/// their own.
struct Part {
    std::string name = {};  ///< for people; empty: as the file says
    MeshInput mesh = {};
    /// Of a 3MF with several objects, the one to pack, by its id; `count` copies whatever the file's build says. None:
    /// all of them, `count` times as often as the file holds each.
    std::optional<std::string> object = {};
    int count = 1;
    double scale = 1;
    std::optional<double> gap = {};  ///< none: the job's
    PartOrientations orientations = {};
    std::optional<double> unit = {};  ///< mm per unit where the file does not say; none: the job's
    double priority = 0;              ///< higher goes first
    std::string due = {};             ///< "2026-12-01": earlier goes first; empty: last
    std::string order = {};           ///< whose it is, for people
    double value = 1;                 ///< what a copy is worth: Goal::value
    std::string origin = {};          ///< where it was named, for messages ("set.csv line 7"); empty: as an argument
    std::optional<InputError> problem = {};  ///< why it cannot be used, where that is known before it is read
};

/// A mesh that is not packed, and where it stands.
struct MeshSource {
    std::string file;   ///< usable from the working directory
    std::string place;  ///< where it was named, for messages: "job.json keep_out[0]"
    /// None: the unit alone; a container is then moved to the origin.
    std::optional<Transform> transform = {};
    std::optional<double> unit = {};  ///< mm per unit where the file does not say; none: the job's
};

struct KeepOutSource {
    Box box;  ///< where there is no mesh
    std::optional<MeshSource> mesh = {};
};

struct ContainerSource {
    std::optional<MeshSource> mesh = {};  ///< none: the box of PackOptions::tray
    /// None: a vessel where the mesh holds a third of its own volume or more, else a solid. A vessel that is open at
    /// the top is physical.
    std::optional<ContainerIs> is = {};
    std::vector<KeepOutSource> keep_out = {};
    bool physical = false;  ///< walls and keep-outs are really there: copies leave over the open top alone
};

/// A copy that stands in the first tray and stays there.
struct FixedSource {
    MeshSource mesh;
    std::optional<std::string> name = {};
    std::optional<double> gap = {};  ///< none: the job's
};

/// One run of pack().
struct Job {
    std::vector<Part> parts;
    double unit = 1;  ///< millimetres per unit of meshes that do not say
    PackOptions options;
    ContainerSource container;       ///< where it is a mesh, its size takes the place of options.tray
    std::vector<FixedSource> fixed;  ///< copies that stand in the first tray and stay there
    /// Ends a search for an order (restarts, beam), whose best is then packed in; none: only pack()'s own token does.
    /// Who has one requests it whenever he requests that.
    std::optional<StopToken> enough_orders = {};
    /// Ends placing: what stands by then is still made to come apart, until pack()'s own token is requested. None: that
    /// ends all. Who has one requests it whenever he requests that.
    std::optional<StopToken> enough_placed = {};
    /// Ends the search for a better packing (PackOptions::improve), which otherwise goes on until placing ends. Who has
    /// one requests it whenever he requests that.
    std::optional<StopToken> enough_improved = {};
    std::optional<Scene> onto = {};  ///< its copies stand where they are; those placed come on top, tray by tray
    /// Its copies of the parts above stand where they are and count as placed; the others are packed around them. Parts
    /// are the same by mesh, scale and, where several are, name. What is no longer asked for is warned of and left out.
    std::optional<Scene> keep = {};
    std::vector<Printer> own_printers = {};     ///< known besides printers(): named where a part needs a larger tray
    std::vector<SettingsSource> defaults = {};  ///< where options came from that nobody said; kept for the record
};

}  // namespace spectralpack
