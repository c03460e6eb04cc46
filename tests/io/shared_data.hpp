#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace groundgrid::test {

/// A test that reads real scans. Their licence keeps them out of the repository: GROUNDGRID_DATA
/// says where they lie. Where they are absent the test is skipped, but in CI that is a failure.
class WithSharedData : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::filesystem::is_directory(data() / "semantickitti")) return;
    if (std::getenv("CI") != nullptr || std::getenv("GROUNDGRID_REQUIRE_DATA") != nullptr)
      FAIL() << "no real scans in " << data() << "; set GROUNDGRID_DATA";
    GTEST_SKIP() << "no real scans in " << data() << "; set GROUNDGRID_DATA to run this test";
  }

  static std::filesystem::path data() {
    const char* const chosen = std::getenv("GROUNDGRID_DATA");
    return chosen != nullptr ? chosen : GROUNDGRID_DEFAULT_DATA;
  }
};

}  // namespace groundgrid::test
