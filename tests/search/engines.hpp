#pragma once
/// The engines that this build has. One suite runs all of them (engine_test.cpp,
/// equivariance_test.cpp).

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "search/placement_search.hpp"

namespace spectralpack::test {

struct EngineFactory {
    std::string name;  ///< letters and digits: part of a test's name
    std::function<std::unique_ptr<PlacementSearch>(const Workers&)> make;
};

inline std::ostream& operator<<(std::ostream& out, const EngineFactory& factory) { return out << factory.name; }

std::vector<EngineFactory> engines();

}  // namespace spectralpack::test
