#pragma once
/// What a folder holds that is named as an input.

#include <string>
#include <vector>

#include "spectralpack/error.hpp"

namespace spectralpack {

struct FolderInputs {
    std::vector<std::string> meshes;
    std::vector<InputError> unusable;
    std::vector<std::string> passed_over;  ///< files that are no meshes; hidden ones are not told
    std::vector<std::string> own_builds;   ///< 3MF files that this program wrote
};

/// Of the folder and of those in it, hidden ones aside; sorted bytewise.
FolderInputs inputs_in(const std::string& folder);

}  // namespace spectralpack
