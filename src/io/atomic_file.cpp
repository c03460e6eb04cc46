#include "io/atomic_file.hpp"

#include <cerrno>
#include <utility>

#include "io/error.hpp"

namespace groundgrid::io {

AtomicFile::AtomicFile(std::filesystem::path path)
    : place_(std::move(path)), file_(std::fopen(place_.hidden().c_str(), "wb")) {
  if (file_ == nullptr) fail(errno);
}

AtomicFile::~AtomicFile() {
  if (file_ != nullptr) std::fclose(file_);
}

void AtomicFile::write(std::span<const std::byte> bytes) {
  if (bytes.empty()) return;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail(errno);
}

void AtomicFile::write(std::string_view text) { write(std::as_bytes(std::span(text))); }

void AtomicFile::commit() {
  // Closing writes what is still buffered, so a full disk may show only here.
  if (std::fclose(std::exchange(file_, nullptr)) != 0) fail(errno);
  place_.commit();
}

void AtomicFile::fail(int error_number) const {
  fail_to_write(place_.path(), system_message(error_number));
}

void write_text(const std::filesystem::path& path, std::string_view text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace groundgrid::io
