#include "io/scan_list.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "io/error.hpp"
#include "io/input_file.hpp"
#include "io/number_list.hpp"
#include "io/text.hpp"
#include "io/text_cloud.hpp"

namespace groundgrid::io {
namespace {

constexpr const char* kRemedy =
    "a .txt or .lst file is a list of scans; give a scan another ending";

}  // namespace

bool is_scan_list(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  return ends_with_in_any_case(ending, ".lst") ||
         (ends_with_in_any_case(ending, ".txt") && !is_text_cloud(path));
}

std::vector<ListedFile> read_scan_list(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  const std::vector<std::string_view> lines = split_lines(text);
  std::vector<ListedFile> files;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view entry = trimmed(lines[i]);
    if (entry.empty() || entry.front() == '#') continue;
    files.push_back({path.parent_path() / entry, i + 1});
    try {
      require_regular_file(files.back().path);
    } catch (const Error& problem) {
      throw Error(
          {.file = path,
           .line = i + 1,
           .expected = "the path of a scan, relative to the folder of the list",
           .got = fmt::format("{}, which is {}", files.back().path.string(), problem.details().got),
           .remedy = kRemedy});
    }
  }
  if (files.empty())
    throw Error({.file = path,
                 .expected = "the path of one scan a line",
                 .got = "no path",
                 .remedy = kRemedy});
  return files;
}

}  // namespace groundgrid::io
