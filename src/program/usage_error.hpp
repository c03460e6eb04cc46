#pragma once

#include <stdexcept>

namespace groundgrid::program {

/// The command line or the parameter file asks for something that cannot be.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace groundgrid::program
