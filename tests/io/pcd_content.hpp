#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cloud_checks.hpp"

namespace groundgrid::test {

inline io::PointCloud read_pcd(std::string_view content) {
  return read_content(content, io::ScanFormat::pcd);
}

inline std::string error_in_pcd(std::string_view content) {
  return error_in(content, io::ScanFormat::pcd);
}

inline std::string bytes_of(const std::vector<float>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(float)};
}

inline std::string bytes_of(std::uint32_t number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

}  // namespace groundgrid::test
