#include "io/coordinate_fields.hpp"

#include <fmt/format.h>

#include <set>
#include <string>
#include <string_view>

#include "io/error.hpp"

namespace groundgrid::io {
namespace {

std::string list_of_fields(const PointCloud& cloud) {
  constexpr std::size_t kMost = 30;
  std::string list;
  for (std::size_t i = 0; i < cloud.fields.size() && i < kMost; ++i)
    list += fmt::format("{}{}", i == 0 ? "" : ", ", in_quotes(cloud.fields[i].name));
  if (cloud.fields.size() > kMost) list += fmt::format(" and {} more", cloud.fields.size() - kMost);
  return list.empty() ? "none" : list;
}

void require_single_names(const std::filesystem::path& path, const PointCloud& cloud) {
  std::set<std::string_view> names;
  for (const PointField& field : cloud.fields)
    if (field.name != kPaddingName && !names.insert(field.name).second)
      throw Error({.file = path,
                   .expected = "every field once",
                   .got = fmt::format("{} twice", in_quotes(field.name)),
                   .remedy = "rename one of them in the header"});
}

PointField* find(PointCloud& cloud, std::string_view name) {
  for (PointField& field : cloud.fields)
    if (field.name == name) return &field;
  return nullptr;
}

}  // namespace

void name_coordinates(const std::filesystem::path& path, PointCloud& cloud) {
  require_single_names(path, cloud);
  for (const auto& [lower, upper] : {std::pair{"x", "X"}, {"y", "Y"}, {"z", "Z"}}) {
    PointField* field = find(cloud, lower);
    if (field == nullptr) field = find(cloud, upper);
    if (field == nullptr)
      throw Error({.file = path,
                   .expected = "the fields x, y and z",
                   .got = fmt::format("no {} among the fields {}", lower, list_of_fields(cloud)),
                   .remedy = "rename the fields of the coordinates in the header"});
    if (field->count != 1)
      throw Error({.file = path,
                   .expected = fmt::format("one {} a point", lower),
                   .got = fmt::format("{}", field->count)});
    field->name = lower;
  }
}

}  // namespace groundgrid::io
