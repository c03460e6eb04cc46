#include "program/render.hpp"

#include "program/render_scan.hpp"

namespace groundgrid::program {

void add_render(CLI::App& app) {
  CLI::App* const command = app.add_subcommand("render", "Draw a scan");
  command->require_subcommand(1);
  add_render_scan(*command);
}

}  // namespace groundgrid::program
