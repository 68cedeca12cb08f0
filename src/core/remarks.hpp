#pragma once
/// Remarks on parts: what is so is said once, however many parts it is so of.

#include <string>
#include <vector>

namespace spectralpack {

struct Remark {
    std::string one;   ///< follows the name of one part: "has holes (12 border edges)"
    std::string many;  ///< follows "3 parts": "have holes"; remarks of one cause have one text here

    bool operator==(const Remark&) const = default;
};

class Remarks {
  public:
    void add(const std::string& name, const Remark& remark);

    /// In the order in which the causes came up: "bracket has holes (12 border edges)", "3 parts have holes: bracket,
    /// cup and lid"; of many parts the first few are named.
    std::vector<std::string> texts() const;

  private:
    struct Cause {
        Remark first;
        std::vector<std::string> names;
    };
    std::vector<Cause> causes_;
};

/// "a, b, c"; the first `most` and "and 7 more".
std::string listed(const std::vector<std::string>& names, std::size_t most);

}  // namespace spectralpack
