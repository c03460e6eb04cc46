#include "io/pcd.hpp"

#include <fmt/format.h>
#include <liblzf/lzf.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "io/binary_records.hpp"
#include "io/coordinate_fields.hpp"
#include "io/error.hpp"
#include "io/field_copy.hpp"
#include "io/input_file.hpp"
#include "io/pcd_header.hpp"
#include "io/text_records.hpp"

namespace groundgrid::io {
namespace {

static_assert(std::endian::native == std::endian::little, "points are read as they lie on disk");

// A reference of three bytes gives 264 bytes at most, so nothing is packed tighter.
constexpr std::uint64_t kMostPerCompressedByte = 88;

struct CompressedSizes {
  std::uint32_t compressed = 0;
  std::uint32_t uncompressed = 0;
};

CompressedSizes read_sizes(InputFile& file, const PointCloud& cloud) {
  const std::uintmax_t place = file.position();
  const auto require = [&](bool holds, const std::string& expected, const std::string& got) {
    if (holds) return;
    throw Error({.file = file.path(),
                 .offset = place,
                 .expected = expected,
                 .got = got,
                 .remedy = "the file is cut short or damaged; fetch it again"});
  };
  CompressedSizes sizes;
  require(file.remaining() >= sizeof sizes, "8 bytes with the sizes of the compressed points",
          fmt::format("{} bytes", file.remaining()));
  file.read(&sizes, sizeof sizes);
  require(sizes.compressed <= file.remaining(),
          fmt::format("{} bytes of compressed points", sizes.compressed),
          fmt::format("{} bytes", file.remaining()));
  require(sizes.uncompressed / cloud.stride_bytes == cloud.size() &&
              sizes.uncompressed % cloud.stride_bytes == 0,
          fmt::format("{} points of {} bytes, as the header promises", cloud.size(),
                      cloud.stride_bytes),
          fmt::format("{} bytes once uncompressed", sizes.uncompressed));
  require(sizes.uncompressed <= kMostPerCompressedByte * sizes.compressed,
          fmt::format("compressed points that give {} bytes", sizes.uncompressed),
          fmt::format("{} bytes, which cannot give so many", sizes.compressed));
  return sizes;
}

std::vector<std::byte> uncompress(InputFile& file, const CompressedSizes& sizes) {
  const std::uintmax_t place = file.position();
  std::vector<std::byte> compressed;
  std::vector<std::byte> planes;
  file.read_into(compressed, sizes.compressed);
  file.resize(planes, sizes.uncompressed);
  const unsigned int got =
      lzf_decompress(compressed.data(), sizes.compressed, planes.data(), sizes.uncompressed);
  if (got != sizes.uncompressed)
    throw Error(
        {.file = file.path(),
         .offset = place,
         .expected = fmt::format("compressed points that give {} bytes", sizes.uncompressed),
         .got = got == 0 ? "bytes that are no LZF data or give more" : fmt::format("{}", got),
         .remedy = "the file is damaged; fetch it again"});
  return planes;
}

template <std::size_t kBytes>
void scatter(const std::byte* plane, std::size_t points, std::size_t stride, std::byte* place) {
  for (std::size_t i = 0; i < points; ++i)
    std::memcpy(place + i * stride, plane + i * kBytes, kBytes);
}

// Compressed points lie field by field: all x, then all y, and so on.
void read_compressed_records(InputFile& file, PointCloud& cloud) {
  if (cloud.size() == 0) {
    // Some write the sizes of nothing, some do not.
    file.skip(std::min<std::uintmax_t>(file.remaining(), sizeof(CompressedSizes)));
    return;
  }
  const std::vector<std::byte> planes = uncompress(file, read_sizes(file, cloud));
  file.resize(cloud.data, cloud.size() * cloud.stride_bytes);
  const std::byte* plane = planes.data();
  for (const PointField& field : cloud.fields) {
    std::byte* const place = cloud.data.data() + field.offset;
    switch (field.bytes()) {
      case 1:
        scatter<1>(plane, cloud.size(), cloud.stride_bytes, place);
        break;
      case 2:
        scatter<2>(plane, cloud.size(), cloud.stride_bytes, place);
        break;
      case 4:
        scatter<4>(plane, cloud.size(), cloud.stride_bytes, place);
        break;
      case 8:
        scatter<8>(plane, cloud.size(), cloud.stride_bytes, place);
        break;
      default:
        for (std::size_t i = 0; i < cloud.size(); ++i)
          std::memcpy(place + i * cloud.stride_bytes, plane + i * field.bytes(), field.bytes());
    }
    plane += cloud.size() * field.bytes();
  }
}

void read_records(InputFile& file, PointCloud& cloud) {
  if (cloud.encoding == CloudEncoding::ascii) {
    TextRecords text(file);
    text.read(cloud);
    text.require_end();
  } else if (cloud.encoding == CloudEncoding::binary) {
    read_binary_records(file, cloud);
  } else {
    read_compressed_records(file, cloud);
  }
}

}  // namespace

void read_pcd(const std::filesystem::path& path, PointCloud& cloud) {
  InputFile file(path);
  read_pcd_header(file, cloud);
  name_coordinates(path, cloud);
  read_records(file, cloud);
  cloud.surplus_bytes = static_cast<std::size_t>(file.remaining());
  drop_padding(cloud);
}

}  // namespace groundgrid::io
