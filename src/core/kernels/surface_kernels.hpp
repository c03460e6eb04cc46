#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/kernels/plane_kernels.hpp"

namespace groundgrid {

/// What is known of a cell's height and where it stands.
enum class Standing : std::uint8_t { unknown = 0, on_surface = 1, raised = 2, judged = 3 };

/// A height that says: nothing is known of this cell. So far up that it has no weight.
constexpr float kUnknownHeight = 1e30F;

/// Heights of the cells that are ground in this scan (as they are in `heights`) or remembered with
/// at least this confidence (those of the map), kUnknownHeight of all others.
void collect_known(std::span<const std::uint8_t> is_ground, std::span<const float> map_heights,
                   std::span<const float> confidence, float remembered, std::span<float> heights);

/// Weight 1 of cells with a height, 0 of all others.
void weigh_known(const float* heights, std::size_t count, float* weights);

/// Heights at most this far from the surface keep all their weight, metres.
struct HeightTolerance {
  float above = 0.0F;
  float below = 0.0F;
};

/// Weights of a row of heights by how far they are from the surface: 1 within the tolerance, the
/// square of tolerance over distance beyond.
void reweight(const float* heights, const SurfaceBetween& surface, const HeightTolerance& tolerance,
              std::size_t count, float* weights);

/// Which cells of a row stand more than `step` above the surface, metres; and the surface there,
/// where anything is known.
void judge(const float* heights, const SurfaceBetween& surface, float step, std::size_t count,
           Standing* standing, float* surface_there);

/// Weight 1 of cells on the surface, 0 of all others.
void weigh_surface(const Standing* standing, std::size_t count, float* weights);

/// Some cells of the map; one array a layer.
struct FilledCells {
  const std::uint8_t* is_ground = nullptr;
  const Standing* standing = nullptr;
  const SurfaceBetween* surface = nullptr;
  float* height = nullptr;
  float* confidence = nullptr;
  std::size_t count = 0;
};

/// Where there is no ground in this scan: lets confidence decay, and gives cells that are not
/// remembered the height of the surface.
void fill_cells(const FilledCells& cells, float decay);

}  // namespace groundgrid
