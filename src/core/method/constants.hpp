#pragma once

#include <cstddef>

/// The numbers of the default method that are no parameters, each with its reason. The paper's are
/// in groundgrid/config.hpp.
namespace groundgrid::constants {

// Returns this far below the ground are reflections, whatever stage finds them; a gutter or the
// edge of a kerb is less deep.
inline constexpr double kReflectionDepth_m = 0.3;

// Outliers (III-A): a ray may dip this far below the map, and only ground seen well and all around
// hides a point.
inline constexpr double kRayTolerance_m = 0.1;
inline constexpr double kRayConfidence = 8.0;  ///< Sum over 5 × 5 cells.

// A scan contradicts the map if more than this share of the flat cells, in what the map knows well,
// lies above it by more than an offset, or below it. No load or bump lifts a vehicle as far; a roof
// or a crowd covers fewer cells.
inline constexpr double kFlatColumn_m = 0.2;
inline constexpr float kMapOffset_m = 0.25F;
inline constexpr double kContradicting = 0.5;
inline constexpr std::size_t kComparedCells = 100;
/// Share of the points that lie so far below the map that they count as outliers.
inline constexpr double kSunkPoints = 0.25;

// Support: the lowest returns of two cells belong to one surface if the slope between them is at
// most that of a steep embankment (35 degrees), plus what measurement and grass scatter by.
inline constexpr int kSupportReach = 2;  ///< Cells along each axis.
inline constexpr double kSteepest = 0.7;
inline constexpr double kScatter_m = 0.05;
/// A surface of fewer cells than this supports none of them: a reflection, a cluster of them, a
/// car.
inline constexpr std::size_t kSupportCells = 25;
/// Two passes do on scans as they come, four where every twentieth return lies below the ground.
inline constexpr int kSupportPasses = 8;

/// Patches are 3 × 3 nearer than this, 5 × 5 beyond (the paper's d_ps, for whom it is 20 m).
inline constexpr float kWidePatchFrom_m = 40.0F;
// Ground cells (III-C): heights on a lawn scatter by some 3 cm.
inline constexpr float kMaxVariance_m2 = 1e-3F;
/// From this count on a cell's own variance counts, not that of its patch (the paper's v_np).
inline constexpr int kOwnVariancePoints = 10;

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

// What stands on the surface: blocks at least this wide tell, three fits are enough, and cells more
// than the tolerance above it lose weight in the fit.
inline constexpr double kSurfaceBlock_m = 4.5;
inline constexpr int kSurfacePasses = 3;
inline constexpr float kSurfaceTolerance_m = 0.06F;
/// Cells this far above the surface are not ground; a kerb is lower.
inline constexpr float kSurfaceStep_m = 0.2F;
/// Cells of at least this confidence are remembered as ground.
inline constexpr float kRemembered = 0.05F;
/// A cell without ground whose lowest return is less than this above the surface takes its height.
inline constexpr float kFollow_m = 0.1F;
/// Cells further below the surface than this are reflections: they lose weight too.
inline constexpr float kReflection_m = 0.5F;
// Raised cells belong together if they are at most this far apart, in cells, and this steep.
inline constexpr int kPatchReach = 2;
inline constexpr float kPatchSlope = 0.4F;
inline constexpr float kPatchStep_m = 0.02F;
// Wider patches are terraces and banks, unless they stand higher than this on average.
inline constexpr double kTerraceArea_m2 = 5.0;
inline constexpr float kTerraceHeight_m = 1.0F;
/// By this factor the variance of a height is greater than that of its plane: measured on simulated
/// drives.
inline constexpr float kPlaneFactor = 1.2F;

// Labels: returns higher than this above the map rise from the ground; if there are none below
// kOverhang_m, they hang over it.
inline constexpr float kTall_m = 0.3F;
inline constexpr float kOverhang_m = 1.0F;
/// A few blades of grass are no obstacle: there are more such returns than this share of the
/// ground's.
inline constexpr double kTallShare = 0.15;
/// Ground points end at this height if something rises from the ground.
inline constexpr float kTallThreshold_m = 0.06F;
/// Points up to this far above the map make the mean that heights are measured from.
inline constexpr float kLevelBand_m = 0.15F;
/// One cell counts like at most this many points, so that a dense one does not outvote the rest.
inline constexpr float kCellWeight = 20.0F;
/// The cell itself counts this often among the 5 × 5 around it.
inline constexpr float kOwnWeight = 3.0F;
/// "No offset" counts like this many points.
inline constexpr float kNoOffsetPoints = 3.0F;

}  // namespace groundgrid::constants
