#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "io/point_cloud.hpp"

namespace groundgrid::io {

/// The numbers of every point in a .bin file, which has no header: a letter each, x y z, i for
/// intensity, r for ring, t for time and _ for one to pass over; all 32-bit or all 64-bit floats.
class BinLayout {
 public:
  static constexpr std::size_t kMostNumbers = 32;

  constexpr BinLayout(std::string_view letters, FieldType number)
      : count_(letters.size()), number_(number) {
    for (std::size_t i = 0; i < count_; ++i) letters_.at(i) = letters[i];
  }

  /// Of a name such as "xyzi", "xyzi__t" or, with 64-bit floats, "xyz:f64". Nothing if x, y or z is
  /// missing, a letter is another one or stands twice, or there are more than kMostNumbers.
  static std::optional<BinLayout> named(std::string_view name);

  [[nodiscard]] std::string name() const;

  /// For people: "x y z intensity, 32-bit floats".
  [[nodiscard]] std::string words() const;

  /// How many numbers a point has, and their bytes.
  [[nodiscard]] std::size_t numbers() const { return count_; }
  [[nodiscard]] std::size_t bytes() const { return count_ * size_of(number_); }
  [[nodiscard]] FieldType number() const { return number_; }

  /// Adds the fields to a cloud without any; numbers to pass over are called kPaddingName.
  void add_fields(PointCloud& cloud) const;

  bool operator==(const BinLayout&) const = default;

 private:
  std::array<char, kMostNumbers> letters_{};
  std::size_t count_;
  FieldType number_;
};

inline constexpr BinLayout kKittiLayout{"xyzi", FieldType::float32};
inline constexpr BinLayout kNuscenesLayout{"xyzir", FieldType::float32};

}  // namespace groundgrid::io
