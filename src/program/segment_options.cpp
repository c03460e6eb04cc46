#include "program/segment_options.hpp"

#include <CLI/Validators.hpp>

namespace groundgrid::program {

void SegmentOptions::add_to(CLI::App& command) {
  input.add_to(command, "INPUT",
               "Dataset in KITTI odometry layout, a folder of scans (.bin, .pcd.bin, .pcd, .ply), "
               "one scan, or a list of scans (.txt, one path a line)");
  command.add_option("--output", output, "Folder to write to")->required();
  command
      .add_option("--clouds", clouds,
                  "Write each cloud again with its labels and heights: same (as the input), pcd or "
                  "ply; left out: none")
      ->check(CLI::IsMember({"same", "pcd", "ply"}));
  terrain.add_to(command);
  command.add_flag("--keep-going", keep_going, "Skip bad scans and list them");
  command.add_flag("--json", json, "Print run.json to standard output, too");
  method.add_to(command);
}

}  // namespace groundgrid::program
