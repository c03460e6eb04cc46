#include <exception>
#include <filesystem>
#include <system_error>

#include "bindings.hpp"
#include "io/error.hpp"
#include "program/usage_error.hpp"

namespace groundgrid::python {
namespace {

/// What Python calls an error about a file: that it is not there is told apart from what is in it.
PyObject* python_type(const io::Error& error) {
  std::error_code unknown;
  const bool is_there = std::filesystem::exists(error.details().file, unknown);
  return is_there || unknown ? PyExc_ValueError : PyExc_FileNotFoundError;
}

void translate(const std::exception_ptr& exception, void* /*payload*/) {
  try {
    std::rethrow_exception(exception);
  } catch (const io::Error& error) {
    PyErr_SetString(python_type(error), error.what());
  } catch (const program::UsageError& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  }
}

}  // namespace

void bind_errors() { nb::register_exception_translator(translate); }

}  // namespace groundgrid::python
