#include "io/labelled_cloud.hpp"

#include <fmt/format.h>

#include <cstring>
#include <stdexcept>
#include <string_view>

#include "io/field_copy.hpp"
#include "io/pcd_writer.hpp"
#include "io/ply_writer.hpp"

namespace groundgrid::io {
namespace {

constexpr std::string_view kLabel = "label";
constexpr std::string_view kHeight = "height_above_ground";

template <typename Number>
void write_field(PointCloud& cloud, const PointField& field, std::span<const Number> numbers) {
  for (std::size_t point = 0; point < numbers.size(); ++point)
    std::memcpy(cloud.data.data() + point * cloud.stride_bytes + field.offset, &numbers[point],
                sizeof(Number));
}

PointCloud with_answers(const PointCloud& cloud, std::span<const std::uint32_t> labels,
                        std::span<const float> height_above_ground) {
  PointCloud labelled;
  labelled.width = cloud.width;
  labelled.height = cloud.height;
  labelled.encoding = cloud.encoding;
  labelled.viewpoint = cloud.viewpoint;
  FieldCopy copy;
  for (const PointField& field : cloud.fields)
    if (field.name != kLabel && field.name != kHeight) copy.add(field, labelled);
  labelled.add_field(std::string(kLabel), FieldType::uint32);
  labelled.add_field(std::string(kHeight), FieldType::float32);
  labelled.data.resize(labelled.size() * labelled.stride_bytes);
  copy.copy(cloud.data.data(), cloud.stride_bytes, labelled.data.data(), labelled.stride_bytes,
            cloud.size());
  write_field(labelled, *labelled.find(kLabel), labels);
  write_field(labelled, *labelled.find(kHeight), height_above_ground);
  return labelled;
}

}  // namespace

void write_labelled_cloud(const std::filesystem::path& path, ScanFormat format,
                          const PointCloud& cloud, std::span<const std::uint32_t> labels,
                          std::span<const float> height_above_ground, FileBatch* batch) {
  if (labels.size() != cloud.size() || height_above_ground.size() != cloud.size())
    throw std::invalid_argument(fmt::format("{} points, but {} labels and {} heights", cloud.size(),
                                            labels.size(), height_above_ground.size()));
  if (format != ScanFormat::pcd && format != ScanFormat::ply)
    throw std::invalid_argument("labelled clouds are written as pcd or ply");
  const PointCloud labelled = with_answers(cloud, labels, height_above_ground);
  if (format == ScanFormat::pcd)
    write_pcd(path, labelled, batch);
  else
    write_ply(path, labelled, batch);
}

}  // namespace groundgrid::io
