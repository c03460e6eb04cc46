#include "core/kernels/surface_kernels.hpp"

#include <cmath>
#include <random>
#include <vector>

#include "support/instruction_sets.hpp"

namespace groundgrid {
namespace {

constexpr HeightTolerance kTolerance{0.125F, 0.25F};

/// Two rows of blocks a quarter of the way apart, with the surface between them.
struct SlopingSurface {
  SurfaceRow lower{};
  SurfaceRow upper{};
  SurfaceBetween between{};
  std::vector<float> there{};

  explicit SlopingSurface(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto x = static_cast<float>(i);
      lower.height.push_back(1.0F + 0.125F * x);
      lower.slope_y.push_back(0.25F);
      upper.height.push_back(3.0F);
      upper.slope_y.push_back(-0.5F);
      // Exact: 1 + x/8 + 1/4 · 2 and 3 + 1/2 · 4, a quarter of the way.
      there.push_back(0.75F * (1.5F + 0.125F * x) + 0.25F * 5.0F);
    }
    between = {&lower, &upper, 2.0F, -4.0F, 0.25F};
  }
};

/// Heights some sixteenths of a metre off the surface, a run of them unknown.
std::vector<float> heights_around(const std::vector<float>& surface, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::vector<float> heights;
  bool known = true;
  for (const float at : surface) {
    if (random() % 6 == 0) known = !known;
    const float off = 0.0625F * (static_cast<float>(random() % 33) - 16.0F);
    heights.push_back(known ? at + off : kUnknownHeight);
  }
  return heights;
}

class SurfaceKernels : public testing::OnInstructionSet {};

TEST_P(SurfaceKernels, CollectKnownTakesGroundThenMemory) {
  for (std::size_t count = 0; count <= 70; ++count) {
    std::vector<std::uint8_t> is_ground;
    std::vector<float> map_heights, confidence, heights, expected;
    for (std::size_t i = 0; i < count; ++i) {
      const auto number = static_cast<float>(i);
      is_ground.push_back(i % 3 == 0 ? 1 : 0);
      confidence.push_back(0.25F * static_cast<float>(i % 4));  // 0.5 is just enough
      map_heights.push_back(number + 0.5F);
      heights.push_back(-number - 1.0F);
      expected.push_back(i % 3 == 0 ? -number - 1.0F : i % 4 >= 2 ? number + 0.5F : kUnknownHeight);
    }
    collect_known(is_ground, map_heights, confidence, 0.5F, heights);
    EXPECT_EQ(heights, expected) << count;
  }
}

TEST_P(SurfaceKernels, WeighKnownIsOneWhereThereIsAHeight) {
  for (std::size_t count = 0; count <= 70; ++count) {
    const std::vector<float> heights =
        heights_around(std::vector<float>(count, 0.0F), static_cast<unsigned>(count));
    std::vector<float> weights(count, -1.0F);
    weigh_known(heights.data(), count, weights.data());
    for (std::size_t i = 0; i < count; ++i)
      EXPECT_EQ(weights[i], heights[i] == kUnknownHeight ? 0.0F : 1.0F) << i << " of " << count;
  }
}

TEST_P(SurfaceKernels, ReweightIsTheSquareOfToleranceOverDistance) {
  for (std::size_t count = 0; count <= 70; ++count) {
    const SlopingSurface surface(count);
    const std::vector<float> heights = heights_around(surface.there);
    std::vector<float> weights(count, -1.0F);
    reweight(heights.data(), surface.between, kTolerance, count, weights.data());
    for (std::size_t i = 0; i < count; ++i) {
      SCOPED_TRACE(::testing::Message() << i << " of " << count);
      if (heights[i] == kUnknownHeight) {
        EXPECT_EQ(weights[i], 0.0F);
        continue;
      }
      const double off = static_cast<double>(heights[i]) - static_cast<double>(surface.there[i]);
      const double tolerance = off > 0.0 ? 0.125 : 0.25;
      const double ratio = std::abs(off) <= tolerance ? 1.0 : tolerance / std::abs(off);
      EXPECT_FLOAT_EQ(weights[i], static_cast<float>(ratio * ratio));
    }
  }
}

TEST_P(SurfaceKernels, ReweightKeepsAllOfTheWeightUpToTheTolerance) {
  const SlopingSurface surface(6);
  std::vector<float> heights = surface.there;
  const std::vector<float> off{0.125F, -0.25F, 0.25F, -0.5F, 0.0F, 0.5F};
  for (std::size_t i = 0; i < off.size(); ++i) heights[i] += off[i];
  std::vector<float> weights(6);
  reweight(heights.data(), surface.between, kTolerance, 6, weights.data());
  // (1/8 / 1/4)², (1/4 / 1/2)², (1/8 / 1/2)²
  EXPECT_EQ(weights, (std::vector<float>{1.0F, 1.0F, 0.25F, 0.25F, 1.0F, 0.0625F}));
}

TEST_P(SurfaceKernels, JudgeRaisesCellsMoreThanAStepAboveTheSurface) {
  for (std::size_t count = 0; count <= 70; ++count) {
    const SlopingSurface surface(count);
    const std::vector<float> heights = heights_around(surface.there);
    std::vector<Standing> standing(count, Standing::judged);
    std::vector<float> there(count, -99.0F);
    judge(heights.data(), surface.between, 0.25F, count, standing.data(), there.data());
    for (std::size_t i = 0; i < count; ++i) {
      SCOPED_TRACE(::testing::Message() << i << " of " << count);
      if (heights[i] == kUnknownHeight) {
        EXPECT_EQ(standing[i], Standing::unknown);
        continue;
      }
      EXPECT_EQ(standing[i],
                heights[i] - surface.there[i] > 0.25F ? Standing::raised : Standing::on_surface);
      EXPECT_EQ(there[i], surface.there[i]);
    }
  }
}

TEST_P(SurfaceKernels, JudgeLeavesCellsExactlyAStepUpOnTheSurface) {
  const SlopingSurface surface(3);
  const std::vector<float> heights{surface.there[0] + 0.25F, surface.there[1] + 0.3125F,
                                   surface.there[2] - 5.0F};
  std::vector<Standing> standing(3);
  std::vector<float> there(3);
  judge(heights.data(), surface.between, 0.25F, 3, standing.data(), there.data());
  EXPECT_EQ(standing,
            (std::vector<Standing>{Standing::on_surface, Standing::raised, Standing::on_surface}));
}

TEST_P(SurfaceKernels, WeighSurfaceTakesCellsOnTheSurfaceAlone) {
  for (std::size_t count = 0; count <= 70; ++count) {
    std::vector<Standing> standing;
    for (std::size_t i = 0; i < count; ++i) standing.push_back(static_cast<Standing>(i % 4));
    std::vector<float> weights(count, -1.0F);
    weigh_surface(standing.data(), count, weights.data());
    for (std::size_t i = 0; i < count; ++i)
      EXPECT_EQ(weights[i], i % 4 == 1 ? 1.0F : 0.0F) << i << " of " << count;
  }
}

TEST_P(SurfaceKernels, FillCellsDecaysAndFillsWhereThereIsNoGround) {
  for (std::size_t count = 0; count <= 70; ++count) {
    const SlopingSurface surface(count);
    std::vector<std::uint8_t> is_ground;
    std::vector<Standing> standing;
    std::vector<float> height, confidence;
    for (std::size_t i = 0; i < count; ++i) {
      is_ground.push_back(i % 3 == 0 ? 1 : 0);
      standing.push_back(static_cast<Standing>(i % 4));
      height.push_back(-static_cast<float>(i) - 1.0F);
      confidence.push_back(i % 5 == 0 ? 1e-30F : 0.5F);
    }
    const std::vector<float> height_before = height;
    const std::vector<float> confidence_before = confidence;
    fill_cells({is_ground.data(), standing.data(), &surface.between, height.data(),
                confidence.data(), count},
               4.0F);
    for (std::size_t i = 0; i < count; ++i) {
      SCOPED_TRACE(::testing::Message() << i << " of " << count);
      const bool stays = is_ground[i] != 0 || standing[i] == Standing::on_surface;
      EXPECT_EQ(height[i], stays ? height_before[i] : surface.there[i]);
      // 0.5 - 0.5 / 4; as little as 1e-30 is forgotten.
      const float decayed = i % 5 == 0 ? 0.0F : 0.375F;
      EXPECT_EQ(confidence[i], is_ground[i] != 0 ? confidence_before[i] : decayed);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(With, SurfaceKernels, testing::all_instruction_sets(), testing::name_of);

}  // namespace
}  // namespace groundgrid
