#include "output_arrays.hpp"

#include <cstdint>
#include <string>
#include <utility>

namespace groundgrid::python {
namespace {

using Access = HeldBuffer::Access;

nb::object new_array(std::size_t points, const char* type) {
  return nb::module_::import_("numpy").attr("empty")(points, type);
}

nb::object item_of(nb::handle out, std::size_t index, std::size_t points) {
  if (out.is_none()) return new_array(points, index == 0 ? "uint8" : "float32");
  if (!PySequence_Check(out.ptr()) || nb::len(out) != 2)
    throw nb::type_error(("out: expected the pair (labels, heights), got " +
                          std::string(description_of(out).c_str()))
                             .c_str());
  return nb::borrow(out[index]);
}

void check(const HeldBuffer& buffer, char type, std::ptrdiff_t item_bytes, const char* expected,
           std::size_t points) {
  const auto address = reinterpret_cast<std::uintptr_t>(buffer.data());
  const bool fits = buffer.holds(type) && buffer.dimensions() == 1 && buffer.length(0) == points &&
                    (points < 2 || buffer.stride(0) == item_bytes) &&
                    address % static_cast<std::uintptr_t>(item_bytes) == 0;
  if (fits) return;
  throw nb::value_error((std::string("out: expected ") + expected + " of " +
                         std::to_string(points) + " aligned elements without gaps, got " +
                         description_of(buffer.array()).c_str())
                            .c_str());
}

}  // namespace

OutputArrays::OutputArrays(nb::handle out, const ScanArrays& scans)
    : OutputArrays(item_of(out, 0, scans.points()), item_of(out, 1, scans.points()), scans) {}

OutputArrays::OutputArrays(nb::object labels, nb::object heights, const ScanArrays& scans)
    : labels_(std::move(labels)),
      heights_(std::move(heights)),
      label_buffer_(labels_, "out: labels", Access::write),
      height_buffer_(heights_, "out: heights", Access::write) {
  const std::size_t points = scans.points();
  check(label_buffer_, 'B', 1, "labels as a uint8 array", points);
  check(height_buffer_, 'f', sizeof(float), "heights as a float32 array", points);
  const std::byte* const label = label_buffer_.data();
  const std::byte* const height = height_buffer_.data();
  const std::byte* const label_end = label + points;
  const std::byte* const height_end = height + points * sizeof(float);
  if (scans.overlap(label, label_end) || scans.overlap(height, height_end) ||
      (label < height_end && height < label_end))
    throw nb::value_error("out: its arrays share memory with each other or with the points");
}

ScanOutput OutputArrays::spans() const {
  const std::size_t points = label_buffer_.length(0);
  return {{reinterpret_cast<Label*>(label_buffer_.data()), points},
          {reinterpret_cast<float*>(height_buffer_.data()), points}};
}

}  // namespace groundgrid::python
