#include "held_buffer.hpp"

#include <bit>
#include <string>
#include <string_view>
#include <utility>

namespace groundgrid::python {
namespace {

constexpr char kNativeOrder = std::endian::native == std::endian::little ? '<' : '>';

bool is_float_of_other_order(std::string_view format) {
  constexpr char other = kNativeOrder == '<' ? '>' : '<';
  return format.size() == 2 && format[0] == other && (format[1] == 'f' || format[1] == 'd');
}

[[noreturn]] void reject_object(nb::handle object, const char* name) {
  throw nb::type_error(
      (std::string(name) + ": expected a NumPy array, got " + description_of(object).c_str())
          .c_str());
}

void get_buffer(nb::handle array, const char* name, int flags, Py_buffer& buffer) {
  if (PyObject_GetBuffer(array.ptr(), &buffer, flags) == 0) return;
  PyErr_Clear();
  if ((flags & PyBUF_WRITABLE) != 0)
    throw nb::value_error((std::string(name) + ": the array is read-only").c_str());
  reject_object(array, name);
}

}  // namespace

nb::str description_of(nb::handle object) {
  if (nb::hasattr(object, "dtype") && nb::hasattr(object, "shape"))
    return nb::str("{} array of shape {}").format(object.attr("dtype"), object.attr("shape"));
  return nb::borrow<nb::str>(object.type().attr("__name__"));
}

HeldBuffer::HeldBuffer(nb::handle array, const char* name, Access access)
    : array_(nb::borrow(array)) {
  const bool is_read = access == Access::read;
  if (is_read && PyObject_CheckBuffer(array.ptr()) == 0) {
    if (!nb::hasattr(array, "__array__")) reject_object(array, name);
    array_ = nb::module_::import_("numpy").attr("asarray")(array);
  }
  const int flags = PyBUF_STRIDES | PyBUF_FORMAT | (is_read ? 0 : PyBUF_WRITABLE);
  get_buffer(array_, name, flags, buffer_);
  if (is_read && buffer_.format != nullptr && is_float_of_other_order(buffer_.format)) {
    PyBuffer_Release(&buffer_);
    array_ = nb::module_::import_("numpy").attr("asarray")(array_);
    array_ = array_.attr("astype")(array_.attr("dtype").attr("newbyteorder")("="));
    get_buffer(array_, name, flags, buffer_);
  }
}

HeldBuffer::~HeldBuffer() {
  if (buffer_.obj != nullptr) PyBuffer_Release(&buffer_);
}

HeldBuffer::HeldBuffer(HeldBuffer&& other) noexcept
    : array_(std::move(other.array_)), buffer_(std::exchange(other.buffer_, Py_buffer{})) {}

std::size_t HeldBuffer::length(int dimension) const {
  return static_cast<std::size_t>(buffer_.shape[dimension]);
}

bool HeldBuffer::holds(char type) const {
  std::string_view format = buffer_.format == nullptr ? "B" : buffer_.format;
  // '=' and '^' stand before the type in arrays that are not aligned.
  if (format.size() == 2 && (std::string_view("@=^").find(format[0]) != std::string_view::npos ||
                             format[0] == kNativeOrder))
    format.remove_prefix(1);
  return format.size() == 1 && format[0] == type;
}

}  // namespace groundgrid::python
