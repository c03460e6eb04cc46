#pragma once

#include <cstdint>

namespace groundgrid::rendering {

/// An opaque colour, sRGB.
struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  bool operator==(const Color&) const = default;
};

inline constexpr Color kWhite{255, 255, 255};
inline constexpr Color kBlack{0, 0, 0};
inline constexpr Color kInk{34, 34, 34};          ///< Of text and frames.
inline constexpr Color kFaintInk{105, 105, 105};  ///< Of captions.

// The palette of Okabe and Ito, which people with any colour vision can tell apart.
inline constexpr Color kOrange{230, 159, 0};
inline constexpr Color kSkyBlue{86, 180, 233};
inline constexpr Color kBluishGreen{0, 158, 115};
inline constexpr Color kYellow{240, 228, 66};
inline constexpr Color kBlue{0, 114, 178};
inline constexpr Color kVermilion{213, 94, 0};
inline constexpr Color kReddishPurple{204, 121, 167};

}  // namespace groundgrid::rendering
