// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/identify_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/files/request_members.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"

namespace axiometry::app {
namespace {

using formats::JsonMembers;
using json::Kind;
using json::Value;
using volumetric::CurveKind;
using volumetric::DriftModel;
using volumetric::IdentifyOptions;
using volumetric::Reversal;
using volumetric::Smoothness;

constexpr std::size_t most_spans = 400;
constexpr std::size_t most_parts = 500;

constexpr std::pair<std::string_view, CurveKind> curve_words[] = {
    {"b-spline", CurveKind::spline}, {"legendre", CurveKind::legendre}, {"nodes", CurveKind::nodes}};
constexpr std::pair<std::string_view, Reversal> reversal_words[] = {
    {"none", Reversal::none}, {"constant", Reversal::constant}, {"curves", Reversal::curves}};
constexpr std::pair<std::string_view, DriftModel> drift_words[] = {
    {"auto", DriftModel::automatic}, {"none", DriftModel::none}, {"linear", DriftModel::linear}};

template <typename Choice>
Result<Choice> named(ChoiceWords<Choice> words, std::string_view word) {
  std::string known;
  for (const auto& [name, choice] : words) {
    if (name == word) return choice;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", name);
  }
  return fail(fmt::format("found {}, expected one of {}", text::quoted(word), known));
}

/// Replaces `target` by what `parse` makes of the member when it is there.
template <typename Parse, typename Target>
Result<void> take_parsed(JsonMembers& members, std::string_view name, const Parse& parse, Target& target) {
  const Value* value = members.optional(name);
  if (value == nullptr) return {};
  AXIOMETRY_TRY(const std::string text, formats::text_in(*value, name));
  auto parsed = parse(text);
  if (!parsed) return fail(fmt::format("{}: {}", name, parsed.error().message), value->at());
  target = *parsed;
  return {};
}

Result<std::size_t> spans_of(double x, std::string_view found) {
  if (!(x >= 1.0 && x <= static_cast<double>(most_spans) && x == std::floor(x)))
    return fail(fmt::format("found {}, expected a whole number from 1 to {}", found, most_spans));
  return static_cast<std::size_t>(x);
}

Result<std::size_t> spans_in(const Value& value) {
  AXIOMETRY_TRY(const double x, formats::number_in(value, "spans"));
  auto spans = spans_of(x, format_exact(x));
  if (!spans) return fail("spans: " + spans.error().message, value.at());
  return spans;
}

Result<void> take_spans(JsonMembers& members, IdentifyOptions& options) {
  const Value* value = members.optional("spans");
  if (value == nullptr) return {};
  if (!value->is(Kind::array)) {
    AXIOMETRY_TRY(const std::size_t spans, spans_in(*value));
    options.sizes.fill(spans);
    return {};
  }
  if (value->items().size() != options.sizes.size())
    return fail(
        fmt::format("spans: found {} of them, expected one number, or three for X, Y, Z", value->items().size()),
        value->at());
  for (std::size_t a = 0; a < options.sizes.size(); ++a) {
    AXIOMETRY_TRY(options.sizes[a], spans_in(value->items()[a]));
  }
  return {};
}

Result<Smoothness> smoothness_of(const std::vector<double>& bends, std::string_view found) {
  const auto is_bend = [](double x) { return x >= Smoothness::least && x <= Smoothness::most; };
  if ((bends.size() != 1 && bends.size() != 2) || !std::ranges::all_of(bends, is_bend))
    return fail(fmt::format("found {}, expected none, auto, or one or two numbers from 0.1 to 1000000 (µm, µrad)",
                            text::quoted(found)));
  return Smoothness{Smoothness::Kind::stated, bends.front(), bends.back()};
}

Result<void> take_smoothness(JsonMembers& members, IdentifyOptions& options) {
  const Value* value = members.optional("smoothness");
  if (value == nullptr) return {};
  Result<Smoothness> taken = Smoothness{};
  if (value->is(Kind::text)) {
    taken = parse_smoothness(value->text());
  } else {
    std::vector<double> bends;
    if (value->is(Kind::array)) {
      for (const Value& item : value->items()) {
        AXIOMETRY_TRY(bends.emplace_back(), formats::number_in(item, "smoothness"));
      }
    } else {
      AXIOMETRY_TRY(bends.emplace_back(), formats::number_in(*value, "smoothness"));
    }
    taken = smoothness_of(bends, json::dump(*value));
  }
  if (!taken) return fail("smoothness: " + taken.error().message, value->at());
  options.smoothness = *taken;
  return {};
}

Result<void> take_parts(JsonMembers& members, std::vector<PartRange>& parts) {
  const Value* list = members.optional("parts");
  if (list == nullptr) return {};
  AXIOMETRY_TRY(const auto* items, formats::items_in(*list, "parts"));
  if (items->size() > most_parts)
    return fail(fmt::format("parts: found {} of them, expected at most {}", items->size(), most_parts), list->at());
  for (const Value& item : *items) {
    AXIOMETRY_TRY(const std::string text, formats::text_in(item, "parts"));
    auto part = parse_part_range(text);
    if (!part) return fail(part.error().message, item.at());
    parts.push_back(*part);
  }
  return {};
}

template <typename Choice>
std::string_view word_of(ChoiceWords<Choice> words, Choice choice) {
  return std::ranges::find(words, choice, &std::pair<std::string_view, Choice>::second)->first;
}

Value smoothness_value(const Smoothness& s) {
  if (s.kind == Smoothness::Kind::automatic) return "auto";
  if (s.displacement_um == s.rotation_urad) return s.displacement_um;
  return Value::array({s.displacement_um, s.rotation_urad});
}

}  // namespace

Result<CurveKind> parse_curves(std::string_view word) { return named<CurveKind>(curve_words, word); }

Result<Reversal> parse_reversal(std::string_view word) { return named<Reversal>(reversal_words, word); }

Result<DriftModel> parse_drift(std::string_view word) { return named<DriftModel>(drift_words, word); }

Result<CurveSizes> parse_spans(std::string_view text) {
  const std::vector<std::string_view> parts = text::split(text, ',');
  CurveSizes sizes{};
  if (parts.size() != 1 && parts.size() != sizes.size())
    return fail(fmt::format("found {}, expected one number, or three for X, Y, Z", text::quoted(text)));
  for (std::size_t a = 0; a < sizes.size(); ++a) {
    const std::string_view part = parts[parts.size() == 1 ? 0 : a];
    AXIOMETRY_TRY(sizes[a], spans_of(parse_number(part).value_or(0.0), text::quoted(part)));
  }
  return sizes;
}

Result<Smoothness> parse_smoothness(std::string_view text) {
  if (text == "none") return Smoothness{};
  if (text == "auto") return Smoothness{.kind = Smoothness::Kind::automatic};
  std::vector<double> bends;
  for (const std::string_view part : text::split(text, ',')) bends.push_back(parse_number(part).value_or(0.0));
  return smoothness_of(bends, text);
}

Result<IdentifyChoices> identify_choices_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "options"));
  IdentifyChoices choices;
  IdentifyOptions& model = choices.model;
  AXIOMETRY_TRY_VOID(take_parsed(members, "curves", &parse_curves, model.curves));
  AXIOMETRY_TRY_VOID(take_spans(members, model));
  AXIOMETRY_TRY_VOID(take_parsed(members, "reversal", &parse_reversal, model.reversal));
  AXIOMETRY_TRY_VOID(take_smoothness(members, model));
  AXIOMETRY_TRY_VOID(take_parsed(members, "drift", &parse_drift, model.drift));
  AXIOMETRY_TRY_VOID(take_switch(members, "find_breaks", model.find_breaks));
  AXIOMETRY_TRY_VOID(take_switch(members, "find_outliers", model.find_outliers));
  AXIOMETRY_TRY_VOID(take_switch(members, "find_part_scales", model.find_part_scales));
  AXIOMETRY_TRY_VOID(take_parts(members, choices.parts));
  AXIOMETRY_TRY_VOID(take_recording(members, choices.recording));
  AXIOMETRY_TRY_VOID(take_switch(members, "reversed", choices.recording.matcher.reversed));
  AXIOMETRY_TRY_VOID(members.finish());
  return choices;
}

