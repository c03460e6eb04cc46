#pragma once

#include <cstdint>

#include "io/point_cloud.hpp"

namespace groundgrid::io {

/// Calls `use` with a zero of the C++ type of a field's numbers, and returns what it returns.
template <typename Use>
auto with_number(FieldType type, Use&& use) {
  switch (type) {
    case FieldType::int8:
      return use(std::int8_t{});
    case FieldType::uint8:
      return use(std::uint8_t{});
    case FieldType::int16:
      return use(std::int16_t{});
    case FieldType::uint16:
      return use(std::uint16_t{});
    case FieldType::int32:
      return use(std::int32_t{});
    case FieldType::uint32:
      return use(std::uint32_t{});
    case FieldType::int64:
      return use(std::int64_t{});
    case FieldType::uint64:
      return use(std::uint64_t{});
    case FieldType::float32:
      return use(float{});
    case FieldType::float64:
      break;
  }
  return use(double{});
}

}  // namespace groundgrid::io
