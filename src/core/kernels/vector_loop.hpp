#pragma once

/// Before a loop whose iterations do not depend on each other, which the compiler cannot always see
/// where there are many arrays.
#if defined(__clang__)
#define GROUNDGRID_VECTOR_LOOP _Pragma("clang loop vectorize(assume_safety)")
// Builds that do not optimise leave the loops as they are, and that is no fault.
#pragma clang diagnostic ignored "-Wpass-failed"
#elif defined(__GNUC__)
#define GROUNDGRID_VECTOR_LOOP _Pragma("GCC ivdep")
#else
#define GROUNDGRID_VECTOR_LOOP
#endif
