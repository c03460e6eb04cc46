#pragma once

/// The numbers of the default method that are no parameters, each with its reason. The paper's are
/// in groundgrid/config.hpp.
namespace groundgrid::constants {

// Support: the lowest returns of two cells belong to one surface if the slope between them is at
// most that of a steep embankment (35 degrees), plus what measurement and grass scatter by.
inline constexpr int kSupportReach = 2;  ///< Cells along each axis.
inline constexpr double kSteepest = 0.7;
inline constexpr double kScatter_m = 0.05;
/// Below that surface, by more than a kerb or a gutter, there is no ground.
inline constexpr double kSupportDepth_m = 0.3;
/// Two passes do on scans as they come, four where every twentieth return lies below the ground.
inline constexpr int kSupportPasses = 8;

// Blocks of planes.
inline constexpr int kFinestBlock = 5;  ///< Cells a side.
inline constexpr int kBranch = 3;       ///< Blocks a side below each block.
// How a block's plane may differ from those above it: height per metre of its side, and slope.
inline constexpr double kRoughness = 0.08;
inline constexpr double kBend = 0.08;
// And the plane of the whole square from the one expected there.
inline constexpr double kTopHeight_m = 0.5;
inline constexpr double kTopSlope = 0.1;
// Scatter of a block's cells around its plane: as measured, and per metre of its side.
inline constexpr double kNoise_m = 0.03;
inline constexpr double kNoisePerMetre = 0.03;
/// The cells of a block err together: all of them say no more than this many.
inline constexpr double kIndependentCells = 8.0;

// What stands on the surface.
inline constexpr int kSurfacePasses = 3;
/// Cells further below the surface than this are reflections: they lose weight too.
inline constexpr float kReflection_m = 0.5F;
// Raised cells belong together if they are at most this far apart, in cells, and this steep.
inline constexpr int kPatchReach = 2;
inline constexpr float kPatchSlope = 0.4F;
inline constexpr float kPatchStep_m = 0.02F;
/// By this factor the variance of a height is greater than that of its plane: measured on simulated
/// drives.
inline constexpr float kPlaneFactor = 1.2F;

// Labels: ground points lie at most this far below the map's height; deeper ones are reflections.
inline constexpr double kBandBelow_m = 0.3;
/// One cell counts like at most this many points, so that a dense one does not outvote the rest.
inline constexpr float kCellWeight = 20.0F;
/// The cell itself counts this often among the 5 × 5 around it.
inline constexpr float kOwnWeight = 3.0F;
/// "No offset" counts like this many points.
inline constexpr float kNoOffsetPoints = 3.0F;

}  // namespace groundgrid::constants
