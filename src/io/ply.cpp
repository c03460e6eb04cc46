#include "io/ply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "io/binary_records.hpp"
#include "io/coordinate_fields.hpp"
#include "io/error.hpp"
#include "io/field_number.hpp"
#include "io/input_file.hpp"
#include "io/ply_header.hpp"
#include "io/text_records.hpp"

namespace groundgrid::io {
namespace {

static_assert(std::endian::native == std::endian::little, "points are read as they lie on disk");

using Elements = std::span<const PlyElement>;

std::size_t find_vertices(const InputFile& file, Elements elements) {
  std::string others;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i].name == "vertex") return i;
    if (i < 10) others += fmt::format(" {}", in_quotes(elements[i].name));
  }
  throw Error({.file = file.path(),
               .expected = "an element 'vertex' in the header",
               .got = others.empty() ? "no element" : fmt::format("the elements{}", others)});
}

bool have_records(Elements elements) {
  return std::any_of(elements.begin(), elements.end(), [](const PlyElement& element) {
    return element.count > 0 && !element.properties.empty();
  });
}

void add_fields(const PlyElement& vertices, PointCloud& cloud) {
  for (const PlyProperty& property : vertices.properties)
    if (!property.count_type) cloud.add_field(property.name, property.type);
  cloud.width = vertices.count;
}

// The fields before which a list stands.
std::vector<std::size_t> places_of_lists(const PlyElement& vertices) {
  std::vector<std::size_t> places;
  std::size_t fields = 0;
  for (const PlyProperty& property : vertices.properties)
    if (property.count_type)
      places.push_back(fields);
    else
      ++fields;
  return places;
}

/// Moves over elements in front of the points of a binary file, and over lists.
class ElementSkipper {
 public:
  ElementSkipper(InputFile& file, bool big_endian) : file_(file), big_endian_(big_endian) {}

  void skip(const PlyElement& element) {
    if (!element.has_lists()) return skip(element, element.count, element.bytes());
    for (std::size_t i = 0; i < element.count; ++i)
      for (const PlyProperty& property : element.properties)
        if (property.count_type)
          skip_list(element, property);
        else
          skip(element, 1, size_of(property.type));
  }

  void skip_list(const PlyElement& element, const PlyProperty& list) {
    skip(element, read_count(element, *list.count_type), size_of(list.type));
  }

 private:
  void skip(const PlyElement& element, std::uintmax_t numbers, std::uintmax_t bytes) {
    if (bytes == 0 || numbers == 0) return;
    if (numbers > file_.remaining() / bytes) fail(element);
    file_.skip(numbers * bytes);
  }

  std::uintmax_t read_count(const PlyElement& element, FieldType type) {
    std::array<std::byte, sizeof(double)> bytes{};
    const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(size_of(type));
    if (file_.remaining() < size_of(type)) fail(element);
    file_.read(bytes.data(), size_of(type));
    if (big_endian_) std::reverse(bytes.begin(), end);
    const double count = with_number(type, [&](auto number) {
      std::memcpy(&number, bytes.data(), sizeof number);
      return static_cast<double>(number);
    });
    // Also false for NaN. No list of the file is longer than what is left of it.
    if (!(count >= 0.0 && count <= static_cast<double>(file_.remaining()))) fail(element);
    return static_cast<std::uintmax_t>(count);
  }

  [[noreturn]] void fail(const PlyElement& element) const {
    throw Error({.file = file_.path(),
                 .offset = file_.position(),
                 .expected = fmt::format("{} whole records of the element {}", element.count,
                                         in_quotes(element.name)),
                 .got = "the end of the file among them",
                 .remedy = "the file is cut short or damaged; fetch it again"});
  }

  InputFile& file_;
  bool big_endian_;
};

// Vertices with lists are of any length.
void read_records_with_lists(InputFile& file, const PlyElement& vertices, ElementSkipper& skipper,
                             PointCloud& cloud) {
  require_records(file, cloud);
  file.resize(cloud.data, cloud.size() * cloud.stride_bytes);
  std::byte* place = cloud.data.data();
  for (std::size_t i = 0; i < vertices.count; ++i)
    for (const PlyProperty& property : vertices.properties) {
      if (property.count_type) {
        skipper.skip_list(vertices, property);
        continue;
      }
      file.read(place, size_of(property.type));
      place += size_of(property.type);
    }
}

void read_text(InputFile& file, Elements before, const PlyElement& vertices, PointCloud& cloud) {
  TextRecords text(file);
  // A record without properties has no line.
  for (const PlyElement& element : before)
    if (!element.properties.empty()) text.skip(element.count);
  text.read(cloud, places_of_lists(vertices));
}

void read_binary(InputFile& file, Elements before, const PlyElement& vertices, PointCloud& cloud) {
  const bool big_endian = cloud.encoding == CloudEncoding::binary_big_endian;
  ElementSkipper skipper(file, big_endian);
  for (const PlyElement& element : before) skipper.skip(element);
  if (vertices.has_lists())
    read_records_with_lists(file, vertices, skipper, cloud);
  else
    read_binary_records(file, cloud);
  if (big_endian) swap_bytes(cloud);
}

}  // namespace

void read_ply(const std::filesystem::path& path, PointCloud& cloud) {
  InputFile file(path);
  const PlyHeader header = read_ply_header(file);
  const Elements elements(header.elements);
  const std::size_t vertices = find_vertices(file, elements);
  cloud.encoding = header.encoding;
  add_fields(elements[vertices], cloud);
  name_coordinates(path, cloud);
  if (cloud.encoding == CloudEncoding::ascii)
    read_text(file, elements.first(vertices), elements[vertices], cloud);
  else
    read_binary(file, elements.first(vertices), elements[vertices], cloud);
  if (!have_records(elements.subspan(vertices + 1)))
    cloud.surplus_bytes = static_cast<std::size_t>(file.remaining());
}

}  // namespace groundgrid::io
