#pragma once

/// GROUNDGRID_EXPORT marks what a shared library shows; all else in it is hidden.
#if defined(__GNUC__)
#define GROUNDGRID_EXPORT __attribute__((visibility("default")))
#define GROUNDGRID_NO_EXPORT __attribute__((visibility("hidden")))
#else
#define GROUNDGRID_EXPORT
#define GROUNDGRID_NO_EXPORT
#endif
