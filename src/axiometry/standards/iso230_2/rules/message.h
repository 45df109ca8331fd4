// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "axiometry/standards/iso230_2/finding.h"

/// What is said of a test, with the deviations in it as values, and the findings that say it.
namespace axiometry::iso230_2::rules {

struct Case;

/// A text in English and the deviations in it, in its order.
struct Message {
  std::string text;
  std::vector<MessageDeviation> deviations;

  Message() = default;
  Message(std::string words) : text(std::move(words)) {}
  Message(std::string_view words) : text(words) {}
  Message(const char* words) : text(words) {}
};

/// What message() does; messages holds those among the arguments at their numbers, and null for others.
Message formatted_message(std::string_view format, fmt::format_args arguments,
                          std::span<const Message* const> messages);

/// A message as text, anything else as it is.
template <typename A>
const A& text_of(const A& argument) {
  return argument;
}
inline std::string_view text_of(const Message& argument) { return argument.text; }

template <typename A>
const Message* message_among(const A& argument) {
  if constexpr (std::is_same_v<A, Message>)
    return &argument;
  else
    return nullptr;
}

template <typename A>
using Shown = decltype(text_of(std::declval<const A&>()));

/// As fmt::format, which knows no messages so that no deviation is lost in it; those of messages among the arguments
/// are its own. Contract: its places have no numbers.
template <typename... T>
Message message(fmt::format_string<std::remove_cvref_t<Shown<T>>...> format, const T&... arguments) {
  const std::array<const Message*, sizeof...(T)> messages = {message_among(arguments)...};
  const std::tuple<Shown<T>...> shown(text_of(arguments)...);
  const fmt::string_view text = format;
  return std::apply(
      [&](const auto&... each) {
        return formatted_message({text.data(), text.size()}, fmt::make_format_args(each...), messages);
      },
      shown);
}

/// "0.0213 µm", "−2554 ″", with its value.
Message deviation_message(AxisKind kind, double x);
Message deviation_message(const Case& c, double x);

/// The id of a rule's finding is the name of its function.
Finding finding(std::string id, std::string clause, Severity severity, Message message);

inline Finding departure(std::string id, std::string clause, Message message) {
  return finding(std::move(id), std::move(clause), Severity::departure, std::move(message));
}
inline Finding missing(std::string id, std::string clause, Message message) {
  return finding(std::move(id), std::move(clause), Severity::missing, std::move(message));
}
inline Finding note(std::string id, std::string clause, Message message) {
  return finding(std::move(id), std::move(clause), Severity::note, std::move(message));
}

/// A finding that these fields of the metadata would answer, each by its own Field::key or a literal.
inline Finding answered_by(std::vector<std::string_view> fields, Finding finding) {
  finding.fields = std::move(fields);
  return finding;
}

}  // namespace axiometry::iso230_2::rules
