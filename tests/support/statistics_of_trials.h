// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstddef>

/// Tests whose bounds are statistics of hundreds of evaluations, which other tests make once each.
namespace axiometry::testing_support {

#ifdef __has_feature
#if __has_feature(address_sanitizer)
#define AXIOMETRY_WATCHED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(AXIOMETRY_WATCHED)
inline constexpr bool is_watched = true;
#else
inline constexpr bool is_watched = false;
#endif

/// First line of such a test. The sanitizers watch what a program does, and it does the same a hundred times: under
/// them, where each takes ten times as long, it is left to the tests that do it once.
#define AXIOMETRY_STATISTICS_OF_TRIALS() \
  if (::axiometry::testing_support::is_watched) GTEST_SKIP() << "statistics of trials are of the release build"

/// So many of a test that tries much of one kind: a fifth under the sanitizers.
constexpr std::size_t as_many(std::size_t in_release) { return is_watched ? in_release / 5 : in_release; }

}  // namespace axiometry::testing_support
