#include "io/number_list.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace groundgrid::io {
namespace {

TEST(NumberList, TakesBlanksOfAllKinds) {
  EXPECT_EQ(parse_numbers("  1 -2.5\t3e-2  \r"), (std::vector<double>{1.0, -2.5, 0.03}));
  EXPECT_EQ(parse_numbers(" "), std::vector<double>{});
}

TEST(NumberList, TakesAPlusBeforeANumber) {
  EXPECT_EQ(parse_numbers("+1.0e+00 -1 +.5"), (std::vector<double>{1.0, -1.0, 0.5}));
  for (const char* const line : {"+", "++1", "+-1", "-+1", "1 + 2"})
    EXPECT_FALSE(parse_numbers(line)) << line;
}

TEST(NumberList, TakesWhatADoubleDoesNotHoldAsZeroOrInfinite) {
  const std::string zeros(400, '0');
  EXPECT_EQ(parse_number("1e999"), HUGE_VAL);
  EXPECT_EQ(parse_number("-1.5e+99999999999999999999"), -HUGE_VAL);
  EXPECT_EQ(parse_number("+1" + zeros + "e-50"), HUGE_VAL);
  EXPECT_EQ(parse_number("1e-999"), 0.0);
  EXPECT_EQ(parse_number("0." + zeros + "1e50"), 0.0);
  EXPECT_TRUE(std::signbit(parse_number("-1e-999").value()));
  for (const char* const word : {"1e999x", "++1e999", "1e-999 ", "1e999,5"})
    EXPECT_FALSE(parse_number(word)) << word;
}

TEST(NumberList, TakesTheOutermostNumbersAsTheyAre) {
  EXPECT_EQ(parse_number("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(parse_number("4.9406564584124654e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(parse_number("1e-310"), 1e-310);
}

TEST(NumberList, RejectsWords) {
  EXPECT_FALSE(parse_numbers("1 2x 3"));
  EXPECT_FALSE(parse_numbers("1,2"));
}

TEST(NumberList, MakesARoundedRotationExact) {
  // 0.6 and 0.8 with an error in the fourth digit.
  const std::array rows{0.6003, -0.8, 0.0, 1.0, 0.8, 0.6, 0.0, 2.0, 0.0, 0.0, 1.0, 3.0};
  const auto transform = rigid_transform(rows);
  ASSERT_TRUE(transform);
  const Eigen::Matrix3d product = transform->linear() * transform->linear().transpose();
  EXPECT_TRUE(product.isApprox(Eigen::Matrix3d::Identity(), 1e-14));
  EXPECT_NEAR(transform->linear()(0, 0), 0.6, 5e-4);
  EXPECT_EQ(transform->translation(), Eigen::Vector3d(1.0, 2.0, 3.0));
}

TEST(NumberList, RejectsWhatIsNoRotation) {
  const std::array scaled{1.01, 0., 0., 0., 0., 1.01, 0., 0., 0., 0., 1.01, 0.};
  const std::array mirrored{1., 0., 0., 0., 0., 1., 0., 0., 0., 0., -1., 0.};
  const std::array infinite{1., 0., 0., std::numeric_limits<double>::infinity(), 0., 1., 0., 0., 0.,
                            0., 1., 0.};
  EXPECT_FALSE(rigid_transform(scaled));
  EXPECT_FALSE(rigid_transform(mirrored));
  EXPECT_FALSE(rigid_transform(infinite));
}

TEST(NumberList, TakesWholeNumbersOnly) {
  EXPECT_EQ(parse_whole_number("0"), 0U);
  EXPECT_EQ(parse_whole_number("000042"), 42U);
  EXPECT_EQ(parse_whole_number("18446744073709551615"), std::numeric_limits<std::size_t>::max());
  for (const char* const text : {"", "-1", "+1", " 1", "1 ", "1.0", "x", "18446744073709551616"})
    EXPECT_FALSE(parse_whole_number(text)) << text;
}

TEST(NumberList, SplitsWords) {
  EXPECT_EQ(split_words("  FIELDS x\t\ty \r"), (std::vector<std::string_view>{"FIELDS", "x", "y"}));
  EXPECT_TRUE(split_words(" \t").empty());
}

TEST(NumberList, SplitsLinesOfBothKinds) {
  EXPECT_EQ(split_lines("a\r\n\nb"), (std::vector<std::string_view>{"a", "", "b"}));
  EXPECT_EQ(split_lines("a\n"), (std::vector<std::string_view>{"a"}));
  EXPECT_TRUE(split_lines("").empty());
}

TEST(NumberList, LeavesOutTheByteOrderMarkBeforeTheLines) {
  EXPECT_EQ(split_lines("\xEF\xBB\xBF"
                        "a\nb"),
            (std::vector<std::string_view>{"a", "b"}));
  EXPECT_TRUE(split_lines("\xEF\xBB\xBF").empty());
  // Elsewhere it is a letter as others are, and half of it is none.
  EXPECT_EQ(split_lines("a\n\xEF\xBB\xBF"
                        "b")
                .back(),
            "\xEF\xBB\xBF"
            "b");
  EXPECT_EQ(split_lines("\xEF\xBB").front(), "\xEF\xBB");
}

}  // namespace
}  // namespace groundgrid::io
