// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/results/localised_result.h"
#include "axiometry/app/volumetric/errors_json.h"
#include "axiometry/app/volumetric/volumetric_request.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/formats/volumetric/volumetric_plan_json.h"
#include "axiometry/volumetric/machine/error_motion.h"

namespace axiometry::app {
namespace {

using formats::JsonMembers;
using json::Kind;
using json::Value;

constexpr std::size_t most_rows = 100'000;  // of any list in a result

/// What a page reads out of the rows of a list, and of which kind it is.
struct Shown {
  std::string_view name;
  Kind kind;
};

Result<void> check_member(const Value& value, const Shown& shown, bool may_be_null) {
  const Value* member = value.is(Kind::object) ? value.find(shown.name) : nullptr;
  if (member == nullptr)
    return fail(fmt::format("found no {}, expected the result of a volumetric calibration", shown.name), value.at());
  if (member->is(shown.kind) || (may_be_null && member->is(Kind::null))) return {};
  return fail(fmt::format("{}: found {}, expected {}", shown.name, json::kind_name(member->kind()),
                          json::kind_name(shown.kind)),
              member->at());
}

Result<void> check_rows(const Value& result, std::string_view list, std::initializer_list<Shown> row) {
  AXIOMETRY_TRY_VOID(check_member(result, {list, Kind::array}, false));
  const auto& items = result.find(list)->items();
  if (items.size() > most_rows)
    return fail(fmt::format("{}: found {} of them, expected at most {}", list, items.size(), most_rows));
  for (const Value& item : items)
    for (const Shown& shown : row) AXIOMETRY_TRY_VOID(check_member(item, shown, false));
  return {};
}

Result<void> check_findings(const Value& result, std::string_view name) {
  return check_rows(result, name, {{"id", Kind::text}, {"severity", Kind::text}, {"message", Kind::text}});
}

Result<void> check_texts(const Value& result, std::string_view name) {
  AXIOMETRY_TRY_VOID(check_rows(result, name, {}));
  for (const Value& text : result.find(name)->items()) AXIOMETRY_TRY_VOID(formats::text_in(text, name));
  return {};
}

Result<void> check_errors(const Value& result) {
  AXIOMETRY_TRY_VOID(check_member(result, {"errors", Kind::object}, false));
  const Value& errors = *result.find("errors");
  for (const std::string& name : volumetric::error_names()) {
    const bool is_curve = name.front() == 'E';
    AXIOMETRY_TRY_VOID(check_member(errors, {name, is_curve ? Kind::array : Kind::object}, false));
    const Value& error = *errors.find(name);
    if (!is_curve) {
      for (const std::string_view member : {"value", "u"})
        AXIOMETRY_TRY_VOID(check_member(error, {member, Kind::number}, true));
      continue;
    }
    AXIOMETRY_TRY_VOID(
        check_rows(errors, name, {{"position", Kind::number}, {"value", Kind::number}, {"u", Kind::number}}));
  }
  return {};
}

/// As `axiometry volumetric assemble` writes it; its curves are those of its model.
Result<Value> given_singles(const Value& result, const Reader& reader) {
  AXIOMETRY_TRY_VOID(check_rows(result, "errors", {{"name", Kind::text}, {"u_largest", Kind::number}}));
  for (const Value& error : result.find("errors")->items())
    for (const std::string_view name : {"file", "directions", "equipment"})
      AXIOMETRY_TRY_VOID(check_member(error, {name, Kind::text}, true));
  AXIOMETRY_TRY_VOID(check_findings(result, "findings"));
  AXIOMETRY_TRY_VOID(check_texts(result, "remarks"));
  AXIOMETRY_TRY(const volumetric::ErrorModel model, given_model(result));
  Value shown = Value::object();
  for (const auto& [name, member] : result.members())
    if (name != "curves") shown.add(name, member);
  shown.add("curves", errors_value(model));
  return localised_result(shown, ResultKind::volumetric, reader);
}

}  // namespace

Value draft_value(const volumetric::PlannedCalibration& planned, const Reader& reader) {
  Value value = Value::object();
  value.add("plan", formats::volumetric_plan_value(planned.plan));
  const Value whole = expectation_value(planned);
  Value expected = Value::object();
  for (const auto& [name, member] : whole.members())
    if (name != "program") expected.add(name, member);
  value.add("expected", localised_result(expected, ResultKind::volumetric_plan, reader));
  value.add("csv", planned_points_csv(planned.plan));
  return value;
}

Result<Value> given_result(const Value& body, const Reader& reader) {
  const Value* result = body.is(Kind::object) ? body.find("result") : nullptr;
  if (result == nullptr) return fail("found no result, expected one", body.at());
  if (is_of_singles(*result)) return given_singles(*result, reader);
  AXIOMETRY_TRY_VOID(check_errors(*result));
  AXIOMETRY_TRY_VOID(check_member(*result, {"rank", Kind::object}, false));
  for (const std::string_view name : {"rank", "unknowns", "null_directions", "condition"})
    AXIOMETRY_TRY_VOID(check_member(*result->find("rank"), {name, Kind::number}, false));
  AXIOMETRY_TRY_VOID(check_member(*result, {"chi2_per_dof", Kind::number}, true));
  for (const std::string_view name : {"degrees_of_freedom", "readings"})
    AXIOMETRY_TRY_VOID(check_member(*result, {name, Kind::number}, false));
  AXIOMETRY_TRY_VOID(check_texts(*result, "unseen"));
  AXIOMETRY_TRY_VOID(check_rows(*result, "stations",
                                {{"station", Kind::text},
                                 {"tool", Kind::text},
                                 {"readings", Kind::number},
                                 {"rms_um", Kind::number},
                                 {"normalised_rms", Kind::number}}));
  for (const Value& station : result->find("stations")->items()) {
    AXIOMETRY_TRY_VOID(check_member(station, {"position_mm", Kind::array}, false));
    AXIOMETRY_TRY_VOID(formats::vector_in(*station.find("position_mm"), "position_mm"));
  }
  for (const std::string_view list : {"set_aside", "breaks"}) AXIOMETRY_TRY_VOID(check_rows(*result, list, {}));
  AXIOMETRY_TRY_VOID(check_findings(*result, "findings"));
  AXIOMETRY_TRY_VOID(given_model(*result));
  return localised_result(*result, ResultKind::volumetric, reader);
}

Result<KeptModel> given_kept_model(const Value& body, std::string_view name, std::string_view findings) {
  AXIOMETRY_TRY(volumetric::ErrorModel model, given_model(body, name));
  KeptModel kept{std::move(model), {}};
  if (body.find(findings) != nullptr) {
    AXIOMETRY_TRY_VOID(check_findings(body, findings));
    kept.against = findings_against(kept_findings(body, findings));
  }
  const std::string remarks = "remarks" + std::string(findings.substr(std::min(findings.size(), findings.find('_'))));
  if (const Value* told = body.find(remarks); told != nullptr && !told->is(Kind::null)) {
    AXIOMETRY_TRY_VOID(check_texts(body, remarks));
    std::ranges::move(notes_of_remarks(*told), std::back_inserter(kept.against));
  }
  return kept;
}

}  // namespace axiometry::app
