#include "io/bin_layout.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cloud_checks.hpp"
#include "io/bin_layout_guess.hpp"
#include "io/bin_scan.hpp"
#include "io/scan_sequence.hpp"
#include "shared_data.hpp"

namespace groundgrid::io {
namespace {

namespace fs = std::filesystem;
using test::contains;

constexpr std::size_t kRoadPoints = 900;

// A level road with a wall beside it, in any layout: what has no letter there is left out.
template <typename Float>
std::vector<Float> road(std::string_view letters, std::size_t points = kRoadPoints) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<Float> numbers;
  for (std::size_t i = 0; i < points; ++i) {
    const double azimuth = 2.0 * M_PI * share(random);
    const double range = 4.0 + 36.0 * share(random);
    const double y = range * std::sin(azimuth);
    const double z = y > 10.0 ? -1.73 + 4.0 * share(random) : -1.73;
    for (const char letter : letters) {
      const double number = letter == 'x'   ? range * std::cos(azimuth)
                            : letter == 'y' ? std::fmin(y, 10.0)
                            : letter == 'z' ? z
                            : letter == 'i' ? share(random)
                            : letter == 'r' ? static_cast<double>(i % 16)
                                            : 0.1 * static_cast<double>(i) / kRoadPoints;
      numbers.push_back(static_cast<Float>(number));
    }
  }
  return numbers;
}

// The names of the likely layouts of these numbers, as of a file with the ending .bin.
template <typename Number>
test::Names likely(const std::vector<Number>& numbers) {
  test::Names names;
  for (const BinLayout& layout : likely_layouts(std::as_bytes(std::span(numbers)), kKittiLayout))
    names.push_back(layout.name());
  return names;
}

TEST(BinLayout, IsNamedByTheLettersOfItsNumbers) {
  const auto layout = BinLayout::named("xyz_i_t");
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->name(), "xyz_i_t");
  EXPECT_EQ(layout->bytes(), 28U);
  EXPECT_EQ(layout->words(), "x y z _ intensity _ time, 32-bit floats");
  EXPECT_EQ(BinLayout::named("xyzi"), kKittiLayout);
  EXPECT_EQ(BinLayout::named("ryxz:f64")->bytes(), 32U);
  EXPECT_EQ(BinLayout::named("ryxz:f64")->name(), "ryxz:f64");
}

TEST(BinLayout, HasNoOtherLettersAndEveryCoordinateOnce) {
  for (const char* const name : {"", "xy", "xyzx", "xyzii", "xyzq", "xyz:f32", ":f64", "XYZ"})
    EXPECT_FALSE(BinLayout::named(name)) << name;
  EXPECT_TRUE(BinLayout::named("xyz" + std::string(BinLayout::kMostNumbers - 3, '_')));
  EXPECT_FALSE(BinLayout::named("xyz" + std::string(BinLayout::kMostNumbers - 2, '_')));
}

TEST(LikelyLayouts, AreTheOneThatTheNumbersHave) {
  for (const char* const letters : {"xyz", "xyzi", "xyzir", "xyzirt"}) {
    EXPECT_EQ(likely(road<float>(letters)), test::Names{letters});
    EXPECT_EQ(likely(road<float>(letters, 120)), test::Names{letters}) << "few points";
  }
  EXPECT_EQ(likely(road<double>("xyz")), test::Names{"xyz:f64"});
  EXPECT_EQ(likely(road<double>("xyzi")), test::Names{"xyzi:f64"});
}

TEST(LikelyLayouts, OfDoublesThatWereFloatsAreThoseOfDoubles) {
  const std::vector<float> floats = road<float>("xyzi");
  EXPECT_EQ(likely(std::vector<double>(floats.begin(), floats.end())), test::Names{"xyzi:f64"});
}

TEST(LikelyLayouts, AreTheUsualOneIfTheNumbersAreTooFewOrAlike) {
  EXPECT_EQ(likely(std::vector<float>{1, 2, -1, 0.5F, 3, 4, -1, 0.5F, 5, 6, -1, 0.5F}),
            test::Names{"xyzi"});
  EXPECT_EQ(likely(std::vector<float>(240, 0.0F)), test::Names{"xyzi"});
  EXPECT_EQ(likely(std::vector<float>(240, std::nanf(""))), test::Names{"xyzi"});
}

TEST(LikelyLayouts, AreTheOnlyOneWhoseSizeFits) {
  EXPECT_EQ(likely(std::vector<float>{1, 2, 3, 4, 5}), test::Names{"xyzir"});
}

TEST(LikelyLayouts, AreToldInTheFrameOfAMapToo) {
  std::vector<float> numbers = road<float>("xyzi");
  for (std::size_t i = 0; i < numbers.size(); i += 4) {
    numbers[i] += 450000.0F;
    numbers[i + 1] += 5.4e6F;
  }
  EXPECT_EQ(likely(numbers), test::Names{"xyzi"});
}

TEST(LikelyLayouts, AreNoneIfTheNumbersAreNoCoordinates) {
  std::mt19937 random(1);
  std::vector<std::uint32_t> noise(4800);
  for (std::uint32_t& word : noise) word = static_cast<std::uint32_t>(random());
  EXPECT_EQ(likely(noise), test::Names{});
  std::vector<std::int32_t> counters(4800);
  for (std::size_t i = 0; i < counters.size(); ++i) counters[i] = static_cast<std::int32_t>(i);
  EXPECT_EQ(likely(counters), test::Names{});
}

