#include "program/version.hpp"

#include "groundgrid/version.hpp"

namespace groundgrid::program {

const char* version() { return GROUNDGRID_VERSION; }

}  // namespace groundgrid::program
