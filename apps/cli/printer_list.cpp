#include "printer_list.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "text.hpp"

namespace spectralpack::cli {

void print_printers(std::span<const Printer> own, bool json) {
    std::vector<Printer> all(own.begin(), own.end());
    for (const Printer& printer : printers()) {
        const bool replaced = std::ranges::find(all, printer.name, &Printer::name) != all.end();
        if (!replaced) all.push_back(printer);
    }
    if (json) {
        fmt::print("{}", printers_json(all));
        return;
    }
    for (const Printer& printer : all) {
        const Vec3& s = printer.size;
        fmt::print("{:<16} {:<32} {:g}x{:g}x{:g} mm, gap {:g}, walls {:g}, floor {:g} mm\n", printable(printer.name),
                   printable(printer.title), s.x, s.y, s.z, printer.gap, printer.wall, printer.floor);
        if (printer.source.empty()) continue;
        fmt::print("{:<16} size{}: {}\n", "", printer.verified ? "" : " (UNVERIFIED)", printable(printer.source));
    }
    fmt::print(
        "Gaps and clearances are customary starting values, not the makers' word (UNVERIFIED): yours depend on\n"
        "material and machine. --tray, --gap and --wall-gap override them.\n");
}

}  // namespace spectralpack::cli
