#include "spectralpack/generate.hpp"

#include <system_error>

#include "formats/packing_file.hpp"
#include "formats/set_file.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

constexpr int kMaxCopies = 10'000'000;

}  // namespace

GeneratedFiles generate(const GenerateOptions& options, const std::filesystem::path& folder, Listener& listener) {
    if (options.copies && options.set == GeneratedSet::letters) {
        throw UsageError("letters are always the same seven containers: they take no number of copies");
    }
    if (options.copies && (*options.copies < 1 || *options.copies > kMaxCopies)) {
        throw UsageError("the number of copies must be from 1 to 10000000");
    }
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) throw ResourceError("cannot make the folder " + folder.string() + ": " + failure.message());

    const std::vector<GeneratedPart> parts = generate_parts(options.set, options.seed, options.copies);
    GeneratedFiles files;
    files.set_file = folder / (std::string(generated_set_name(options.set)) + ".csv");
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

const char* generated_set_name(GeneratedSet set) {
    switch (set) {
        case GeneratedSet::pieces:
            return "pieces";
        case GeneratedSet::mixtures:
            return "mixtures";
        case GeneratedSet::locks:
            return "locks";
        case GeneratedSet::tori:
            return "tori";
        case GeneratedSet::polyhedra:
            return "polyhedra";
        case GeneratedSet::letters:
            return "letters";
    }
    return "";
}

}  // namespace spectralpack
