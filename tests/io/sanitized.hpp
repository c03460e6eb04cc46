#pragma once

// Sanitizers hold memory back and end the process where it runs out, so that tests of memory say
// nothing about the program.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GROUNDGRID_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define GROUNDGRID_SANITIZED
#endif
#endif
