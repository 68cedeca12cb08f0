#pragma once
/// The option table in Python: options by name, with the words, numbers and sizes that job files take.

#include <pybind11/pybind11.h>

#include <string>

#include <spectralpack/options.hpp>

namespace spectralpack::python {

/// Sets `name` ("wall_gap") from a Python value: what a job file may say of it, or text as on the command line; None
/// sets what stands for none. Throws TypeError for a name that is no option of packing, UsageError for a value that the
/// option does not take.
void set_option(PackOptions& options, const std::string& name, const pybind11::handle& value);

/// Throws AttributeError where there is no such option.
pybind11::object get_option(const PackOptions& options, const std::string& name);

/// All of them, by name.
pybind11::dict options_dict(const PackOptions& options);

}  // namespace spectralpack::python
