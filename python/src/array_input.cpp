#include "array_input.hpp"

#include <cstring>
#include <limits>
#include <string>
#include <string_view>

namespace groundgrid::python {
namespace {

nb::object numpy(const char* function) { return nb::module_::import_("numpy").attr(function); }

[[noreturn]] void reject_type(const char* name, const char* expected, nb::handle array) {
  throw nb::type_error((std::string(name) + ": expected an array of " + expected + ", got " +
                        description_of(array).c_str())
                           .c_str());
}

/// The array itself, or what it says it is as an array.
nb::object as_array(nb::handle array, const char* name) {
  if (PyObject_CheckBuffer(array.ptr()) == 0 && !nb::hasattr(array, "__array__"))
    reject_type(name, "numbers", array);
  return numpy("asarray")(array);
}

std::string kind_of(nb::handle array) {
  return nb::cast<nb::str>(array.attr("dtype").attr("kind")).c_str();
}

void require_labels(nb::handle array, const char* name) {
  if (nb::cast<std::size_t>(array.attr("size")) == 0) return;
  const nb::object least = nb::int_(array.attr("min")());
  const nb::object greatest = nb::int_(array.attr("max")());
  if (least < nb::int_(0) || greatest > nb::int_(std::numeric_limits<std::uint32_t>::max()))
    throw nb::value_error((std::string(name) + ": expected labels from 0 to 4294967295").c_str());
}

}  // namespace

PackedArray PackedArray::floats(nb::handle array, const char* name) {
  const nb::object numbers = as_array(array, name);
  const std::string kind = kind_of(numbers);
  if (kind != "f" && kind != "i" && kind != "u" && kind != "b")
    reject_type(name, "numbers", numbers);
  return PackedArray(HeldBuffer(numpy("require")(numbers, "float32", "CA"), name));
}

PackedArray PackedArray::labels(nb::handle array, const char* name) {
  const nb::object numbers = as_array(array, name);
  const std::string kind = kind_of(numbers);
  if (kind != "i" && kind != "u") reject_type(name, "integers", numbers);
  require_labels(numbers, name);
  return PackedArray(HeldBuffer(numpy("require")(numbers, "uint32", "CA"), name));
}

std::size_t PackedArray::size() const {
  std::size_t size = 1;
  for (int i = 0; i < dimensions(); ++i) size *= length(i);
  return size;
}

Eigen::Isometry3d transform_from(nb::handle array, const char* name) {
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  if (array.is_none()) return transform;
  nb::object numbers;
  try {
    numbers = numpy("asarray")(array);
    const std::string kind = kind_of(numbers);
    if (kind != "f" && kind != "i" && kind != "u") reject_type(name, "4 × 4 numbers", array);
    numbers = numpy("require")(numbers, "float64", "CA");
  } catch (const nb::python_error& error) {
    if (!error.matches(PyExc_TypeError) && !error.matches(PyExc_ValueError)) throw;
    reject_type(name, "4 × 4 numbers", array);
  }
  const HeldBuffer buffer(numbers, name);
  if (buffer.dimensions() != 2 || buffer.length(1) != 4 ||
      (buffer.length(0) != 4 && buffer.length(0) != 3))
    throw nb::value_error((std::string(name) + ": expected 4 × 4 or 3 × 4 numbers, got " +
                           description_of(numbers).c_str())
                              .c_str());
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      std::memcpy(&transform(row, column),
                  buffer.data() + static_cast<std::size_t>(row * 4 + column) * sizeof(double),
                  sizeof(double));
  if (buffer.length(0) == 4) {
    double last[4];
    std::memcpy(last, buffer.data() + 12 * sizeof(double), sizeof(last));
    if (last[0] != 0.0 || last[1] != 0.0 || last[2] != 0.0 || last[3] != 1.0)
      throw nb::value_error((std::string(name) + ": its last row must be 0 0 0 1").c_str());
  }
  return transform;
}

}  // namespace groundgrid::python
