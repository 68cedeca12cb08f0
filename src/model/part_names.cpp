#include "model/part_names.hpp"

#include <cstdio>
#include <filesystem>
#include <map>
#include <set>

namespace spectralpack {
namespace {

/// The name and what can be put before it, nearest first.
std::vector<std::string> steps_of(const NameSource& source) {
    std::vector<std::string> steps{source.name};
    if (source.of_the_user || source.file.empty()) return steps;
    const std::filesystem::path path = std::filesystem::path(source.file).lexically_normal();
    if (source.of_object) steps.push_back(path.stem().string());
    const std::filesystem::path folder = path.parent_path();
    std::vector<std::string> folders;
    for (const std::filesystem::path& step : folder.relative_path()) {
        folders.push_back(step.string());
    }
    steps.insert(steps.end(), folders.rbegin(), folders.rend());
    return steps;
}

std::string joined(const std::vector<std::string>& steps, std::size_t taken) {
    std::string name = steps.front();
    for (std::size_t i = 1; i < taken; ++i) {
        name = steps[i] + "/" + name;
    }
    return name;
}

}  // namespace

std::vector<std::string> names_apart(const std::vector<NameSource>& sources) {
    std::vector<std::vector<std::string>> steps;
    for (const NameSource& source : sources) {
        steps.push_back(steps_of(source));
    }
    std::vector<std::size_t> taken(sources.size(), 1);
    std::vector<std::string> names(sources.size());
    std::map<std::string, std::set<std::string>> files;  // by name
    const auto name_all = [&] {
        files.clear();
        for (std::size_t i = 0; i < sources.size(); ++i) {
            names[i] = joined(steps[i], taken[i]);
            files[names[i]].insert(std::filesystem::path(sources[i].file).lexically_normal().string());
        }
    };
    const auto shared = [&](std::size_t i) { return !sources[i].of_the_user && files.at(names[i]).size() > 1; };
    for (bool changed = true; changed;) {
        name_all();
        changed = false;
        for (std::size_t i = 0; i < sources.size(); ++i) {
            if (!shared(i) || taken[i] == steps[i].size()) continue;
            ++taken[i];
            changed = true;
        }
    }
    std::vector<std::string> endings(sources.size());  // of files that have nothing else of their own
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (shared(i) && taken[i] == steps[i].size())
            endings[i] = std::filesystem::path(sources[i].file).extension().string();
    }
    std::map<std::string, std::set<double>> scales;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        names[i] += endings[i];
        scales[names[i]].insert(sources[i].scale);
    }
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const bool several = scales.at(names[i]).size() > 1;
        if (several && !sources[i].of_the_user) names[i] += scale_suffix(sources[i].scale);
    }
    return names;
}

std::string scale_suffix(double scale) {
    if (scale == 1) return "";
    char text[40];
    std::snprintf(text, sizeof text, " x %g", scale);
    return text;
}

}  // namespace spectralpack
