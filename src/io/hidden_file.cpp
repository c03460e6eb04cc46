#include "io/hidden_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <set>
#include <system_error>
#include <utility>

#include "io/error.hpp"
#include "io/output_folder.hpp"
#include "io/path_checks.hpp"

namespace groundgrid::io {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHiddenPrefix = ".groundgrid-";
constexpr std::string_view kHiddenSuffix = ".tmp";
constexpr std::size_t kHiddenDigits = 16;

// A run that clears the folder may come between the making of a file and its lock, and take it
// away. Where a file system knows no locks, nothing is taken away either.
bool is_ours(int file) {
  struct stat status {};
  if (::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
  return ::fstat(file, &status) == 0 && status.st_nlink > 0;
}

struct NewFile {
  fs::path path;
  FileDescriptor descriptor;
};

NewFile new_file_beside(const fs::path& result) {
  for (;;) {
    fs::path path = result.parent_path() / hidden_name();
    FileDescriptor file = FileDescriptor::open(path, O_RDWR | O_CREAT | O_EXCL);
    if (!file.is_open() && errno != EEXIST) fail_to_write(result, system_message(errno));
    if (file.is_open() && is_ours(file.get())) return {std::move(path), std::move(file)};
  }
}

}  // namespace

HiddenFile::HiddenFile(fs::path path) : path_(std::move(path)) {
  NewFile file = new_file_beside(path_);
  hidden_ = std::move(file.path);
  descriptor_ = std::move(file.descriptor);
}

HiddenFile::HiddenFile(HiddenFile&& other) noexcept
    : path_(std::move(other.path_)),
      hidden_(std::exchange(other.hidden_, {})),
      descriptor_(std::move(other.descriptor_)) {}

HiddenFile::~HiddenFile() {
  if (hidden_.empty()) return;
  std::error_code ignored;
  fs::remove(hidden_, ignored);
}

void HiddenFile::commit(std::span<HiddenFile> files) {
  for (const HiddenFile& file : files) file.synchronise();
  std::set<fs::path> folders;
  for (HiddenFile& file : files) {
    file.rename();
    folders.insert(folder_of(file.path_));
  }
  for (const fs::path& folder : folders) sync_folder(folder);
}

void HiddenFile::begin_to_synchronise() const {
  ::sync_file_range(descriptor_.get(), 0, 0, SYNC_FILE_RANGE_WRITE);
}

void HiddenFile::synchronise() const {
  if (!has_name(descriptor_.get(), hidden_))
    fail_to_write(path_, "another file, or none, under its hidden name");
  if (::fsync(descriptor_.get()) != 0) fail_to_write(path_, system_message(errno));
}

void HiddenFile::rename() {
  std::error_code error;
  fs::rename(hidden_, path_, error);
  if (error) fail_to_write(path_, error.message());
  hidden_.clear();
}

FileDescriptor file_without_name(const fs::path& result) {
  NewFile file = new_file_beside(result);
  if (::unlink(file.path.c_str()) != 0) fail_to_write(result, system_message(errno));
  return std::move(file.descriptor);
}

std::string hidden_name() {
  std::uint64_t number = 0;
  if (::getentropy(&number, sizeof(number)) != 0)
    throw std::system_error(errno, std::generic_category(), "no random numbers");
  return fmt::format("{}{:0{}x}{}", kHiddenPrefix, number, kHiddenDigits, kHiddenSuffix);
}

bool is_hidden_name(std::string_view name) {
  if (name.size() != kHiddenPrefix.size() + kHiddenDigits + kHiddenSuffix.size() ||
      !name.starts_with(kHiddenPrefix) || !name.ends_with(kHiddenSuffix))
    return false;
  const std::string_view digits = name.substr(kHiddenPrefix.size(), kHiddenDigits);
  return digits.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

void fail_to_write(const fs::path& path, const std::string& got) {
  throw Error({.file = path,
               .expected = "a place to write to",
               .got = got,
               .remedy = "check the folder, its rights and the space left on the disk"});
}

}  // namespace groundgrid::io
