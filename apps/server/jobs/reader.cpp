#include "jobs/reader.hpp"

#include <cstring>
#include <set>
#include <sstream>

#include "children/mesh_record.hpp"
#include "jobs/names.hpp"
#include "jobs/refusal.hpp"

namespace spectralpack::server {
namespace {

constexpr std::size_t kFilesAtOnce = 32;

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
    std::uint32_t number = 0;
    std::memcpy(&number, bytes.data() + at, sizeof(number));
    return number;
}

/// The ids in "0,3".
std::set<std::uint32_t> ids_in(const std::string& text) {
    std::set<std::uint32_t> ids;
    std::istringstream list(text);
    for (std::string one; std::getline(list, one, ',');) {
        if (one.empty() || one.size() > 9 || one.find_first_not_of("0123456789") != std::string::npos) {
            throw Refusal(kBadRequest, "ids: numbers with commas between them are wanted");
        }
        ids.insert(static_cast<std::uint32_t>(std::stoul(one)));
    }
    return ids;
}

Json missing_of(const Json& rows, const Job& job) {
    std::set<std::string> missing;
    for (const Json& row : rows) {
        const std::string mesh = row.at("mesh").get<std::string>();
        if (!job.files.contains(mesh)) missing.insert(mesh);
    }
    return missing;
}

}  // namespace

void Reader::read(Job& job) {
    for (auto& [name, file] : job.files) {
        file.reading = !std::filesystem::exists(job.folder.preview(name));
    }
    if (!busy_[job.id]) start(job.id);
}

void Reader::start(const std::string& id) {
    busy_.erase(id);
    if (!jobs_.contains(id)) return;
    Job& job = jobs_.at(id);
    std::vector<std::string> arguments{"read"}, names;
    for (const auto& [name, file] : job.files) {
        if (!file.reading || names.size() == kFilesAtOnce) continue;
        names.push_back(name);
        arguments.insert(arguments.end(), {std::to_string(file.number), name});
    }
    if (names.empty()) return;
    busy_[id] = true;
    tasks_.start(tasks_.child(std::move(arguments), job.folder.root), [this, id, names](Ending ending) {
        if (!jobs_.contains(id)) return;
        Job& read = jobs_.at(id);
        bool blamed = ending.status == 0;
        for (const std::string& name : names) {
            const auto file = read.files.find(name);
            if (file == read.files.end()) continue;
            const bool known = std::filesystem::exists(read.folder.preview(name));
            if (!known && !blamed) {
                // The first that was not done is the one that the process ended at; those behind it are read again.
                write_text(read.folder.preview(name),
                           Json{{"error", ending.signal == 0 ? "it takes more memory to read than one file may"
                                                             : "reading it took too long or failed"},
                                {"place", nullptr}}
                               .dump());
                blamed = true;
                file->second.reading = false;
                continue;
            }
            file->second.reading = !known;
        }
        ++read.change;
        start(id);
    });
}

Json parts_json(const Job& job) {
    Json meshes = Json::array(), bad = Json::array(), sets = Json::array();
    int reading = 0;
    for (const auto& [name, file] : job.files) {
        const std::optional<Json> found = read_json(job.folder.preview(name));
        if (!found) {
            ++reading;
        } else if (found->contains("meshes")) {
            for (const Json& mesh : found->at("meshes")) {
                meshes.push_back(mesh);
            }
        } else if (found->contains("error")) {
            bad.push_back({{"file", name}, {"error", found->at("error")}, {"place", found->at("place")}});
        } else {
            Json set{{"file", name}};
            set.update(*found);
            set["missing"] = missing_of(found->at("rows"), job);
            sets.push_back(std::move(set));
        }
    }
    return {{"reading", reading}, {"meshes", meshes}, {"bad", bad}, {"sets", sets}};
}

std::string mesh_bundle(const Job& job, const std::string& detail, const std::string& ids) {
    const std::set<std::uint32_t> wanted = ids_in(ids);
    std::uint32_t count = 0;
    std::string records;
    for (const auto& [name, file] : job.files) {
        auto found = read_text(job.folder.meshes(name, detail));
        if (!found) found = read_text(job.folder.meshes(name, "coarse"));  // read by a version without `rough`
        if (!found) continue;
        for (std::size_t at = 0; at + 12 <= found->size();) {
            const std::uint64_t bytes = record_bytes(number_at(*found, at + 4), number_at(*found, at + 8));
            if (wanted.empty() || wanted.contains(number_at(*found, at))) {
                records.append(*found, at, bytes);
                ++count;
            }
            at += bytes;
        }
    }
    std::string bundle = "SPMB";
    for (const std::uint32_t number : {kBundleVersion, count}) {
        bundle.append(reinterpret_cast<const char*>(&number), sizeof(number));
    }
    return bundle + records;
}

}  // namespace spectralpack::server
