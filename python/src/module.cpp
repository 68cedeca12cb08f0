#include "bindings.hpp"

PYBIND11_MODULE(_core, module) {
    using namespace spectralpack::python;
    module.doc() = "The packer, as spectralpack/__init__.py shows it.";
    module.attr("__version__") = SPECTRALPACK_VERSION;
    bind_errors(module);
    bind_meshes(module);
    bind_packings(module);
    bind_judging(module);
    bind_jobs(module);
    bind_runs(module);
    bind_laboratory(module);
    bind_tools(module);
}
