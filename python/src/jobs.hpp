#pragma once
/// A job as Python builds it up.

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include <spectralpack/job.hpp>

#include "packings.hpp"

namespace spectralpack::python {

struct KeptJob {
    Job job;
    std::vector<std::string> remarks = {};  ///< of files that it was read from
};

}  // namespace spectralpack::python
