#include "program/program.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>
#include <new>

#include "program/evaluate.hpp"
#include "program/evaluate_terrain.hpp"
#include "program/info.hpp"
#include "program/interrupt.hpp"
#include "program/params.hpp"
#include "program/render.hpp"
#include "program/reproduce.hpp"
#include "program/segment.hpp"
#include "program/simulate.hpp"
#include "program/usage_error.hpp"
#include "program/version.hpp"

namespace groundgrid::program {
namespace {

// Words go to standard error: standard output belongs to results.
void set_up_logging() {
  spdlog::set_default_logger(spdlog::stderr_color_mt("groundgrid"));
  spdlog::set_pattern("%^%l%$: %v");
}

int run_app(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& result) {
    // Asking for help or the version comes here too, and is no error.
    return app.exit(result, std::cout, std::cerr) == 0 ? kDone : kBadUsage;
  } catch (const UsageError& error) {
    spdlog::error("{}", error.what());
    return kBadUsage;
  } catch (const std::bad_alloc&) {
    spdlog::error("not enough memory");
    return kBadInput;
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return kBadInput;
  }
  return kDone;
}

}  // namespace

int run(int argc, const char* const* argv) {
  set_up_logging();
  catch_interrupts();
  CLI::App app{"GroundGrid: LiDAR ground segmentation and terrain estimation", "groundgrid"};
  app.set_version_flag("--version", version());
  app.require_subcommand(1);
  const Arguments arguments(argv + std::min(argc, 1), argv + argc);
  add_segment(app, arguments);
  add_evaluate(app, arguments);
  add_evaluate_terrain(app, arguments);
  add_info(app);
  add_params(app);
  add_render(app);
  add_reproduce(app);
  add_simulate(app);
  return run_app(app, argc, argv);
}

}  // namespace groundgrid::program
