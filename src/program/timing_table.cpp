#include "program/timing_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>

#include "io/atomic_file.hpp"
#include "io/csv_field.hpp"
#include "io/error.hpp"
#include "io/input_file.hpp"
#include "io/path_checks.hpp"

namespace groundgrid::program {
namespace {

constexpr std::string_view kHeader = "sequence,scan,points,milliseconds";

// Takes the first field, and the comma after it, from the front of `rest`.
std::string take_field(std::string_view& rest) {
  std::string field;
  bool inside_quotes = false;
  std::size_t i = 0;
  for (; i < rest.size() && (inside_quotes || rest[i] != ','); ++i) {
    if (rest[i] != '"') {
      field += rest[i];
    } else if (inside_quotes && i + 1 < rest.size() && rest[i + 1] == '"') {
      field += rest[++i];
    } else {
      inside_quotes = !inside_quotes;
    }
  }
  rest.remove_prefix(std::min(i + 1, rest.size()));
  return field;
}

// Rows end at line ends outside of quotes.
std::vector<std::string_view> split_rows(std::string_view text) {
  std::vector<std::string_view> rows;
  bool inside_quotes = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') inside_quotes = !inside_quotes;
    if (text[i] != '\n' || inside_quotes) continue;
    rows.push_back(text.substr(begin, i - begin));
    begin = i + 1;
  }
  if (begin < text.size()) rows.push_back(text.substr(begin));
  return rows;
}

using Key = std::pair<std::string, std::string>;

// A sequence is replaced as a whole, plain files one by one.
Key replacement_key(const std::string& sequence, const std::string& scan) {
  return {sequence, sequence.empty() ? scan : std::string{}};
}

}  // namespace

TimingTable::TimingTable(std::filesystem::path path)
    : path_(std::move(path)), earlier_(read(path_)) {}

std::vector<TimingTable::Line> TimingTable::read(const std::filesystem::path& path) {
  std::vector<Line> lines;
  if (!io::is_there(path)) return lines;
  const std::string text = io::read_text(path);
  const std::vector<std::string_view> rows = split_rows(text);
  if (rows.empty() || rows.front() != kHeader)
    throw io::Error({.file = path,
                     .line = 1,
                     .expected = fmt::format("the header '{}'", kHeader),
                     .got = "another file",
                     .remedy = "move it away or choose another --output"});
  for (const std::string_view row : std::span(rows).subspan(1)) {
    std::string_view rest = row;
    std::string sequence = take_field(rest);
    std::string scan = take_field(rest);
    lines.push_back({std::move(sequence), std::move(scan), std::string(row)});
  }
  return lines;
}

void TimingTable::add(const TimingRow& row) {
  lines_.push_back({row.sequence, row.scan,
                    fmt::format("{},{},{},{:.3f}", io::csv_field(row.sequence),
                                io::csv_field(row.scan), row.points, row.milliseconds)});
}

void TimingTable::write() const {
  std::set<Key> replaced;
  for (const Line& line : lines_) replaced.insert(replacement_key(line.sequence, line.scan));
  std::vector<Line> all = lines_;
  std::copy_if(earlier_.begin(), earlier_.end(), std::back_inserter(all), [&](const Line& line) {
    return !replaced.contains(replacement_key(line.sequence, line.scan));
  });
  std::stable_sort(all.begin(), all.end(), [](const Line& a, const Line& b) {
    return std::tie(a.sequence, a.scan) < std::tie(b.sequence, b.scan);
  });
  io::AtomicFile file(path_);
  file.write(fmt::format("{}\n", kHeader));
  for (const Line& line : all) file.write(line.text + "\n");
  file.commit();
}

}  // namespace groundgrid::program
