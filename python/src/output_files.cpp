#include <filesystem>
#include <memory>

#include "bindings.hpp"
#include "file_path.hpp"
#include "io/hidden_file.hpp"
#include "io/output_folder.hpp"

namespace groundgrid::python {
namespace {

namespace fs = std::filesystem;

/// A hidden file until it is committed or discarded, which need not be when Python forgets it.
class OutputFile {
 public:
  explicit OutputFile(const fs::path& path)
      : file_(std::make_unique<io::HiddenFile>(path)), hidden_(file_->hidden()) {}

  [[nodiscard]] nb::object hidden() const { return name_of_path(hidden_); }
  void commit() {
    const nb::gil_scoped_release no_gil;
    if (file_) file_->commit();
    file_.reset();
  }
  void discard() { file_.reset(); }

 private:
  std::unique_ptr<io::HiddenFile> file_;
  fs::path hidden_;
};

/// A lock until it is released.
class OutputLock {
 public:
  explicit OutputLock(const fs::path& folder) : lock_(std::make_unique<io::FolderLock>(folder)) {}
  void release() { lock_.reset(); }

 private:
  std::unique_ptr<io::FolderLock> lock_;
};

void bind_functions(nb::module_& module) {
  module.def(
      "make_folder", [](nb::handle path) { io::make_folder(path_from(path)); }, nb::arg("path"),
      nb::sig("def make_folder(path: str | os.PathLike[str]) -> None"),
      "Makes a folder and those above it.");
  module.def(
      "sync_folder", [](nb::handle path) { io::sync_folder(path_from(path)); }, nb::arg("path"),
      nb::sig("def sync_folder(path: str | os.PathLike[str]) -> None"),
      "Has what was made, renamed and removed in a folder written to the disk.");
  module.def(
      "remove_leftovers", [](nb::handle path) { return io::remove_leftovers(path_from(path)); },
      nb::arg("path"), nb::sig("def remove_leftovers(path: str | os.PathLike[str]) -> int"),
      "Removes the hidden files that killed runs left in a folder; how many.");
  module.def("hidden_name", &io::hidden_name, "A new name as hidden files have it.");
}

}  // namespace

void bind_output_files(nb::module_& module) {
  nb::class_<OutputFile>(module, "HiddenFile",
                         "A file under a hidden name beside its place, empty at first.")
      .def(
          "__init__",
          [](OutputFile* self, nb::handle path) { new (self) OutputFile(path_from(path)); },
          nb::arg("path"), nb::sig("def __init__(self, path: str | os.PathLike[str]) -> None"))
      .def_prop_ro("hidden", &OutputFile::hidden,
                   nb::for_getter(nb::sig("def hidden(self) -> str")), "Where to write it.")
      .def("commit", &OutputFile::commit, "Gives the file its name, once all is written.")
      .def("discard", &OutputFile::discard, "Removes the file, unless it has its name.");
  nb::class_<OutputLock>(module, "FolderLock",
                         "A folder that one run at a time writes to, of this program or of "
                         "groundgrid. Raises ValueError where another one has it.")
      .def(
          "__init__",
          [](OutputLock* self, nb::handle folder) { new (self) OutputLock(path_from(folder)); },
          nb::arg("folder"), nb::sig("def __init__(self, folder: str | os.PathLike[str]) -> None"))
      .def("release", &OutputLock::release, "Leaves the folder to others.");
  bind_functions(module);
}

}  // namespace groundgrid::python
