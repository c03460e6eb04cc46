#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>

#include "program/input_options.hpp"
#include "program/method_options.hpp"
#include "program/terrain_output.hpp"

namespace groundgrid::program {

/// The flags of `segment`.
struct SegmentOptions {
  InputOptions input;
  std::filesystem::path output;
  std::string clouds = "none";
  bool keep_going = false;
  bool json = false;
  TerrainOptions terrain;
  MethodOptions method;

  /// The object must stay where it is until parsing is over.
  void add_to(CLI::App& command);
};

}  // namespace groundgrid::program
