#pragma once

// SOMATO_TESTS_SANITIZED: the tests run under a sanitizer.

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SOMATO_TESTS_SANITIZED
#endif
#endif

namespace somato::testing {

/// `count` iterations or random problems; under a sanitizer, where each takes five to ten times as
/// long, an eighth of them.
constexpr int fewer_if_sanitized(int count) {
#ifdef SOMATO_TESTS_SANITIZED
  return count / 8;
#else
  return count;
#endif
}

}  // namespace somato::testing
