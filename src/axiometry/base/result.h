// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <expected>
#include <string>
#include <utility>

namespace axiometry {

/// A place in a text: line and column count from 1, the column in bytes; 0 means "not known".
struct TextPosition {
  std::size_t line = 0;
  std::size_t column = 0;

  friend bool operator==(const TextPosition&, const TextPosition&) = default;
};

/// What a caller who can do something about an error must tell apart; everything else is in the message.
enum class ErrorKind {
  bad_input,    ///< what was given is wrong: mend it
  not_found,    ///< what was asked for does not exist
  conflict,     ///< somebody else was first: look again, then decide
  read_only,    ///< it may be read, not written
  full,         ///< no room: nothing of this was kept
  unavailable,  ///< cannot be reached or used now: try again later
  damaged,      ///< what was kept is not what was written
};

/// What is wrong with the world: what was found, what was expected, and where.
struct Error {
  std::string message;  ///< "found …, expected …", one sentence without a full stop
  std::string file;     ///< name as the user gave it; empty until the layer that opened it adds it
  TextPosition at;
  ErrorKind kind = ErrorKind::bad_input;

  /// "run3.csv:41:7: message", leaving out what is not known.
  std::string to_string() const;
};

/// A value, or the reason why there is none.
template <typename T>
using Result = std::expected<T, Error>;

inline std::unexpected<Error> fail(std::string message, TextPosition at = {}) {
  return std::unexpected(Error{std::move(message), {}, at});
}

inline std::unexpected<Error> fail(ErrorKind kind, std::string message) {
  return std::unexpected(Error{std::move(message), {}, {}, kind});
}

}  // namespace axiometry

#define AXIOMETRY_JOIN_(a, b) a##b
#define AXIOMETRY_JOIN(a, b) AXIOMETRY_JOIN_(a, b)
#define AXIOMETRY_TRY_(name, target, expression)              \
  auto name = (expression);                                   \
  if (!name) return std::unexpected(std::move(name).error()); \
  target = *std::move(name)

/// AXIOMETRY_TRY(auto value, may_fail()): binds the value, or returns the error from this function.
#define AXIOMETRY_TRY(target, ...) AXIOMETRY_TRY_(AXIOMETRY_JOIN(axiometry_result_, __LINE__), target, (__VA_ARGS__))

/// AXIOMETRY_TRY_VOID(may_fail()): the same for a Result<void>.
#define AXIOMETRY_TRY_VOID(...)                                    \
  do {                                                             \
    if (auto axiometry_result = (__VA_ARGS__); !axiometry_result)  \
      return std::unexpected(std::move(axiometry_result).error()); \
  } while (false)