Value to_json(const IdentifyChoices& choices, const RecordingTexts& recording) {
  const IdentifyOptions &model = choices.model, usual;
  Value object = Value::object();
  if (model.curves != usual.curves) object.add("curves", word_of<CurveKind>(curve_words, model.curves));
  if (model.sizes != usual.sizes) {
    Value spans = Value::array();
    for (const std::size_t size : model.sizes) spans.push(size);
    const bool is_one = std::ranges::count(model.sizes, model.sizes[0]) == std::ssize(model.sizes);
    object.add("spans", is_one ? Value(model.sizes[0]) : std::move(spans));
  }
  if (model.reversal != usual.reversal) object.add("reversal", word_of<Reversal>(reversal_words, model.reversal));
  if (model.smoothness.kind != Smoothness::Kind::none) object.add("smoothness", smoothness_value(model.smoothness));
  if (model.drift != usual.drift) object.add("drift", word_of<DriftModel>(drift_words, model.drift));
  if (!model.find_breaks) object.add("find_breaks", false);
  if (!model.find_outliers) object.add("find_outliers", false);
  if (!model.find_part_scales) object.add("find_part_scales", false);
  if (!choices.parts.empty()) {
    Value& parts = object.add("parts", Value::array());
    for (const PartRange& p : choices.parts)
      parts.push(p.first == p.last ? fmt::format("{}", p.first) : fmt::format("{}-{}", p.first, p.last));
  }
  if (choices.recording.matcher.reversed) object.add("reversed", true);
  if (!recording.empty()) object.add("recording", recording_value(recording));
  return object;
}

}  // namespace axiometry::app
