#include "io/scan_sequence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <system_error>

#include "io/bin_scan.hpp"
#include "io/error.hpp"
#include "io/input_file.hpp"
#include "io/number_list.hpp"
#include "io/path_checks.hpp"
#include "io/scan_list.hpp"
#include "io/text_cloud.hpp"

namespace groundgrid::io {
namespace {

namespace fs = std::filesystem;

using ForcedFormat = std::optional<ScanFormat>;

[[noreturn]] void fail_unreadable(const fs::path& folder, const std::error_code& error) {
  throw Error({.file = folder,
               .expected = "a readable folder",
               .got = error.message(),
               .remedy = "check its rights and, where it is a link, whereto it leads"});
}

std::vector<fs::path> entries_of(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> paths;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error))
    paths.push_back(entry->path());
  if (error) fail_unreadable(folder, error);
  std::sort(paths.begin(), paths.end());
  return paths;
}

using FormatBy = ForcedFormat (*)(const fs::path& path);

// An entry that turns out to be no file is left to reading, which a run may pass over.
std::vector<ScanFile> scans_by(FormatBy format_by, const std::vector<fs::path>& entries,
                               ForcedFormat forced) {
  std::vector<ScanFile> scans;
  for (const fs::path& path : entries)
    if (const ForcedFormat named = format_by(path))
      scans.push_back({scan_stem(path), 0, path, forced.value_or(*named)});
  return scans;
}

// Files .csv and .txt are often something else: scans only if there are no others, and one of them
// looks like a cloud.
std::vector<ScanFile> scans_in(const fs::path& folder, ForcedFormat forced) {
  const std::vector<fs::path> entries = entries_of(folder);
  std::vector<ScanFile> scans = scans_by(format_by_name, entries, forced);
  if (scans.empty()) {
    scans = scans_by(format_by_any_name, entries, forced);
    if (std::none_of(scans.begin(), scans.end(),
                     [](const ScanFile& scan) { return is_text_cloud(scan.path); }))
      scans.clear();
  }
  if (scans.empty())
    throw Error({.file = folder,
                 .expected = fmt::format("scans (files {}) or a dataset (sequences/NN/velodyne)",
                                         kScanEndings),
                 .got = "neither"});
  return scans;
}

