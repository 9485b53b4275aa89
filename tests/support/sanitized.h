#pragma once

// SOMATO_TESTS_SANITIZED: the tests run under a sanitizer.

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SOMATO_TESTS_SANITIZED
#endif
#endif
