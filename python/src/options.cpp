#include "options.hpp"

#include <pybind11/stl.h>

#include <algorithm>

#include <spectralpack/error.hpp>
#include <spectralpack/option_table.hpp>
#include <spectralpack/typed_text.hpp>

#include "arrays.hpp"
#include "packings.hpp"

namespace py = pybind11;

namespace spectralpack::python {
namespace {

std::string table_name(const std::string& name) {
    std::string result = name;
    std::replace(result.begin(), result.end(), '_', '-');
    return result;
}

const Option* find(const std::string& name) {
    const Option* option = find_option(table_name(name));
    return option && option->in_pack.set ? option : nullptr;
}

[[noreturn]] void refuse(const std::string& name, const Option& option, const py::handle& value) {
    throw UsageError(name + " takes " + values_of(option) + "; not " + py::repr(value).cast<std::string>());
}

template <class Value>
Value number_of(const std::string& name, const Option& option, const py::handle& value) {
    // True is no 1, and 2.0 is a whole number as numpy makes them.
    const bool is_number = !PyBool_Check(value.ptr()) && PyNumber_Check(value.ptr());
    if (!is_number) refuse(name, option, value);
    try {
        if constexpr (std::is_same_v<Value, double>) {
            return py::float_(py::reinterpret_borrow<py::object>(value)).cast<double>();
        } else {
            return py::int_(value.attr("__index__")()).cast<Value>();
        }
    } catch (const std::exception&) {
        PyErr_Clear();
        refuse(name, option, value);
    }
}

Vec3 size_of(const std::string& name, const Option& option, const py::handle& value) {
    if (!py::isinstance<py::sequence>(value) && !py::isinstance<py::array>(value)) refuse(name, option, value);
    std::vector<double> sides;
    try {
        sides = value.cast<std::vector<double>>();
    } catch (const py::cast_error&) {
        refuse(name, option, value);
    }
    if (sides.size() != 2 && sides.size() != 3) refuse(name, option, value);
    return {sides[0], sides[1], sides.size() == 3 ? sides[2] : 0};
}

OptionValue value_of(const std::string& name, const Option& option, const py::handle& value) {
    if (value.is_none()) return std::monostate{};
    if (py::isinstance<py::str>(value)) return parse_value(option, value.cast<std::string>());
    switch (option.type) {
        case OptionType::flag:
            if (!PyBool_Check(value.ptr())) refuse(name, option, value);
            return value.cast<bool>();
        case OptionType::integer:
        case OptionType::bytes:
            return number_of<std::int64_t>(name, option, value);
        case OptionType::natural:
            return number_of<std::uint64_t>(name, option, value);
        case OptionType::number:
            return number_of<double>(name, option, value);
        case OptionType::size:
            return size_of(name, option, value);
        case OptionType::rotations:
            return parse_value(option, py::str(value).cast<std::string>());
        default:
            refuse(name, option, value);
    }
}

py::object object_of(const OptionValue& value) {
    return std::visit(
        [](const auto& one) -> py::object {
            using Value = std::decay_t<decltype(one)>;
            if constexpr (std::is_same_v<Value, std::monostate>) {
                return py::none();
            } else if constexpr (std::is_same_v<Value, Vec3>) {
                return tuple_of(one);
            } else {
                return py::cast(one);
            }
        },
        value);
}

}  // namespace

void set_option(PackOptions& options, const std::string& name, const py::handle& value) {
    const Option* const option = find(name);
    if (!option) {
        std::vector<std::string> names;
        for (const Option& known : option_table()) {
            if (known.in_pack.set) names.push_back(python_name(known.name));
        }
        const std::optional<std::string> meant = nearest_word(name, names);
        throw py::type_error("there is no option '" + name + "'" + (meant ? "; '" + *meant + "' is one" : ""));
    }
    const OptionValue wanted = value_of(name, *option, value);
    if (!accepts(*option, wanted)) refuse(name, *option, value);
    option->in_pack.set(options, wanted);
}

py::object get_option(const PackOptions& options, const std::string& name) {
    const Option* const option = find(name);
    if (!option) throw py::attribute_error("there is no option '" + name + "'");
    return object_of(option->in_pack.get(options));
}

py::dict options_dict(const PackOptions& options) {
    py::dict result;
    for (const Option& option : option_table()) {
        if (option.in_pack.get) result[python_name(option.name).c_str()] = object_of(option.in_pack.get(options));
    }
    return result;
}

}  // namespace spectralpack::python
