// What the writers of scans leave where the disk is full: what was there before, and nothing else.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "io/error.hpp"
#include "io/labelled_cloud.hpp"
#include "io/semantic_kitti_labels.hpp"
#include "support/limited_file_size.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::io {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::files_below;
using test::message_of;
using test::Names;

constexpr std::size_t kPoints = 1000;

void write_some_labels(const fs::path& path) {
  write_labels(path, std::vector<std::uint32_t>(kPoints, 40));
}

std::function<void(const fs::path&)> cloud_writer(ScanFormat format, CloudEncoding encoding) {
  PointCloud cloud;
  cloud.encoding = encoding;
  for (const char* const name : {"x", "y", "z"}) cloud.add_field(name, FieldType::float32);
  cloud.width = kPoints;
  // Numbers that do not become few bytes where they are compressed.
  std::uint32_t number = 1;
  for (std::size_t i = 0; i < kPoints * cloud.stride_bytes; ++i)
    cloud.data.push_back(static_cast<std::byte>((number = number * 1664525U + 1013904223U) >> 25U));
  return [cloud, format](const fs::path& path) {
    write_labelled_cloud(path, format, cloud, std::vector<std::uint32_t>(kPoints, 40),
                         std::vector<float>(kPoints, 0.5F));
  };
}

struct NamedWriter {
  const char* name;
  std::function<void(const fs::path&)> write;
};

class WriterOnAFullDisk : public ::testing::TestWithParam<NamedWriter> {};

TEST_P(WriterOnAFullDisk, LeavesTheOldFile) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "a", "old");
  for (const rlim_t bytes : {0U, 1U, 3000U}) {
    const test::LimitedFileSize limit(bytes);
    EXPECT_TRUE(contains(message_of<Error>([&] { GetParam().write(folder / "a"); }),
                         "a: expected a place to write to, got File too large"));
  }
  EXPECT_EQ(test::read_file(folder / "a"), "old");
  EXPECT_EQ(files_below(folder.path()), (Names{"a"}));
  GetParam().write(folder / "a");
  EXPECT_GT(fs::file_size(folder / "a"), 3000U);
}

INSTANTIATE_TEST_SUITE_P(
    Formats, WriterOnAFullDisk,
    ::testing::Values(
        NamedWriter{"labels", write_some_labels},
        NamedWriter{"pcd_ascii", cloud_writer(ScanFormat::pcd, CloudEncoding::ascii)},
        NamedWriter{"pcd_binary", cloud_writer(ScanFormat::pcd, CloudEncoding::binary)},
        NamedWriter{"pcd_compressed",
                    cloud_writer(ScanFormat::pcd, CloudEncoding::binary_compressed)},
        NamedWriter{"ply_ascii", cloud_writer(ScanFormat::ply, CloudEncoding::ascii)},
        NamedWriter{"ply_binary", cloud_writer(ScanFormat::ply, CloudEncoding::binary)}),
    [](const auto& writer) { return std::string(writer.param.name); });

}  // namespace
}  // namespace groundgrid::io
