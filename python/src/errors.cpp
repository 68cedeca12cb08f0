#include "errors.hpp"

#include <string>

#include "bindings.hpp"

namespace py = pybind11;

namespace spectralpack::python {
namespace {

const char* class_of(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::usage:
            return "UsageError";
        case ErrorKind::input:
            return "InputError";
        case ErrorKind::resource:
            return "ResourceError";
        case ErrorKind::internal:
            return "InternalError";
    }
    return "Error";
}

void set_raised(const py::object& exception) {
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(exception.ptr())), exception.ptr());
}

py::object core() { return py::module_::import("spectralpack._core"); }

void translate(std::exception_ptr pointer) {
    try {
        if (pointer) std::rethrow_exception(pointer);
    } catch (const Error& error) {
        set_raised(exception_of(error));
    }
}

}  // namespace

py::object exception_of(const Error& error) {
    py::object exception = core().attr(class_of(error.kind()))(error.what());
    if (const auto* input = dynamic_cast<const InputError*>(&error)) {
        exception.attr("file") = input->file();
        exception.attr("place") = input->place();
        exception.attr("cause") = input->cause();
    }
    return exception;
}

void raise(const py::object& exception) {
    set_raised(exception);
    throw py::error_already_set();
}

void bind_errors(py::module_& module) {
    const auto make = [&](const char* name, const py::tuple& bases, const char* doc) {
        py::dict members;
        members["__doc__"] = doc;
        members["__module__"] = "spectralpack";
        const py::object type = py::reinterpret_borrow<py::object>(reinterpret_cast<PyObject*>(&PyType_Type));
        module.attr(name) = type(name, bases, members);
        return py::object(module.attr(name));
    };
    const auto built_in = [](PyObject* type) { return py::reinterpret_borrow<py::object>(type); };
    const py::object error = make("Error", py::make_tuple(built_in(PyExc_Exception)),
                                  "What the packer raises. The message is meant for users.");
    make("UsageError", py::make_tuple(error, built_in(PyExc_ValueError)), "An option or argument makes no sense.");
    make("InputError", py::make_tuple(error, built_in(PyExc_ValueError)),
         "A mesh or file cannot be used: `file`, `place` in it ('line 7'; may be empty) and `cause`.");
    make("ResourceError", py::make_tuple(error, built_in(PyExc_MemoryError)), "Out of memory or disk.");
    make("InternalError", py::make_tuple(error, built_in(PyExc_RuntimeError)),
         "A bug of the packer's own, for example two engines that disagree.");
    make("Remark", py::make_tuple(built_in(PyExc_UserWarning)), "Something to know that stops nothing.");
    py::register_exception_translator(translate);
}

}  // namespace spectralpack::python
