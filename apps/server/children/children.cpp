#include "children/children.hpp"

#include <cstdio>
#include <functional>
#include <map>
#include <new>

#include <spectralpack/error.hpp>

namespace spectralpack::server {
namespace {

constexpr int kUsageStatus = 2, kInputStatus = 3, kRoomStatus = 4, kBrokenStatus = 1;

int status_of(ErrorKind kind) {
    return kind == ErrorKind::usage      ? kUsageStatus
           : kind == ErrorKind::input    ? kInputStatus
           : kind == ErrorKind::resource ? kRoomStatus
                                         : kBrokenStatus;
}

}  // namespace

int run_child(const std::vector<std::string>& arguments) {
    using Child = int (*)(const std::vector<std::string>&);
    static const std::map<std::string, Child> children{
        {"run", pack_job},          {"judge", judge_packing},       {"read", read_files},
        {"export", export_packing}, {"clearance", print_clearance}, {"change", change_packing},
        {"import", import_packing}};
    const auto child = arguments.empty() ? children.end() : children.find(arguments.front());
    if (child == children.end()) return kUsageStatus;
    try {
        return child->second({arguments.begin() + 1, arguments.end()});
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return status_of(error.kind());
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "out of memory\n");
        return kRoomStatus;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return kBrokenStatus;
    }
}

}  // namespace spectralpack::server
