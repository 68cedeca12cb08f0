#pragma once
/// A packing as Python holds it.

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include <spectralpack/error.hpp>
#include <spectralpack/packing.hpp>
#include <spectralpack/stop.hpp>

namespace spectralpack::python {

/// Values in it do not change once Python has it, but for plans that are made later.
struct KeptPacking {
    Scene scene;
    StopReason stopped = StopReason::none;
    std::vector<InputError> unusable = {};
};

/// "wall-gap" is wall_gap in Python.
std::string python_name(std::string_view option);

}  // namespace spectralpack::python
