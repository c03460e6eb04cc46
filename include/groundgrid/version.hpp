#pragma once

/// The version of the library. While it is 0.x a minor version may change the interface and the
/// layout of structs, a patch version neither. CMake reads the version from here.
// NOLINTBEGIN(cppcoreguidelines-macro-usage): the preprocessor of users shall know them.
#define GROUNDGRID_VERSION "0.1.0"
#define GROUNDGRID_VERSION_MAJOR 0
#define GROUNDGRID_VERSION_MINOR 1
#define GROUNDGRID_VERSION_PATCH 0
// NOLINTEND(cppcoreguidelines-macro-usage)
