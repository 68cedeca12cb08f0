#pragma once
/// Exit statuses of the command line (docs/conventions.md).

#include <spectralpack/error.hpp>

namespace spectralpack::cli {

enum ExitStatus : int {
    kDone = 0,
    kCheckFailed = 1,
    kUsage = 2,
    kUnusableInput = 3,
    kOutOfResources = 4,
    kLeftOver = 5,
    kNothingPlaced = 6,
    kInterrupted = 130,
};

constexpr int status_of(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::usage:
            return kUsage;
        case ErrorKind::input:
            return kUnusableInput;
        case ErrorKind::resource:
            return kOutOfResources;
        case ErrorKind::internal:
            return kCheckFailed;
    }
    return kCheckFailed;
}

}  // namespace spectralpack::cli
