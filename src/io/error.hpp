#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace groundgrid::io {

/// What is wrong with a file, where, and what to do about it.
struct ErrorDetails {
  std::filesystem::path file{};
  std::optional<std::size_t> line{};       ///< Counted from 1, in text files.
  std::optional<std::uintmax_t> offset{};  ///< Bytes from the beginning, in binary files.
  std::string expected{};
  std::string got{};
  std::string remedy{};  ///< What the user can do; empty where nothing but another file helps.
};

/// A file that cannot be read, written or understood. what() is one sentence that names the file,
/// the place in it, what was expected and found, and then the remedy, with '?' for every control
/// character of ASCII. details() keeps them.
class Error : public std::runtime_error {
 public:
  explicit Error(ErrorDetails details);

  [[nodiscard]] const ErrorDetails& details() const { return details_; }

 private:
  ErrorDetails details_;
};

/// The message of an errno value ("Permission denied").
std::string system_message(int error_number);

/// A piece of a file for a message: in quotes, cut to 40 characters, with '?' for every byte that
/// is no printable ASCII character.
std::string in_quotes(std::string_view text);

}  // namespace groundgrid::io
