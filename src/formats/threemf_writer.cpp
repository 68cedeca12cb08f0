/// 3MF after the core specification 1.3: one object per mesh, one build item per copy.

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "core/atomic_file.hpp"
#include "formats/packing_file.hpp"
#include "formats/tray_row.hpp"
#include "formats/xml_text.hpp"
#include "formats/zip_archive.hpp"
#include "model/part_names.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

constexpr const char* kContentTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
 <Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
 <Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";

constexpr const char* kRelationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
 <Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

class ModelWriter {
  public:
    ModelWriter(const Packing& packing, const PartMeshes& meshes)
        : packing_(packing), meshes_(meshes), numbers_(packing.parts) {}

    std::string write() {
        out_ += R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
)";
        append(" <metadata name=\"Application\">{}</metadata>\n <resources>\n", xml_attribute(packing_.program));
        // Only what is placed: the specification wants no object that nothing refers to.
        for (const TrayPacking& tray : packing_.trays) {
            for (const Placement& placement : tray.placements) {
                write_object(static_cast<std::size_t>(placement.part));
            }
        }
        out_ += " </resources>\n <build>\n";
        for (std::size_t i = 0; i < packing_.trays.size(); ++i) {
            const double shift = tray_shift(packing_, i);
            for (const Placement& placement : packing_.trays[i].placements) {
                write_item(placement, shift);
            }
        }
        out_ += " </build>\n</model>\n";
        return std::move(out_);
    }

  private:
    template <class Format, class... Values>
    void append(const Format& format, const Values&... values) {
        fmt::format_to(std::back_inserter(out_), fmt::runtime(format), values...);
    }

    /// Items of several scales share a mesh: its name has none.
    static std::string name_of_mesh(const PackedPart& part) {
        const std::string suffix = scale_suffix(part.scale);
        return part.name.ends_with(suffix) ? part.name.substr(0, part.name.size() - suffix.size()) : part.name;
    }

    void write_object(std::size_t part_index) {
        const Mesh* mesh = meshes_.at(part_index).get();
        if (ids_.contains(mesh)) return;
        // A part that was there before a build was topped up has the mesh once more.
        const auto equal = std::ranges::find_if(written_, [&](const Mesh* other) {
            return other->vertices == mesh->vertices && other->triangles == mesh->triangles;
        });
        const auto id = static_cast<int>(equal - written_.begin()) + 1;
        ids_.emplace(mesh, id);
        if (equal != written_.end()) return;
        written_.push_back(mesh);
        const std::string name = xml_attribute(name_of_mesh(packing_.parts.at(part_index)));
        append(
            "  <object id=\"{}\" type=\"model\" name=\"{}\" partnumber=\"{}\">\n   <mesh>\n    "
            "<vertices>\n",
            id, name, name);
        for (const Vec3& v : mesh->vertices) {
            write_vertex(v);
        }
        out_ += "    </vertices>\n    <triangles>\n";
        for (const Triangle& t : mesh->triangles) {
            fmt::format_to(std::back_inserter(out_), FMT_COMPILE("     <triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n"),
                           t[0], t[1], t[2]);
        }
        out_ += "    </triangles>\n   </mesh>\n  </object>\n";
    }

    /// Shortest text that reads back as the same number: as a float where the coordinate is one.
    void write_vertex(const Vec3& v) {
        const char* open[] = {"     <vertex x=\"", "\" y=\"", "\" z=\""};
        for (int axis = 0; axis < 3; ++axis) {
            out_ += open[axis];
            const auto single = static_cast<float>(v[axis]);
            if (static_cast<double>(single) == v[axis]) {
                fmt::format_to(std::back_inserter(out_), FMT_COMPILE("{}"), single);
            } else {
                fmt::format_to(std::back_inserter(out_), FMT_COMPILE("{}"), v[axis]);
            }
        }
        out_ += "\"/>\n";
    }

    /// 3MF multiplies row vectors from the left: its matrix is the transpose of ours, translation
    /// last.
    void write_item(const Placement& placement, double shift) {
        const auto part = static_cast<std::size_t>(placement.part);
        append("  <item objectid=\"{}\" transform=\"", ids_.at(meshes_.at(part).get()));
        const Mat3 columns = transposed(placement.transform.linear);
        for (const Vec3& column : columns.rows) {
            append("{} {} {} ", column.x + 0.0, column.y + 0.0, column.z + 0.0);  // + 0: no "-0"
        }
        const Vec3& t = placement.transform.translation;
        append("{} {} {}\" partnumber=\"{} {}\"/>\n", t.x + shift, t.y + 0.0, t.z + 0.0, numbers_.of(placement),
               xml_attribute(packing_.parts.at(part).name));
    }

    const Packing& packing_;
    const PartMeshes& meshes_;
    CopyNumbers numbers_;
    std::map<const Mesh*, int> ids_;    ///< looked up only, never walked: its order is by address
    std::vector<const Mesh*> written_;  ///< by id - 1
    std::string out_;
};

}  // namespace

void write_3mf(const Packing& packing, const PartMeshes& meshes, const std::filesystem::path& path) {
    std::vector<ZipEntry> entries{{"[Content_Types].xml", kContentTypes}, {"_rels/.rels", kRelationships}};
    entries.push_back({"3D/3dmodel.model", ModelWriter(packing, meshes).write()});
    replace_file(path, make_zip(entries));
}

}  // namespace spectralpack
