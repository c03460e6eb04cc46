#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "evaluation/cell_lattice.hpp"
#include "evaluation/terrain_metrics.hpp"

namespace groundgrid::evaluation {

/// The figures of a terrain, and what was compared.
struct TerrainReport {
  std::string map{};
  std::string reference{};
  CellLattice lattice{};
  TerrainFigures figures{};
  std::vector<std::string> remarks{};  ///< What was taken for granted.
};

/// For people: a row per group, at most 100 characters wide. Errors in metres.
std::string to_table(const TerrainReport& report);

/// The same for programs; coverage from 0 to 1, null where there is nothing to tell.
nlohmann::ordered_json to_json(const TerrainReport& report);

}  // namespace groundgrid::evaluation
