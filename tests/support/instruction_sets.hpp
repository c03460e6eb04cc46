#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>

namespace groundgrid::testing {

/// Once for each set of instructions that this processor and the core have in common.
class OnInstructionSet : public ::testing::TestWithParam<std::int64_t> {
 protected:
  void SetUp() override { hwy::SetSupportedTargetsForTest(GetParam()); }
  void TearDown() override { hwy::SetSupportedTargetsForTest(0); }
};

inline auto all_instruction_sets() {
  return ::testing::ValuesIn(hwy::SupportedAndGeneratedTargets());
}

inline const char* name_of(const ::testing::TestParamInfo<std::int64_t>& instruction_set) {
  return hwy::TargetName(instruction_set.param);
}

}  // namespace groundgrid::testing
