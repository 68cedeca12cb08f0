#include "core/remarks.hpp"

#include <algorithm>

namespace spectralpack {
namespace {

constexpr std::size_t kMostNamed = 6;

}  // namespace

void Remarks::add(const std::string& name, const Remark& remark) {
    const auto known = std::find_if(causes_.begin(), causes_.end(),
                                    [&](const Cause& cause) { return cause.first.many == remark.many; });
    if (known == causes_.end()) {
        causes_.push_back({remark, {name}});
    } else {
        known->names.push_back(name);
    }
}

std::vector<std::string> Remarks::texts() const {
    std::vector<std::string> texts;
    for (const auto& [first, names] : causes_) {
        if (names.size() == 1) {
            texts.push_back(names.front() + " " + first.one);
        } else {
            texts.push_back(std::to_string(names.size()) + " parts " + first.many + ": " + listed(names, kMostNamed));
        }
    }
    return texts;
}

std::string listed(const std::vector<std::string>& names, std::size_t most) {
    // One more name is no longer than "and 1 more".
    const std::size_t shown = names.size() <= most + 1 ? names.size() : most;
    std::string text;
    for (std::size_t i = 0; i < shown; ++i) {
        text += (text.empty() ? "" : ", ") + names[i];
    }
    if (names.size() > shown) text += " and " + std::to_string(names.size() - shown) + " more";
    return text;
}

}  // namespace spectralpack
