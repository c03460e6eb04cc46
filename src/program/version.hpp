#pragma once

namespace groundgrid::program {

/// "0.1.0".
const char* version();

}  // namespace groundgrid::program
