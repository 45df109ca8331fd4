// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "axiometry/base/result.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"

/// Members that requests of the workbench have, and files have not: switches, numbers that may be left out.
namespace axiometry::app {

/// Replaces `target` when the member is there. Fails on anything but true and false.
Result<void> take_switch(formats::JsonMembers& members, std::string_view name, bool& target);

/// Likewise. Fails on what is no number.
Result<void> take_number(formats::JsonMembers& members, std::string_view name, std::optional<double>& target);

/// Hands over each text of a list that may be left out; what `take` refuses gets the place of its item. Fails on more
/// than `most` of them.
template <typename Take>
Result<void> take_texts(formats::JsonMembers& members, std::string_view name, std::size_t most, const Take& take) {
  const json::Value* list = members.optional(name);
  if (list == nullptr) return {};
  AXIOMETRY_TRY(const auto* items, formats::items_in(*list, name));
  if (items->size() > most)
    return fail(fmt::format("{}: found {} of them, expected at most {}", name, items->size(), most), list->at());
  for (const json::Value& item : *items) {
    AXIOMETRY_TRY(const std::string text, formats::text_in(item, name));
    if (const Result<void> taken = take(text); !taken) return fail(taken.error().message, item.at());
  }
  return {};
}

/// Hands over a text that may be left out; what `take` refuses gets its name and place.
template <typename Take>
Result<void> take_text(formats::JsonMembers& members, std::string_view name, const Take& take) {
  const json::Value* value = members.optional(name);
  if (value == nullptr) return {};
  AXIOMETRY_TRY(const std::string text, formats::text_in(*value, name));
  if (const Result<void> taken = take(text); !taken)
    return fail(fmt::format("{}: {}", name, taken.error().message), value->at());
  return {};
}

struct WholeNumbers {
  double least;
  double most;
};
/// Absent when the member is. Fails on a number that is none of them.
Result<std::optional<double>> whole_member(formats::JsonMembers& members, std::string_view name, WholeNumbers range);

/// Words of a request and what they stand for.
template <typename Choice>
using ChoiceWords = std::span<const std::pair<std::string_view, Choice>>;

/// Replaces `target` when the member is there. Fails on a word that is none of them, naming them.
template <typename Choice>
Result<void> take_choice(formats::JsonMembers& members, std::string_view name, ChoiceWords<Choice> words,
                         Choice& target) {
  const json::Value* value = members.optional(name);
  if (value == nullptr) return {};
  AXIOMETRY_TRY(const std::string text, formats::text_in(*value, name));
  std::string known;
  for (const auto& [word, choice] : words) {
    if (word == text) {
      target = choice;
      return {};
    }
    known += fmt::format("{}{}", known.empty() ? "" : ", ", word);
  }
  return fail(fmt::format("{}: found {}, expected one of {}", name, text::quoted(text), known), value->at());
}

}  // namespace axiometry::app
