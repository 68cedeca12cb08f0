#pragma once
/// The parts of the extension module spectralpack._core. Each adds its classes and functions to it; later ones use the
/// classes of earlier ones. All of it stands on the public headers alone.

#include <pybind11/pybind11.h>

namespace spectralpack::python {

void bind_errors(pybind11::module_& module);
void bind_meshes(pybind11::module_& module);
void bind_packings(pybind11::module_& module);
void bind_judging(pybind11::module_& module);
void bind_jobs(pybind11::module_& module);
void bind_runs(pybind11::module_& module);
void bind_laboratory(pybind11::module_& module);
void bind_tools(pybind11::module_& module);

}  // namespace spectralpack::python
