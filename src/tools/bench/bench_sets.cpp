#include "tools/bench/bench_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "core/atomic_file.hpp"
#include "formats/file_bytes.hpp"
#include "spectralpack/files.hpp"
#include "tools/bench/quoted.hpp"
#include "tools/generate/segments.hpp"

namespace spectralpack::tools {
namespace {

namespace fs = std::filesystem;

struct GeneratedSize {
    GeneratedSet set;
    std::optional<int> full, quick;  ///< copies; none: as many as the set has
};

/// What generated sets are made of.
const std::map<std::string, std::vector<GeneratedSize>> kGenerated{
    {"pieces", {{GeneratedSet::pieces, {}, 200}}},
    {"mixtures", {{GeneratedSet::mixtures, {}, 120}}},
    {"locks", {{GeneratedSet::locks, {}, 100}}},
    {"tori", {{GeneratedSet::tori, {}, 12}}},
    {"polyhedra", {{GeneratedSet::polyhedra, {}, 16}}},
    {"large", {{GeneratedSet::pieces, 4000, 60}, {GeneratedSet::mixtures, 1600, 8}, {GeneratedSet::locks, 996, 10}}}};

/// Under which names a user's folder may have a set.
const std::map<std::string, std::vector<std::string>> kUsersNames{{"tori", {"tori", "tori48"}},
                                                                  {"large", {"large", "sixthousand"}}};

/// A set file of these parts, their meshes named from anywhere.
std::string set_text(const std::vector<Part>& parts) {
    std::string text = "mesh,count,scale\n";
    for (const Part& part : parts) {
        text += fmt::format("{},{},{}\n", quoted(fs::absolute(part.mesh.file()).string()), part.count, part.scale);
    }
    return text;
}

std::vector<Part> parts_of(const SetOnDisk& set) {
    ExpandedInputs inputs = expand_inputs({set.file.string()}, set.mesh_dir);
    for (const Part& part : inputs.parts) {
        if (part.problem) throw InputError(*part.problem);
    }
    return std::move(inputs.parts);
}

std::uint64_t contents_of(const SetOnDisk& set) {
    std::uint64_t hash = hash_of_file(set.file);
    std::string last;
    for (const Part& part : parts_of(set)) {
        if (part.mesh.file() != last) hash = hash_of_file(part.mesh.file(), hash);
        last = part.mesh.file();
    }
    return hash;
}

}  // namespace

std::uint64_t hash_of(std::string_view text, std::uint64_t before) {
    for (const char c : text) {
        before = (before ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    }
    return before;
}

std::uint64_t hash_of_file(const fs::path& file, std::uint64_t before) {
    return hash_of(FileBytes(file).view(), before);
}

BenchSets::BenchSets(fs::path folder, std::optional<fs::path> users, std::string mesh_dir, BenchScale scale)
    : folder_(std::move(folder)), users_(std::move(users)), mesh_dir_(std::move(mesh_dir)), scale_(scale) {
    std::error_code failure;
    fs::create_directories(folder_, failure);
    if (failure) throw ResourceError("cannot make the folder " + folder_.string() + ": " + failure.message());
}

const SetOnDisk& BenchSets::at(const std::string& name) {
    const auto known = known_.find(name);
    if (known != known_.end()) return known->second;
    const auto colon = name.find(':');
    SetOnDisk set = colon == std::string::npos
                        ? whole(name)
                        : first_copies(at(name.substr(0, colon)), name, std::stoi(name.substr(colon + 1)));
    set.contents = contents_of(set);
    return known_.emplace(name, std::move(set)).first->second;
}

SetOnDisk BenchSets::whole(const std::string& name) {
    if (!users_) return {generated(name), ""};
    const auto names = kUsersNames.find(name);
    for (const std::string& known : names == kUsersNames.end() ? std::vector{name} : names->second) {
        const fs::path file = *users_ / (known + ".csv");
        if (fs::exists(file)) return {file, mesh_dir_};
    }
    throw InputError((*users_ / (name + ".csv")).string(), "", "is not there, and the table needs it");
}

fs::path BenchSets::generated(GeneratedSet set, std::optional<int> copies) {
    const std::string name(to_string(set));
    const fs::path folder = folder_ / (copies ? fmt::format("{}-{}", name, *copies) : name);
    const fs::path file = folder / (name + ".csv");  // written last, so it is there only where all is
    if (fs::exists(file)) return file;
    return generate({set, kSeed, copies}, folder).set_file;
}

fs::path BenchSets::generated(const std::string& name) {
    if (name == kBunny || name == kMolecule) {
        return generated(GeneratedSet::segments, {}).parent_path() / (name + ".csv");
    }
    std::vector<fs::path> files;
    for (const GeneratedSize& part : kGenerated.at(name)) {
        files.push_back(generated(part.set, scale_ == BenchScale::full ? part.full : part.quick));
    }
    if (files.size() == 1) return files.front();
    std::vector<Part> parts;
    for (const fs::path& file : files) {
        const auto more = parts_of({file, ""});
        parts.insert(parts.end(), more.begin(), more.end());
    }
    const fs::path together = folder_ / (scale_ == BenchScale::full ? name + ".csv" : name + "-quick.csv");
    replace_file(together, set_text(parts));
    return together;
}

SetOnDisk BenchSets::first_copies(const SetOnDisk& all, const std::string& name, int copies) {
    std::vector<Part> first;
    for (Part& part : parts_of(all)) {
        part.count = std::min(part.count, copies);
        copies -= part.count;
        if (part.count > 0) first.push_back(std::move(part));
    }
    std::string file = name;
    std::replace(file.begin(), file.end(), ':', '-');
    const fs::path path = folder_ / ("first-" + file + ".csv");
    replace_file(path, set_text(first));
    return {path, ""};
}

fs::path BenchSets::letters() { return generated(GeneratedSet::letters, {}).parent_path(); }

}  // namespace spectralpack::tools
