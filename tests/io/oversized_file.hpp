#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdint>
#include <filesystem>

#include "sanitized.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::test {

/// Makes a file of that size which takes no room on the disk.
inline void make_sparse_file(const std::filesystem::path& path, std::uintmax_t bytes) {
  write_file(path, "");
  std::filesystem::resize_file(path, bytes);
}

/// A test of files that memory does not hold: the process gets 4 GB, since some systems promise
/// any amount and then kill the process that uses it.
class OversizedFile : public ::testing::Test {
 protected:
  static constexpr std::uintmax_t kBytes = std::uintmax_t{16} << 30U;

  void SetUp() override {
#if defined(GROUNDGRID_SANITIZED)
    GTEST_SKIP() << "a sanitizer ends the process where memory runs out";
#endif
    ASSERT_EQ(::getrlimit(RLIMIT_AS, &before_), 0);
    rlimit little = before_;
    little.rlim_cur = rlim_t{4} << 30U;
    ASSERT_EQ(::setrlimit(RLIMIT_AS, &little), 0);
    limited_ = true;
  }
  void TearDown() override {
    if (limited_) ::setrlimit(RLIMIT_AS, &before_);
  }

  TemporaryFolder folder;

 private:
  rlimit before_{};
  bool limited_ = false;
};

}  // namespace groundgrid::test
