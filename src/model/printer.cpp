#include "spectralpack/printers.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

#include "spectralpack/typed_text.hpp"

namespace spectralpack {
namespace {

constexpr const char* kXometry = "Xometry, HP Multi Jet Fusion design guidelines: maximum build volume";
constexpr const char* kExaparts = "exaparts.ch, design guidelines (Formiga P110): available space";
constexpr const char* kSinterit = "Sinterit, sinterit.com/blog/sls-technology/print-with-1kg-pa12: print volume";
constexpr const char* kPaper = "Cui et al. 2023, section 5: the tray of the experiments";
constexpr const char* kMaker = "maker's data sheet, from memory";

const std::array<Printer, 10>& known_printers() {
    static const std::array<Printer, 10> printers{{
        {"paper", "tray of the SIGGRAPH 2023 paper", {480, 245, 200}, 0, 0, 0, kPaper, true},
        {"hp-mjf-5200", "HP Jet Fusion 4200, 5200", {380, 284, 380}, 2, 5, 5, kXometry, true},
        {"hp-mjf-580", "HP Jet Fusion 540, 580", {332, 190, 248}, 2, 5, 5, kMaker},
        {"eos-p110", "EOS Formiga P 110", {190, 240, 300}, 2, 0, 5, kExaparts, true},
        {"eos-p396", "EOS P 396", {340, 340, 600}, 2, 5, 5, kMaker},
        {"eos-p770", "EOS P 770", {700, 380, 580}, 2, 5, 5, kMaker},
        {"formlabs-fuse1", "Formlabs Fuse 1, Fuse 1+", {165, 165, 300}, 2, 3, 3, kMaker},
        {"sinterit-lisa-x", "Sinterit Lisa X", {130, 180, 330}, 2, 3, 3, kSinterit, true},
        {"stratasys-h350", "Stratasys H350", {315, 208, 293}, 2, 5, 5, kMaker},
        {"inkbit-vista", "Inkbit Vista", {500, 250, 200}, 1, 1, 1, kMaker},
    }};
    return printers;
}

}  // namespace

std::span<const Printer> printers() { return known_printers(); }

const Printer* find_printer(std::string_view name, std::span<const Printer> own) {
    const std::string wanted = lower_case(std::string(name));
    for (const std::span<const Printer> list : {own, printers()}) {
        const auto found =
            std::ranges::find_if(list, [&](const Printer& printer) { return lower_case(printer.name) == wanted; });
        if (found != list.end()) return &*found;
    }
    return nullptr;
}

void apply(const Printer& printer, PackOptions& options) {
    options.tray = printer.size;
    options.gap = printer.gap;
    options.wall_gap = printer.wall_gap();
    options.printer = printer.name;
}

std::vector<std::string> set_by_printer() { return {"printer", "tray", "gap", "wall-gap"}; }

}  // namespace spectralpack