TEST(LikelyLayouts, AreSeveralIfTheNumbersLeaveAChoice) {
  // Some numbers repeat their sizes every third one, as those of x y z do, and some every fifth.
  std::mt19937 random(1);
  std::vector<float> numbers;
  for (std::size_t i = 0; i < 4800; ++i)
    numbers.push_back(std::ldexp(1.0F, random() % 5 < 3 ? static_cast<int>(2 * (i % 3))
                                                        : -2 - static_cast<int>(2 * (i % 5))));
  EXPECT_EQ(likely(numbers), (test::Names{"xyzir", "xyz"}));
}

class LayoutOfASequence : public ::testing::Test {
 protected:
  [[nodiscard]] std::string layout_of(const fs::path& input) const {
    return name_of(find_sequences(input).front().scans.front().format);
  }

  test::TemporaryFolder folder;
};

TEST_F(LayoutOfASequence, IsThatOfTheFirstScanThatTells) {
  test::write_file(folder / "0.bin", "");
  test::write_numbers(folder / "1.bin", road<float>("xyz"));
  test::write_numbers(folder / "2.bin", road<float>("xyzi"));
  test::write_file(folder / "3.ply", "");
  const ScanSequence sequence = find_sequences(folder.path()).front();
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(name_of(sequence.scans[i].format), "xyz");
  EXPECT_EQ(sequence.scans[3].format, ScanFormat::ply);
  PointCloud cloud;
  read_scan(sequence.scans[1], cloud);
  EXPECT_EQ(cloud.size(), kRoadPoints);
  const std::string message = test::message_of<Error>([&] { read_scan(sequence.scans[2], cloud); });
  EXPECT_TRUE(contains(message,
                       "2.bin: expected points of x y z, 32-bit floats, got numbers that "
                       "lie as in kitti (x y z intensity, 32-bit floats)"));
  EXPECT_TRUE(contains(message, "--format"));
  EXPECT_EQ(cloud.size(), 0U);
}

TEST_F(LayoutOfASequence, IsWhatTheFormatSaysIfItIsGiven) {
  test::write_numbers(folder / "a.bin", road<float>("xyzir", 800));
  const ScanSequence sequence =
      find_sequences(folder.path(), {}, scan_format_named("xyzi")).front();
  PointCloud cloud;
  read_scan(sequence.scans.front(), cloud);
  EXPECT_EQ(cloud.size(), 1000U);
}

TEST_F(LayoutOfASequence, MayDifferFromThatOfTheNameOfNuscenes) {
  test::write_numbers(folder / "a.pcd.bin", road<float>("xyzi"));
  EXPECT_EQ(layout_of(folder.path()), "kitti");
  test::write_numbers(folder / "a.pcd.bin", road<float>("xyzir"));
  EXPECT_EQ(layout_of(folder.path()), "nuscenes");
}

TEST_F(LayoutOfASequence, LeavesWhatIsNoScanToReading) {
  test::write_numbers(folder / "a.bin", std::vector<float>(480, 1e9F));
  const ScanSequence sequence = find_sequences(folder.path()).front();
  PointCloud cloud;
  const std::string message =
      test::message_of<Error>([&] { read_scan(sequence.scans.front(), cloud); });
  EXPECT_TRUE(contains(
      message,
      "expected coordinates in metres (x y z intensity, 32-bit floats), got numbers that are none "
      "in any layout"));
  EXPECT_TRUE(contains(message, "say its layout with --format"));
}

class RealLayout : public test::WithSharedData {
 protected:
  static std::vector<fs::path> bin_files() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(data()))
      if (entry.path().extension() == ".bin") files.push_back(entry.path());
    return files;
  }

  static test::Names likely_with_name(const fs::path& path, const std::vector<float>& numbers) {
    test::Names names;
    const auto bytes = std::as_bytes(std::span(numbers));
    for (const BinLayout& layout : likely_layouts(bytes, format_by_name(path)->layout))
      names.push_back(layout.name());
    return names;
  }
};

TEST_F(RealLayout, IsThatOfTheFilesName) {
  const std::vector<fs::path> files = bin_files();
  ASSERT_GE(files.size(), 100U);
  for (const fs::path& path : files)
    EXPECT_EQ(guess_layout(path, format_by_name(path)->layout), format_by_name(path)->layout)
        << path;
}

// Every real scan, with fewer and more numbers a point.
TEST_F(RealLayout, IsTold) {
  for (const fs::path& path : bin_files()) {
    PointCloud cloud;
    read_scan(path, *format_by_name(path), cloud);
    const std::size_t points = cloud.size() / 240 * 240;
    for (const std::string letters : {"xyz", "xyzi", "xyzir", "xyzirt"}) {
      std::vector<float> numbers;
      for (std::size_t i = 0; i < points; ++i) {
        for (std::size_t field = 0; field < 3; ++field)
          numbers.push_back(static_cast<float>(value_at(cloud, i, cloud.fields[field])));
        if (letters.size() > 3)
          numbers.push_back(static_cast<float>(value_at(cloud, i, *cloud.find("intensity"))));
        if (letters.size() > 4) numbers.push_back(static_cast<float>(i % 64));
        if (letters.size() > 5) numbers.push_back(1e-6F * static_cast<float>(i));
      }
      ASSERT_EQ(likely_with_name(path, numbers), test::Names{letters}) << path;
    }
  }
}

}  // namespace
}  // namespace groundgrid::io