// The last part of a path, also where it is written as "." or "00/". Links are not followed: a
// sequence has the name it has in the dataset.
std::string folder_name(const fs::path& folder) {
  std::error_code error;
  const fs::path whole = fs::absolute(folder, error).lexically_normal();
  if (error) fail_unreadable(folder, error);
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

void require_unique(const std::vector<ScanFile>& scans) {
  std::map<std::string, fs::path> known;
  for (const ScanFile& scan : scans) {
    const auto [other, added] = known.emplace(scan.name, scan.path);
    if (!added)
      throw Error(
          {.file = scan.path,
           .expected = "scans of different names, since the output is named after them",
           .got = fmt::format("the name '{}' again, after {}", scan.name, other->second.string()),
           .remedy = "rename one of them, or take them one after the other"});
  }
}

void sort_by_number(std::vector<ScanFile>& scans) {
  std::stable_sort(scans.begin(), scans.end(),
                   [](const ScanFile& a, const ScanFile& b) { return a.number < b.number; });
}

void number_places(std::vector<ScanFile>& scans) {
  for (std::size_t i = 0; i < scans.size(); ++i) scans[i].index = i;
}

// Where a sequence has its scans; KITTI's raw data and KITTI-360 have them in the second place.
fs::path scan_folder(const fs::path& sequence) {
  const fs::path raw = sequence / "velodyne_points" / "data";
  return is_folder(raw) ? raw : sequence / "velodyne";
}

// The dataset of a sequence in data_3d_raw; empty elsewhere.
fs::path kitti_360_of(const fs::path& sequence) {
  const fs::path parent = fs::absolute(sequence / "..").lexically_normal().parent_path();
  return parent.filename() == "data_3d_raw" ? parent.parent_path() : fs::path{};
}

ScanSequence dataset_sequence(const fs::path& folder, ForcedFormat forced) {
  ScanSequence sequence{folder_name(folder), folder, scans_in(scan_folder(folder), forced),
                        kitti_360_of(folder)};
  for (ScanFile& scan : sequence.scans) {
    const auto number = parse_whole_number(scan.name);
    if (!number)
      throw Error(
          {.file = scan.path,
           .expected = "a scan's number as its name (000042.bin)",
           .got = fmt::format("'{}'", scan.name),
           .remedy = "rename it, or give its folder as INPUT to take the files as they are"});
    scan.number = *number;
  }
  sort_by_number(sequence.scans);
  const auto twice =
      std::adjacent_find(sequence.scans.begin(), sequence.scans.end(),
                         [](const ScanFile& a, const ScanFile& b) { return a.number == b.number; });
  if (twice != sequence.scans.end())
    throw Error(
        {.file = (twice + 1)->path,
         .expected = "one scan of each number",
         .got = fmt::format("number {} again, after {}", twice->number, twice->path.string()),
         .remedy = "keep one of them in the folder"});
  number_places(sequence.scans);
  return sequence;
}

// In a folder of sequences everything is one, so none is left out for want of rights; in any other
// folder there may be what does not concern us.
void require_readable(const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (error && status.type() != fs::file_type::not_found) fail_unreadable(folder, error);
}

std::vector<fs::path> sequence_folders(const fs::path& input) {
  if (is_folder(scan_folder(input))) return {input};
  const fs::path parent = is_folder(input / "sequences")     ? input / "sequences"
                          : is_folder(input / "data_3d_raw") ? input / "data_3d_raw"
                                                             : input;
  const bool all_are_sequences = folder_name(parent) == "sequences";
  std::vector<fs::path> folders;
  for (const fs::path& path : entries_of(parent)) {
    if (all_are_sequences) require_readable(path / "velodyne");
    if (is_folder(scan_folder(path))) folders.push_back(path);
  }
  return folders;
}

fs::path folder_named(const std::vector<fs::path>& folders, const std::string& name,
                      const fs::path& input) {
  std::vector<std::string> known;
  for (const fs::path& folder : folders) {
    known.push_back(folder_name(folder));
    const auto number = parse_whole_number(name);
    if (known.back() == name || (number && number == parse_whole_number(known.back())))
      return folder;
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

std::vector<ScanFile> listed_scans(const fs::path& list, ForcedFormat forced) {
  std::vector<ScanFile> scans;
  for (const ListedFile& file : read_scan_list(list)) {
    const ForcedFormat format = forced ? forced : format_by_any_name(file.path);
    if (!format)
      throw Error({.file = list,
                   .line = file.line,
                   .expected = fmt::format("a scan ({})", kScanEndings),
                   .got = file.path.string(),
                   .remedy = "say what the scans are with --format"});
    scans.push_back({scan_stem(file.path), 0, file.path, *format});
  }
  return scans;
}

ScanFile single_scan(const fs::path& path, ForcedFormat forced) {
  require_regular_file(path);
  const ForcedFormat format = forced ? forced : format_by_any_name(path);
  if (!format)
    throw Error({.file = path,
                 .expected = fmt::format(
                     "a scan ({}), a folder of scans, a list of scans (.txt or .lst) or a dataset",
                     kScanEndings),
                 .got = "another kind of file",
                 .remedy = "if it is a scan, say of which kind with --format"});
  return {scan_stem(path), 0, path, *format};
}

// Scans whose names are all numbers are in the order of these, but a list has the last word.
void number_plain_scans(std::vector<ScanFile>& scans, bool keep_order) {
  const bool numbered = std::all_of(scans.begin(), scans.end(), [](const ScanFile& scan) {
    return parse_whole_number(scan.name).has_value();
  });
  for (ScanFile& scan : scans)
    if (numbered) scan.number = *parse_whole_number(scan.name);
  if (numbered && !keep_order) sort_by_number(scans);
  number_places(scans);
  for (ScanFile& scan : scans)
    if (!numbered) scan.number = scan.index;
}

ScanSequence plain_sequence(const fs::path& input, ForcedFormat forced) {
  const bool folder = is_folder(input);
  const bool list = !folder && is_scan_list(input);
  ScanSequence sequence{"", folder ? input : input.parent_path()};
  if (folder)
    sequence.scans = scans_in(input, forced);
  else if (list)
    sequence.scans = listed_scans(input, forced);
  else
    sequence.scans = {single_scan(input, forced)};
  require_unique(sequence.scans);
  number_plain_scans(sequence.scans, list);
  return sequence;
}

// Files of one ending are of one layout: that of the first whose numbers tell.
void guess_layouts(std::vector<ScanFile>& scans) {
  std::vector<std::pair<BinLayout, BinLayout>> found;  // The usual layout, and that of these files.
  for (ScanFile& scan : scans) {
    if (scan.format.kind != ScanFormat::Kind::bin) continue;
    scan.layout_is_guessed = true;
    const bool known = std::any_of(found.begin(), found.end(), [&](const auto& layouts) {
      return layouts.first == scan.format.layout;
    });
    if (known) continue;
    if (const auto layout = guess_layout(scan.path, scan.format.layout))
      found.emplace_back(scan.format.layout, *layout);
  }
  for (ScanFile& scan : scans)
    for (const auto& [usual, layout] : found)
      if (scan.layout_is_guessed && scan.format.layout == usual) {
        scan.format.layout = layout;
        break;
      }
}

void require_existing(const fs::path& input) {
  std::error_code error;
  const fs::file_status status = fs::status(input, error);
  if (fs::exists(status)) return;
  throw Error(
      {.file = input,
       .expected = "a dataset, a folder of scans, a scan or a list of scans",
       .got = status.type() == fs::file_type::not_found ? "nothing of that name" : error.message(),
       .remedy = "check the path and, where it is a link, whereto it leads"});
}

}  // namespace

std::vector<ScanSequence> find_sequences(const fs::path& input, std::span<const std::string> names,
                                         std::optional<ScanFormat> format) {
  require_existing(input);
  const auto folders = is_folder(input) ? sequence_folders(input) : std::vector<fs::path>{};
  if (folders.empty() && !names.empty())
    throw Error({.file = input,
                 .expected = "a dataset with sequences/NN/velodyne",
                 .got = "a place without",
                 .remedy = "leave out --sequence for plain scans"});
  std::vector<ScanSequence> sequences;
  if (folders.empty()) sequences.push_back(plain_sequence(input, format));
  for (const fs::path& folder : names.empty() ? folders : folders_named(folders, names, input))
    sequences.push_back(dataset_sequence(folder, format));
  if (!format)
    for (ScanSequence& sequence : sequences) guess_layouts(sequence.scans);
  return sequences;
}

}  // namespace groundgrid::io
