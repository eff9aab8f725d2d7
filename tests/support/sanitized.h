#pragma once

namespace docent::test {

/// Has this program the address sanitizer in it, with which everything takes ten times as long?
/// gcc tells by one name, clang by another.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool is_sanitized = true;
#elif defined(__has_feature)
inline constexpr bool is_sanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool is_sanitized = false;
#endif

}  // namespace docent::test

/// First in a test of answers that the release build judges, whose code other tests run too, and
/// which would take minutes with the address sanitizer.
#define NEEDS_SPEED() \
  if (docent::test::is_sanitized) GTEST_SKIP() << "judged where it takes seconds"
