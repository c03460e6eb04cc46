#include "io/scan_sequence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>

#include "io/error.hpp"

namespace groundgrid::io {
namespace {

namespace fs = std::filesystem;

std::optional<std::size_t> number_of(const std::string& text) {
  std::size_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return number;
}

bool is_scan(const fs::path& path) {
  return path.extension() == ".bin" && path.filename().string().front() != '.';
}

std::vector<fs::path> entries_of(const fs::path& folder) {
  std::error_code error;
  const fs::directory_iterator entries(folder, error);
  if (error) throw Error({.file = folder, .expected = "a readable folder", .got = error.message()});
  std::vector<fs::path> paths;
  for (const fs::directory_entry& entry : entries) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::vector<ScanFile> scans_in(const fs::path& folder) {
  std::vector<ScanFile> scans;
  for (const fs::path& path : entries_of(folder))
    if (is_scan(path)) scans.push_back({path.stem().string(), 0, path});
  if (scans.empty())
    throw Error({.file = folder,
                 .expected = "scans (.bin files) or a dataset (sequences/NN/velodyne)",
                 .got = "neither"});
  return scans;
}

// The last part of a path, also where it is written as "." or "00/". Links are not followed: a
// sequence has the name it has in the dataset.
std::string folder_name(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

ScanSequence dataset_sequence(const fs::path& folder) {
  ScanSequence sequence{folder_name(folder), folder, scans_in(folder / "velodyne")};
  for (ScanFile& scan : sequence.scans) {
    const auto number = number_of(scan.name);
    if (!number)
      throw Error(
          {.file = scan.path,
           .expected = "a scan's number as its name (000042.bin)",
           .got = fmt::format("'{}'", scan.name),
           .remedy = "rename it, or give its folder as INPUT to take the files as they are"});
    scan.number = *number;
  }
  std::sort(sequence.scans.begin(), sequence.scans.end(),
            [](const ScanFile& a, const ScanFile& b) { return a.number < b.number; });
  return sequence;
}

std::vector<fs::path> sequence_folders(const fs::path& input) {
  if (fs::is_directory(input / "velodyne")) return {input};
  const fs::path parent = fs::is_directory(input / "sequences") ? input / "sequences" : input;
  std::vector<fs::path> folders;
  for (const fs::path& path : entries_of(parent))
    if (fs::is_directory(path / "velodyne")) folders.push_back(path);
  return folders;
}

fs::path folder_named(const std::vector<fs::path>& folders, const std::string& name,
                      const fs::path& input) {
  std::vector<std::string> known;
  for (const fs::path& folder : folders) {
    known.push_back(folder_name(folder));
    const auto number = number_of(name);
    if (known.back() == name || (number && number == number_of(known.back()))) return folder;
  }
  throw Error({.file = input,
               .expected = fmt::format("sequence {}", name),
               .got = fmt::format("the sequences {}", fmt::join(known, ", "))});
}

std::vector<fs::path> folders_named(const std::vector<fs::path>& folders,
                                    std::span<const std::string> names, const fs::path& input) {
  std::vector<fs::path> chosen;
  for (const std::string& name : names) {
    const fs::path folder = folder_named(folders, name, input);
    if (std::find(chosen.begin(), chosen.end(), folder) == chosen.end()) chosen.push_back(folder);
  }
  return chosen;
}

std::vector<ScanSequence> plain_scans(const fs::path& input) {
  if (fs::is_directory(input)) return {{"", input, scans_in(input)}};
  if (!is_scan(input))
    throw Error({.file = input,
                 .expected = "a KITTI scan (.bin), a folder of them or a dataset",
                 .got = "another kind of file"});
  return {{"", input.parent_path(), {{input.stem().string(), 0, input}}}};
}

}  // namespace

std::vector<ScanSequence> find_sequences(const fs::path& input,
                                         std::span<const std::string> names) {
  if (!fs::exists(input))
    throw Error({.file = input,
                 .expected = "a dataset, a folder of scans or a scan",
                 .got = "nothing of that name"});
  const auto folders = fs::is_directory(input) ? sequence_folders(input) : std::vector<fs::path>{};
  if (folders.empty() && !names.empty())
    throw Error({.file = input,
                 .expected = "a dataset with sequences/NN/velodyne",
                 .got = "a place without",
                 .remedy = "leave out --sequence for plain .bin files"});
  if (folders.empty()) return plain_scans(input);
  std::vector<ScanSequence> sequences;
  for (const fs::path& folder : names.empty() ? folders : folders_named(folders, names, input))
    sequences.push_back(dataset_sequence(folder));
  return sequences;
}

}  // namespace groundgrid::io
