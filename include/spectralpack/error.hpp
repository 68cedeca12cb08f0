#pragma once
/// Errors with messages meant for the user. Ordinary outcomes ("no position is free") are values, never
/// exceptions; what is thrown here is a broken precondition, unusable input or a lack of resources.

#include <stdexcept>
#include <string>

namespace spectralpack {

enum class ErrorKind {
    usage,     ///< an option or argument makes no sense (exit status 2)
    input,     ///< a named input is unusable (3)
    resource,  ///< out of memory or disk (4)
    internal,  ///< a bug of ours, for example two engines that disagree (1)
};

class Error : public std::runtime_error {
  public:
    Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
    ErrorKind kind() const { return kind_; }

  private:
    ErrorKind kind_;
};

struct UsageError : Error {
    explicit UsageError(const std::string& message) : Error(ErrorKind::usage, message) {}
};

/// Unusable input: which file, where in it ("line 7", "byte 84", "object 3"; may be empty), and why.
class InputError : public Error {
  public:
    InputError(std::string file, std::string place, std::string cause);

    const std::string& file() const { return file_; }
    const std::string& place() const { return place_; }
    const std::string& cause() const { return cause_; }

  private:
    std::string file_, place_, cause_;
};

struct ResourceError : Error {
    explicit ResourceError(const std::string& message) : Error(ErrorKind::resource, message) {}
};

struct InternalError : Error {
    explicit InternalError(const std::string& message) : Error(ErrorKind::internal, message) {}
};

}  // namespace spectralpack
