#include <pybind11/stl.h>

#include <spectralpack/check.hpp>
#include <spectralpack/names.hpp>
#include <spectralpack/plan.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "interrupting.hpp"
#include "packings.hpp"
#include "words.hpp"

namespace py = pybind11;

namespace spectralpack::python {
namespace {

/// A plan beside the tray that it is of.
struct TrayPlan {
    int tray = 0;
    std::shared_ptr<const Disassembly> plan;
};

py::array path_of(const RemovalStep& step) {
    const auto n = static_cast<py::ssize_t>(step.path.size());
    return py::array_t<double>({n, py::ssize_t{3}}, n == 0 ? nullptr : &step.path.front().x);
}

std::vector<TrayPlan> plans_in(const KeptPacking& kept) {
    std::vector<TrayPlan> plans;
    const auto& trays = kept.scene.packing.trays;
    for (std::size_t i = 0; i < trays.size(); ++i) {
        if (!trays[i].disassembly) continue;
        plans.push_back({static_cast<int>(i), std::make_shared<const Disassembly>(*trays[i].disassembly)});
    }
    return plans;
}

py::object only_plan(const KeptPacking& kept) {
    const std::vector<TrayPlan> plans = plans_in(kept);
    if (plans.empty()) return py::none();
    if (plans.size() > 1) {
        throw py::value_error("there are " + std::to_string(plans.size()) +
                              " trays, each with a plan of its own: plans");
    }
    return py::cast(plans.front());
}

std::vector<TrayPlan> make_plans(KeptPacking& kept, std::optional<double> voxel, std::optional<double> ray_spacing,
                                 const std::optional<std::string>& unpack, int threads) {
    PlanOptions options;
    options.voxel = voxel;
    options.ray_spacing = ray_spacing;
    if (unpack) options.unpack = word<Unpack>("unpack", *unpack);
    options.threads = threads;
    std::vector<Disassembly> plans;
    interruptible([&](const StopToken& stop) { plans = plan_packing(kept.scene, options, {nullptr, stop}); });
    for (std::size_t i = 0; i < plans.size(); ++i) {
        kept.scene.packing.trays[i].disassembly = std::move(plans[i]);
    }
    return plans_in(kept);
}

CheckReport check_it(const KeptPacking& kept, int threads) {
    CheckReport report;
    interruptible([&](const StopToken& stop) { report = check(kept.scene, threads, {nullptr, stop}); });
    return report;
}

std::string finding_text(const Finding& finding) {
    return "<spectralpack.Finding: " + std::string(to_string(finding.kind)) + ": " + finding.message + ">";
}

std::string report_text(const CheckReport& report) {
    if (report.ok()) return "<spectralpack.CheckReport: ok>";
    return "<spectralpack.CheckReport: " + std::to_string(report.findings.size()) + " findings" +
           (report.stopped ? ", incomplete" : "") + ">";
}

void bind_plans(py::module_& module) {
    py::class_<RemovalStep>(module, "Step", "One copy, or several as one rigid group, leave what they stand with.")
        .def_readonly("placements", &RemovalStep::placements, "Rows of Packing.placements of its tray, ascending.")
        .def_property_readonly("path", &path_of,
                               "(k, 3) float64: translations made one after the other, mm; empty where nothing is left "
                               "to get clear of.");
    py::class_<TrayPlan>(module, "Plan", "How the copies of a tray come apart by translations alone.")
        .def_readonly("tray", &TrayPlan::tray)
        .def_property_readonly(
            "complete", [](const TrayPlan& plan) { return plan.plan->complete; }, "Every copy has a way out.")
        .def_property_readonly(
            "steps", [](const TrayPlan& plan) { return plan.plan->steps; }, "In order.")
        .def_property_readonly(
            "interlocked", [](const TrayPlan& plan) { return plan.plan->interlocked; },
            "Sets of placements that hold each other.")
        .def_property_readonly(
            "unpack", [](const TrayPlan& plan) { return std::string(to_string(plan.plan->unpack)); },
            "'top': from the top down, as one digs; 'any': by any way.")
        .def_property_readonly(
            "through_walls", [](const TrayPlan& plan) { return plan.plan->through_walls; },
            "With 'top', positions in steps of those that leave through walls or keep-outs.")
        .def("__repr__", [](const TrayPlan& plan) {
            return "<spectralpack.Plan of tray " + std::to_string(plan.tray) + ": " +
                   std::to_string(plan.plan->steps.size()) + " steps" + (plan.plan->complete ? "" : ", incomplete") +
                   ">";
        });
}

void bind_reports(py::module_& module) {
    py::class_<Finding>(module, "Finding", "Something that is wrong with a packing.")
        .def_property_readonly(
            "kind", [](const Finding& finding) { return std::string(to_string(finding.kind)); },
            "outside, overlap, nested, gap, transform, density, count or plan.")
        .def_readonly("tray", &Finding::tray, "From 0; -1: of the whole packing.")
        .def_readonly("placements", &Finding::placements, "In the tray: the copies that it is about.")
        .def_readonly("amount", &Finding::amount, "mm of penetration, of missing gap, of sticking out.")
        .def_readonly("message", &Finding::message)
        .def("__repr__", &finding_text);
    py::class_<CheckReport>(module, "CheckReport", "What the judge says of a packing.")
        .def_property_readonly("ok", &CheckReport::ok, "Nothing is wrong.")
        .def_property_readonly("comes_apart", &CheckReport::plans_complete,
                               "Every tray has a plan that takes out all that is not fixed.")
        .def_readonly("findings", &CheckReport::findings)
        .def_readonly("min_gap", &CheckReport::min_gap, "Least distance between two copies of a tray, mm.")
        .def_readonly("density", &CheckReport::density, "As measured, of each tray.")
        .def_readonly("stopped", &CheckReport::stopped, "Ended early: it is incomplete.")
        .def("__bool__", &CheckReport::ok)
        .def("__repr__", &report_text);
}

}  // namespace

void bind_judging(py::module_& module) {
    bind_plans(module);
    bind_reports(module);
    auto packing =
        py::reinterpret_borrow<py::class_<KeptPacking, std::shared_ptr<KeptPacking>>>(module.attr("Packing"));
    packing
        .def("check", &check_it, py::arg("threads") = 0,
             R"(Judges it from its meshes alone: containment, overlap, gaps, transforms, counts, stated figures; a plan
is replayed by exact sweeps. Shares no code with what packed it. True where nothing is wrong.)")
        .def_property_readonly("plans", &plans_in, "A Plan for each tray that has one.")
        .def_property_readonly("plan", &only_plan, "The plan of the only tray; None where there is none.")
        .def("make_plans", &make_plans, py::kw_only(), py::arg("voxel") = py::none(),
             py::arg("ray_spacing") = py::none(), py::arg("unpack") = py::none(), py::arg("threads") = 0,
             R"(Makes a plan for each tray anew, keeps them in the packing and returns them.

`voxel`: of the flood fill, mm, where it is not that of the packing; `ray_spacing`: mm between the rays that tell which
copy is straight in whose way; `unpack`: 'top' or 'any'.)");
}

}  // namespace spectralpack::python
