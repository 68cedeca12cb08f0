#pragma once
/// How long work that answers nothing yet is left half done.

#include <exception>

namespace spectralpack {

/// Thrown by who sees in the midst of such work that the stop token was requested (Workers::check()). Never leaves the
/// library: whoever began the work takes it for not begun.
class Stopped : public std::exception {
  public:
    const char* what() const noexcept override { return "stopped"; }
};

}  // namespace spectralpack
