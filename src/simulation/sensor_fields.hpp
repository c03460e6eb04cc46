#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace groundgrid::simulation {

/// What a field may be between.
struct Limits {
  double least;
  double greatest;
};

/// The fields of a sensor file: TOML without tables, each `name = value` with a number, a quoted
/// word or a list of numbers, which alone may go on over several lines. Each is taken once.
class SensorFields {
 public:
  /// Throws io::Error where the text is anything else or names a field twice.
  SensorFields(std::string_view text, std::filesystem::path file);

  /// @name Takes a field, if it is there
  /// Throws io::Error where it is of another kind or a number is out of range.
  /// @{
  std::optional<std::string> word(const std::string& name);
  std::optional<double> number(const std::string& name, Limits range);
  std::optional<std::vector<double>> numbers(const std::string& name, Limits range);
  /// @}

  /// Throws io::Error where a field was not taken, hence is unknown.
  void require_all_taken() const;

  /// Throws io::Error about a field that was taken, or about the whole file where it was not there.
  [[noreturn]] void fail(const std::string& name, const std::string& expected,
                         const std::string& got) const;

 private:
  using Value = std::variant<double, std::string, std::vector<double>>;
  struct Field {
    std::size_t line = 0;
    Value value{};
    bool taken = false;
  };
  void add(const std::string& entry, std::size_t line);
  [[nodiscard]] Value value_in(const std::string& entry, std::size_t line) const;
  template <typename Kind>
  const Kind* take(const std::string& name, const std::string& expected);
  void require_range(const std::string& name, double value, Limits range) const;
  [[noreturn]] void fail_line(std::size_t line, const std::string& expected,
                              std::string_view got) const;

  std::filesystem::path file_;
  std::map<std::string, Field> fields_;
};

}  // namespace groundgrid::simulation
