#pragma once
/// Exit statuses of the command line (docs/conventions.md).

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

}  // namespace spectralpack::cli
