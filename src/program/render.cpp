#include "program/render.hpp"

#include "program/render_drive.hpp"
#include "program/render_error.hpp"
#include "program/render_scan.hpp"
#include "program/render_terrain.hpp"

namespace groundgrid::program {

void add_render(CLI::App& app) {
  CLI::App* const command =
      app.add_subcommand("render", "Draw a scan, a drive, a terrain or its errors");
  command->require_subcommand(1);
  add_render_scan(*command);
  add_render_drive(*command);
  add_render_terrain(*command);
  add_render_error(*command);
}

}  // namespace groundgrid::program
