#include "spectralpack/error.hpp"

#include <utility>

namespace spectralpack {
namespace {

std::string joined(const std::string& file, const std::string& place, const std::string& cause) {
    return place.empty() ? file + ": " + cause : file + ": " + place + ": " + cause;
}

}  // namespace

InputError::InputError(std::string file, std::string place, std::string cause)
    : Error(ErrorKind::input, joined(file, place, cause)),
      file_(std::move(file)),
      place_(std::move(place)),
      cause_(std::move(cause)) {}

}  // namespace spectralpack
