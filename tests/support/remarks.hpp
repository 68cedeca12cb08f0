#pragma once
/// Remarks as text, for names() and any_names().

#include <string>
#include <vector>

#include "core/remarks.hpp"

namespace spectralpack::test {

inline std::vector<std::string> texts_of(const std::vector<Remark>& remarks) {
    std::vector<std::string> texts;
    for (const Remark& remark : remarks) {
        texts.push_back(remark.one);
    }
    return texts;
}

}  // namespace spectralpack::test
