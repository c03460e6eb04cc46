#pragma once

#include <cstdint>
#include <optional>

#include "core/map/elevation_map.hpp"
#include "core/method/method.hpp"
#include "core/method/reference_surface.hpp"

/// The default method as plain code: scalar, one thread, values in and values out. It is what
/// Config::method = Method::reference runs; the fast stages give the same bits, which
/// tests/property/reference_test.cpp shows. Read it from the bottom: process() is the whole.
namespace groundgrid::reference {

/// Labels a scan and takes it into the map. `bins`, `grid` and `on_surface` are buffers; the last
/// two tell afterwards what was seen, and which cells hold the surface up. Nothing, with the map
/// untouched, if the scan contradicts the map.
std::optional<LabelCounts> process(const Scan& scan, const Config& config, BinnedPoints& bins,
                                   ScanGrid& grid, PerCell<std::uint8_t>& on_surface,
                                   ElevationMap& map, const Answers& answers);

}  // namespace groundgrid::reference
