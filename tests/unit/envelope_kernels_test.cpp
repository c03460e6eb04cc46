#include "core/envelope_kernels.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "support/instruction_sets.hpp"

namespace groundgrid {
namespace {

using Steps = std::vector<std::int32_t>;

/// Some heights among cells where nothing is known.
Steps envelope_row(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  Steps row(count, kNoEnvelope);
  for (std::int32_t& height : row)
    if (random() % 3 == 0) height = static_cast<std::int32_t>(random() % 20001) - 10000;
  return row;
}

class EnvelopeKernels : public testing::OnInstructionSet {};

TEST_P(EnvelopeKernels, SpreadAcrossTakesTheLeastOfThreeBeside) {
  constexpr EnvelopeRise kRise{700, 990};
  for (std::size_t count = 1; count <= 70; ++count) {
    const Steps from = envelope_row(count, 1);
    Steps row = envelope_row(count, 2);
    Steps expected = row;
    for (std::size_t x = 0; x < count; ++x) {
      expected[x] = std::min(expected[x], from[x] + kRise.straight);
      if (x > 0) expected[x] = std::min(expected[x], from[x - 1] + kRise.diagonal);
      if (x + 1 < count) expected[x] = std::min(expected[x], from[x + 1] + kRise.diagonal);
    }
    spread_across(from.data(), row.data(), count, kRise);
    EXPECT_EQ(row, expected) << count;
  }
}

TEST_P(EnvelopeKernels, SpreadForwardIsTheRecurrence) {
  for (const std::int32_t rise : {0, 1, 700})
    for (std::size_t count = 1; count <= 70; ++count) {
      Steps row = envelope_row(count, 3);
      Steps expected = row;
      for (std::size_t x = 1; x < count; ++x)
        expected[x] = std::min(expected[x], expected[x - 1] + rise);
      spread_forward(row.data(), count, rise);
      EXPECT_EQ(row, expected) << count;
    }
}

TEST_P(EnvelopeKernels, SpreadBackwardIsTheRecurrence) {
  for (const std::int32_t rise : {0, 1, 700})
    for (std::size_t count = 1; count <= 70; ++count) {
      Steps row = envelope_row(count, 4);
      Steps expected = row;
      for (std::size_t x = count - 1; x-- > 0;)
        expected[x] = std::min(expected[x], expected[x + 1] + rise);
      spread_backward(row.data(), count, rise);
      EXPECT_EQ(row, expected) << count;
    }
}

TEST_P(EnvelopeKernels, OneHeightRisesToBothEnds) {
  Steps row(23, kNoEnvelope);
  row[11] = -50;
  spread_forward(row.data(), row.size(), 7);
  spread_backward(row.data(), row.size(), 7);
  for (int x = 0; x < 23; ++x)
    EXPECT_EQ(row[static_cast<std::size_t>(x)], -50 + 7 * std::abs(x - 11)) << x;
}

// A network that puts all rows of zeros and ones in order puts all rows of numbers in order.
TEST_P(EnvelopeKernels, MedianRowOfAllZerosAndOnes) {
  constexpr std::size_t kPatterns = 512;
  // Three columns of each pattern stand side by side; medians across two patterns are not looked
  // at.
  std::vector<float> rows[3];
  for (unsigned pattern = 0; pattern < kPatterns; ++pattern)
    for (unsigned place = 0; place < 9; ++place)
      rows[place / 3].push_back(static_cast<float>(pattern >> place & 1U));
  const std::size_t count = 3 * kPatterns - 2;
  std::vector<float> medians(count), weights(count);
  median_row({rows[0].data(), rows[1].data(), rows[2].data()}, count, medians.data(),
             weights.data());
  for (unsigned pattern = 0; pattern < kPatterns; ++pattern) {
    EXPECT_EQ(medians[3 * pattern], std::popcount(pattern) >= 5 ? 1.0F : 0.0F) << pattern;
    EXPECT_EQ(weights[3 * pattern], 1.0F);
  }
}

TEST_P(EnvelopeKernels, MedianRowLeavesOutWhatIsNotThere) {
  std::mt19937 random(6);
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  for (const unsigned known_of_ten : {0U, 2U, 5U, 9U}) {
    for (std::size_t count = 1; count <= 40; ++count) {
      std::vector<float> rows[3];
      for (std::vector<float>& row : rows)
        for (std::size_t i = 0; i < count + 2; ++i)
          row.push_back(random() % 10 < known_of_ten ? static_cast<float>(random() % 99) : kNone);
      std::vector<float> medians(count + 1, -7.0F), weights(count + 1, -7.0F);
      median_row({rows[0].data(), rows[1].data(), rows[2].data()}, count, medians.data(),
                 weights.data());
      for (std::size_t i = 0; i < count; ++i) {
        std::vector<float> known;
        for (const std::vector<float>& row : rows)
          for (std::size_t x = i; x < i + 3; ++x)
            if (!std::isnan(row[x])) known.push_back(row[x]);
        std::sort(known.begin(), known.end());
        EXPECT_EQ(medians[i], known.empty() ? 0.0F : known[known.size() / 2]) << count;
        EXPECT_EQ(weights[i], known.empty() ? 0.0F : 1.0F) << count;
      }
      EXPECT_EQ(medians[count], -7.0F);
      EXPECT_EQ(weights[count], -7.0F);
    }
  }
}

TEST_P(EnvelopeKernels, RankedIsThePlaceInOrderWithTies) {
  std::mt19937 random(5);
  for (std::size_t count = 1; count <= 130; ++count) {
    // Lower than all of them: a number behind the last that is ranked would change the answer.
    std::vector<float> values(count + kRankSpare, -1e9F);
    for (std::size_t i = 0; i < count; ++i)
      values[i] = 0.25F * static_cast<float>(random() % (count / 2 + 1)) - 3.0F;
    std::vector<float> sorted(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t rank = 0; rank < count; ++rank)
      EXPECT_EQ(ranked(values.data(), count, rank), sorted[rank]) << rank << " of " << count;
  }
}

INSTANTIATE_TEST_SUITE_P(With, EnvelopeKernels, testing::all_instruction_sets(), testing::name_of);

}  // namespace
}  // namespace groundgrid
