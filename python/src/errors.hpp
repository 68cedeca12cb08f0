#pragma once
/// Errors of the library as Python exceptions: Error and one class for each ErrorKind, of which each is also the
/// built-in one that fits.

#include <pybind11/pybind11.h>

#include <spectralpack/error.hpp>

namespace spectralpack::python {

/// The exception that tells of `error`, to be raised or kept. An InputError has file, place and cause.
pybind11::object exception_of(const Error& error);

/// Raises it in the calling Python code.
[[noreturn]] void raise(const pybind11::object& exception);

}  // namespace spectralpack::python
