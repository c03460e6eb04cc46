#pragma once

#include <nanobind/nanobind.h>

#include <cstddef>

namespace groundgrid::python {

namespace nb = nanobind;

/// The memory of an array. As long as this lives Python neither frees nor resizes it, even while
/// other threads run. Made and destroyed with the GIL held.
class HeldBuffer {
 public:
  enum class Access { read, write };

  /// Takes anything with Python's buffer interface or an __array__ method. Throws TypeError, which
  /// begins with `name`, for all else, and ValueError for memory that may not be written to.
  HeldBuffer(nb::handle array, const char* name, Access access = Access::read);
  ~HeldBuffer();
  HeldBuffer(HeldBuffer&& other) noexcept;
  HeldBuffer& operator=(HeldBuffer&&) = delete;
  HeldBuffer(const HeldBuffer&) = delete;
  HeldBuffer& operator=(const HeldBuffer&) = delete;

  [[nodiscard]] std::byte* data() const { return static_cast<std::byte*>(buffer_.buf); }
  [[nodiscard]] int dimensions() const { return buffer_.ndim; }
  [[nodiscard]] std::size_t length(int dimension) const;
  /// Bytes from one element to the next; may be 0 or negative.
  [[nodiscard]] std::ptrdiff_t stride(int dimension) const { return buffer_.strides[dimension]; }

  /// Whether the elements are of this type (a character of Python's module struct), in the
  /// machine's byte order.
  [[nodiscard]] bool holds(char type) const;
  [[nodiscard]] nb::handle array() const { return array_; }

 private:
  nb::object array_;
  Py_buffer buffer_{};
};

/// "float32 array of shape (10, 4)", "list": what was given, for messages.
nb::str description_of(nb::handle object);

}  // namespace groundgrid::python
