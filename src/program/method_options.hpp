#pragma once

#include <CLI/App.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "groundgrid/config.hpp"
#include "program/input_files.hpp"

namespace groundgrid::program {

/// The flags that say how the method runs: --preset, --config, --single-scan, --threads, and one
/// for every parameter of the library, which --help-all lists.
class MethodOptions {
 public:
  /// Adds the flags to a sub-command. The object must stay where it is until parsing is over.
  void add_to(CLI::App& command);

  /// Makes every one of the flags an error together with `other`.
  void exclude(CLI::Option* other);

  /// The preset, changed by the parameter file, changed by the flags. Throws UsageError if a
  /// name is unknown or a value not allowed, io::Error if the file cannot be read.
  [[nodiscard]] Config config() const;

  /// The parameter file, if there is one.
  void add_files(InputFiles& inputs) const { inputs.add(file_); }

  [[nodiscard]] const std::string& preset() const { return preset_; }
  [[nodiscard]] bool single_scan() const { return single_scan_; }
  /// 0: one per core.
  [[nodiscard]] int threads() const { return threads_; }

 private:
  std::string preset_ = "default";
  std::string file_;
  bool single_scan_ = false;
  int threads_ = 1;
  std::vector<std::string> values_;  ///< Of the parameters' flags, in the order of parameters().
  std::vector<CLI::Option*> parameter_options_;
  std::vector<CLI::Option*> other_options_;
};

/// Every parameter with its value, in the order of parameters(); null where it is left out.
nlohmann::ordered_json to_json(const Config& config);

}  // namespace groundgrid::program
