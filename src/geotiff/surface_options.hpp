#pragma once

namespace groundgrid::geotiff {

/// How the heights that scans showed become a surface without holes: cells that stand out of their
/// surroundings, such as bushes that looked like ground from everywhere, are taken out, and gaps
/// are filled from what is around them.
struct SurfaceOptions {
  double max_slope = 1.0;  ///< Rise over run up to which ground is believed.
  double step_m = 0.3;     ///< What it may rise besides, such as a kerb.
  double reach_m = 1.0;    ///< How far away the lower cells may be that a cell is held against.
  double fill_m = 5.0;     ///< How far from a known cell gaps are filled.
};

}  // namespace groundgrid::geotiff
