#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/error.hpp"
#include "io/point_cloud.hpp"
#include "io/scan_file.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::test {

/// The names of a cloud's fields, in their order.
inline Names names_of(const io::PointCloud& cloud) {
  Names names;
  for (const io::PointField& field : cloud.fields) names.push_back(field.name);
  return names;
}

/// The first number of a field for every point.
inline std::vector<double> values_of(const io::PointCloud& cloud, std::string_view name) {
  std::vector<double> values;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    values.push_back(value_at(cloud, i, *cloud.find(name)));
  return values;
}

/// Every value of the field is finite and in the closed interval.
inline void expect_values_between(const io::PointCloud& cloud, std::string_view name, double least,
                                  double most) {
  ASSERT_NE(cloud.find(name), nullptr) << name;
  for (const double value : values_of(cloud, name)) {
    ASSERT_GE(value, least) << name;
    ASSERT_LE(value, most) << name;
  }
}

/// The words of the Error that reading this file must end with.
inline std::string error_of(const std::filesystem::path& path, io::ScanFormat format) {
  io::PointCloud cloud;
  return message_of<io::Error>([&] { read_scan(path, format, cloud); });
}

/// Reads a file with this content, which must be a scan.
inline io::PointCloud read_content(std::string_view content, io::ScanFormat format) {
  const TemporaryFolder folder;
  write_file(folder / "scan", content);
  io::PointCloud cloud;
  read_scan(folder / "scan", format, cloud);
  return cloud;
}

/// The words of the Error that reading a file with this content must end with, from its name on.
inline std::string error_in(std::string_view content, io::ScanFormat format) {
  const TemporaryFolder folder;
  write_file(folder / "scan", content);
  const std::string message = error_of(folder / "scan", format);
  return message.substr(std::min(message.size(), folder.path().string().size() + 1));
}

}  // namespace groundgrid::test
