#include "spectralpack/tools/generate.hpp"

#include <system_error>

#include "formats/packing_file.hpp"
#include "formats/set_file.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack::tools {

GeneratedFiles generate(const GenerateOptions& options, const std::filesystem::path& folder, const Control& control) {
    Listener quiet;
    Listener& listener = control.listener ? *control.listener : quiet;
    const std::vector<GeneratedPart> parts = generate_parts(options);
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) throw ResourceError("cannot make the folder " + folder.string() + ": " + failure.message());

    GeneratedFiles files;
    files.set_file = folder / (std::string(to_string(options.set)) + ".csv");
    std::vector<SetRow> rows;
    for (const GeneratedPart& part : parts) {
        rows.push_back({part.name + ".stl", part.count, 1, 0});
        write_stl(part.mesh, folder / rows.back().mesh);
        files.copies += part.count;
        files.volume += part.count * signed_volume(part.mesh);
        files.box_volume += part.count * bounding_box(part.mesh).volume();
        listener.on_progress({Phase::write, static_cast<std::int64_t>(rows.size()),
                              static_cast<std::int64_t>(parts.size()), 0,
                              static_cast<double>(rows.size()) / static_cast<double>(parts.size())});
    }
    files.meshes = static_cast<int>(parts.size());
    write_set(rows, files.set_file);
    return files;
}

}  // namespace spectralpack::tools
