#pragma once
/// Names that tell parts apart.

#include <string>
#include <vector>

namespace spectralpack {

/// What a part's name is made of: the mesh's own name, or what the user calls it.
struct NameSource {
    std::string name;          ///< of the mesh: its file without ending, or its object in a 3MF
    std::string file;          ///< empty for a mesh in memory
    bool of_object = false;    ///< `name` is an object's and not the file's
    bool of_the_user = false;  ///< `name` is said by a person: it stays
    double scale = 1;
};

/// A name for each. Where parts of different files share one, so many of their folders are put before it as tell them
/// apart ("left/bracket", "right/bracket"), and before an object's the name of its file; files that differ in their
/// endings alone show those; where a mesh is there at several scales, they follow ("bracket x 1.02").
std::vector<std::string> names_apart(const std::vector<NameSource>& sources);

/// " x 1.02", as it stands after a part's name; empty for 1.
std::string scale_suffix(double scale);

}  // namespace spectralpack
