#include "last_resort.hpp"

#include <unistd.h>

#include <exception>
#include <new>
#include <string_view>

#include "exit_status.hpp"

namespace spectralpack::cli {
namespace {

bool main_has_begun = false;
std::terminate_handler terminate_otherwise = nullptr;

/// Needs no memory, and no library that may not have begun.
[[noreturn]] void end_saying(std::string_view message) {
    [[maybe_unused]] const auto written = write(STDERR_FILENO, message.data(), message.size());
    _exit(kOutOfResources);
}

bool lacks_memory() {
    if (!std::current_exception()) return false;
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return true;
    } catch (...) {
        return false;
    }
}

[[noreturn]] void end_for_lack_of_memory() {
    if (!main_has_begun) end_saying("spectralpack: out of memory: there is too little to begin with\n");
    if (lacks_memory()) end_saying("spectralpack: out of memory\n");
    terminate_otherwise();
    _exit(kCheckFailed);  // which that does not let happen
}

void hold_last_resort() { terminate_otherwise = std::set_terminate(end_for_lack_of_memory); }

#ifdef __GLIBC__
/// Called before the initialisers of all libraries.
[[gnu::section(".preinit_array"), gnu::used]] void (*const kBeforeAll)() = hold_last_resort;
#endif

}  // namespace

void begin_main() {
    if (!terminate_otherwise) hold_last_resort();
    main_has_begun = true;
}

}  // namespace spectralpack::cli
