#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "program/method_notes.hpp"
#include "program/scan_slot.hpp"
#include "program/view_options.hpp"
#include "rendering/image.hpp"
#include "rendering/palette.hpp"
#include "rendering/perspective.hpp"

namespace groundgrid::program {

/// The flags that say how a scan looks: --view and what belongs to it, --range, --errors.
class ScanLook {
 public:
  /// Gives back the flag --errors. The object must stay where it is until parsing is over.
  CLI::Option* add_to(CLI::App& command);

  /// Throws UsageError where flags do not go together.
  void check() const { view_.check(); }

  [[nodiscard]] const ViewOptions& view() const { return view_; }
  [[nodiscard]] double range_m() const { return range_m_; }
  [[nodiscard]] bool errors() const { return errors_; }

 private:
  ViewOptions view_;
  double range_m_ = 50.0;
  bool errors_ = false;
};

/// Where no height of the LiDAR over the ground is known: that of KITTI.
inline constexpr double kUsualSensorHeight_m = 1.73;

/// The greatest height that the method worked with; nothing where it never had one.
std::optional<double> height_in(const MethodNotes& notes);

/// What is written above the picture of a scan.
struct ScanWords {
  std::string title{};
  std::string caption{};
};

/// Draws labelled scans, one after another in the same way.
class ScanPainter {
 public:
  /// Throws std::runtime_error where a perspective is wanted and there is no OpenGL.
  ScanPainter(const ScanLook& look, rendering::ImageSize size);

  /// The labels in the slot or, with errors, what is wrong with them by `truth`, one label a point;
  /// the caption then begins with the figures. The ground is so far below the LiDAR.
  [[nodiscard]] rendering::Image paint(const ScanSlot& slot, std::span<const std::uint32_t> truth,
                                       double sensor_height_m, ScanWords words) const;

  /// The colours that its pictures are made of.
  [[nodiscard]] rendering::Palette palette() const;

 private:
  const ScanLook& look_;
  rendering::ImageSize size_;
  std::unique_ptr<rendering::PerspectiveRenderer> renderer_;  ///< Null for a view from above.
};

}  // namespace groundgrid::program
