// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/identify_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/files/request_members.h"
#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
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

constexpr double most_spans = 100;

constexpr std::pair<std::string_view, CurveKind> curve_words[] = {
    {"b-spline", CurveKind::spline}, {"legendre", CurveKind::legendre}, {"nodes", CurveKind::nodes}};
constexpr std::pair<std::string_view, Reversal> reversal_words[] = {
    {"none", Reversal::none}, {"constant", Reversal::constant}, {"curves", Reversal::curves}};
constexpr std::pair<std::string_view, DriftModel> drift_words[] = {
    {"auto", DriftModel::automatic}, {"none", DriftModel::none}, {"linear", DriftModel::linear}};

Result<std::size_t> spans_in(const Value& value) {
  AXIOMETRY_TRY(const double x, formats::number_in(value, "spans"));
  if (!(x >= 1.0 && x <= most_spans && x == std::floor(x)))
    return fail(fmt::format("spans: found {}, expected a whole number from 1 to {}", format_exact(x), most_spans),
                value.at());
  return static_cast<std::size_t>(x);
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

}  // namespace

Result<Smoothness> parse_smoothness(std::string_view text) {
  if (text == "none") return Smoothness{};
  if (text == "auto") return Smoothness{.kind = Smoothness::Kind::automatic};
  std::vector<double> bends;
  for (const std::string_view part : text::split(text, ',')) bends.push_back(parse_number(part).value_or(0.0));
  return smoothness_of(bends, text);
}

Result<IdentifyOptions> identify_options_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "options"));
  IdentifyOptions options;
  AXIOMETRY_TRY_VOID(take_choice<CurveKind>(members, "curves", curve_words, options.curves));
  AXIOMETRY_TRY_VOID(take_spans(members, options));
  AXIOMETRY_TRY_VOID(take_choice<Reversal>(members, "reversal", reversal_words, options.reversal));
  AXIOMETRY_TRY_VOID(take_smoothness(members, options));
  AXIOMETRY_TRY_VOID(take_choice<DriftModel>(members, "drift", drift_words, options.drift));
  AXIOMETRY_TRY_VOID(take_switch(members, "find_breaks", options.find_breaks));
  AXIOMETRY_TRY_VOID(take_switch(members, "find_outliers", options.find_outliers));
  AXIOMETRY_TRY_VOID(members.finish());
  return options;
}

}  // namespace axiometry::app
