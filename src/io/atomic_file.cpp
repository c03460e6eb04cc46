#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "io/error.hpp"

namespace groundgrid::io {

AtomicFile::AtomicFile(std::filesystem::path path) : place_(std::move(path)) {
  // A descriptor of its own, since closing the file closes that.
  const int copy = ::fcntl(place_.descriptor(), F_DUPFD_CLOEXEC, 0);
  file_ = copy < 0 ? nullptr : ::fdopen(copy, "wb");
  if (file_ != nullptr) return;
  const int error_number = errno;
  if (copy >= 0) ::close(copy);
  fail(error_number);
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : place_(std::move(other.place_)), file_(std::exchange(other.file_, nullptr)) {}

AtomicFile::~AtomicFile() {
  if (file_ != nullptr) std::fclose(file_);
}

void AtomicFile::write(std::span<const std::byte> bytes) {
  if (bytes.empty()) return;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail(errno);
}

void AtomicFile::write(std::string_view text) { write(std::as_bytes(std::span(text))); }

// Writes what is still buffered, so a full disk may show only here.
void AtomicFile::close() {
  if (std::fclose(std::exchange(file_, nullptr)) != 0) fail(errno);
}

void AtomicFile::commit() {
  close();
  place_.commit();
}

void AtomicFile::fail(int error_number) const {
  fail_to_write(place_.path(), system_message(error_number));
}

void FileBatch::add(AtomicFile&& file) {
  // Each is open until it has its name.
  constexpr std::size_t kMost = 64;
  file.close();
  file.place_.begin_to_synchronise();
  files_.push_back(std::move(file.place_));
  if (files_.size() >= kMost) commit();
}

void FileBatch::commit() {
  // Where it fails all are given up.
  std::vector<HiddenFile> files = std::exchange(files_, {});
  HiddenFile::commit(files);
}

void commit(AtomicFile&& file, FileBatch* batch) {
  if (batch == nullptr)
    file.commit();
  else
    batch->add(std::move(file));
}

void write_text(const std::filesystem::path& path, std::string_view text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace groundgrid::io
