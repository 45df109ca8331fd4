// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/localised_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/text.h"
#include "axiometry/language/language.h"
#include "axiometry/standards/iso230_2/parameters.h"

namespace axiometry::app {
namespace {

using json::Kind;
using json::Value;

/// Where sentences stand below a member of an object, or below every item of a list, whose name is "[]". Where nothing
/// is below, the value is a sentence.
struct SentencePlaces {
  std::string name;
  std::vector<SentencePlaces> below;

  const SentencePlaces* find(std::string_view wanted) const {
    const auto found = std::ranges::find(below, wanted, &SentencePlaces::name);
    return found == below.end() ? nullptr : &*found;
  }
  SentencePlaces& at(std::string_view wanted) {
    const auto found = std::ranges::find(below, wanted, &SentencePlaces::name);
    return found == below.end() ? below.emplace_back(std::string(wanted)) : *found;
  }
};

// A place that was of a result once stays in its list: the archive keeps results as they were made.

constexpr std::string_view in_test[] = {
    "claims.[].missing.[].message",
    "claims.[].remark",
    "claims.[].title",
    "corrections.[].details.[].name",
    "corrections.[].details.[].value",
    "corrections.[].title",
    "drift.basis",
    "environment.gaps.[]",
    "environment.quantities.[].title",
    "environment.remarks.[]",
    "findings.[].message",
    "information.smaller_repeatability.remark",
    "label",
    "tolerances.[].withheld",
    "uncertainty.annex_a_budget.contributors.[].inputs.[].note",
    "uncertainty.annex_a_budget.contributors.[].title",
    "uncertainty.annex_a_budget.notes.[]",
    "uncertainty.gum_budget.notes.[]",
    "uncertainty.gum_budget.sources.[].note",
    "uncertainty.gum_budget.sources.[].title",
    "uncertainty.inputs.[].origin_title",
    "uncertainty.inputs.[].reason",
    "uncertainty.inputs.[].title",
    "uncertainty.inputs.[].use_title",
    "uncertainty.monte_carlo_run.contributions.[].title",
    "uncertainty.monte_carlo_run.hypotheses.[].reason",
    "uncertainty.monte_carlo_run.hypotheses.[].title",
    "uncertainty.monte_carlo_run.inputs.[].note",
    "uncertainty.monte_carlo_run.inputs.[].title",
    "uncertainty.monte_carlo_run.notes.[]",
};

constexpr std::string_view in_lines[] = {"findings.[].message", "squareness.notes.[]"};

constexpr std::string_view in_motions[] = {"angles.[].remarks.[]", "lines.[].remarks.[]", "remarks.[]",
                                           "straightness.remarks.[]"};

constexpr std::string_view in_dynamic[] = {"remarks.[]"};

constexpr std::string_view in_volumetric[] = {"findings.[].message", "gauge.means", "gauge.straightness", "remarks.[]"};

constexpr std::string_view in_coordinates[] = {"findings.[].message", "remarks.[]"};

constexpr std::string_view in_volumetric_plan[] = {"findings.[].message", "reasons.[]"};

constexpr std::string_view in_field_difference[] = {"after.findings.[].message", "before.findings.[].message"};

constexpr std::string_view in_compensation[] = {"findings.[].message", "known_to_within.notes.[]", "sign",
                                                "verified.inferred", "verified.verified"};

constexpr std::string_view in_periodic[] = {"findings.[].message", "label"};

constexpr std::string_view in_findings_beside_all[] = {"findings.[].message"};

constexpr std::string_view in_findings[] = {"[].message"};

constexpr std::string_view in_control[] = {"inferred", "loading", "sign", "title", "turned_sign", "verified"};

void add_place(SentencePlaces& places, std::string_view name) {
  SentencePlaces* at = &places;
  for (const std::string_view part : text::split(name, '.')) at = &at->at(part);
}

SentencePlaces places_in(std::span<const std::string_view> names) {
  SentencePlaces places;
  for (const std::string_view name : names) add_place(places, name);
  return places;
}

SentencePlaces places_in_test() {
  SentencePlaces places = places_in(in_test);
  for (const iso230_2::ParameterInfo& parameter : iso230_2::parameters)
    add_place(places, fmt::format("uncertainty.monte_carlo.{}.refusal", parameter.key));
  return places;
}

/// Each of the lines has the result of its test.
SentencePlaces places_in_lines() {
  SentencePlaces places = places_in(in_lines);
  places.at("lines").at("[]").at("test").below = places_in_test().below;
  return places;
}

const SentencePlaces& places_of(ResultKind kind) {
  static const std::map<ResultKind, SentencePlaces> all = {
      {ResultKind::test, places_in_test()},
      {ResultKind::lines, places_in_lines()},
      {ResultKind::motions, places_in(in_motions)},
      {ResultKind::periodic, places_in(in_periodic)},
      {ResultKind::dynamic, places_in(in_dynamic)},
      {ResultKind::volumetric, places_in(in_volumetric)},
      {ResultKind::coordinates, places_in(in_coordinates)},
      {ResultKind::volumetric_plan, places_in(in_volumetric_plan)},
      {ResultKind::field_difference, places_in(in_field_difference)},
      {ResultKind::compensation, places_in(in_compensation)},
      {ResultKind::control, places_in(in_control)},
      {ResultKind::findings_beside_all, places_in(in_findings_beside_all)},
      {ResultKind::findings, places_in(in_findings)}};
  return all.at(kind);
}

Value in_language_of(const Reader& reader, const Value& value, const SentencePlaces& places) {
  if (value.is(Kind::text) && places.below.empty())
    return language::translated(value.text(), reader.language, reader.numbers);
  if (value.is(Kind::array)) {
    const SentencePlaces* of_items = places.find("[]");
    if (of_items == nullptr) return value;
    Value list = Value::array();
    for (const Value& item : value.items()) list.push(in_language_of(reader, item, *of_items));
    return list;
  }
  if (!value.is(Kind::object)) return value;
  Value object = Value::object();
  for (const auto& [name, member] : value.members()) {
    const SentencePlaces* of_member = places.find(name);
    object.add(name, of_member == nullptr ? member : in_language_of(reader, member, *of_member));
  }
  return object;
}

}  // namespace

ResultKind result_kind_of_calibration(std::string_view kind) {
  if (kind == "lines") return ResultKind::lines;
  if (kind == "volumetric") return ResultKind::volumetric;
  AXIOMETRY_CONTRACT(kind == "straightness" || kind == "angles" || kind == "squareness");
  return ResultKind::motions;
}

json::Value localised_result(const json::Value& result, ResultKind kind, const Reader& reader) {
  if (reader.language == language::Language::english) return result;
  return in_language_of(reader, result, places_of(kind));
}

}  // namespace axiometry::app
