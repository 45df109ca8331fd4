// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/files/reader.h"
#include "axiometry/app/plan/plan.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/standards/iso230_2/plan/plan.h"
#include "axiometry/standards/rules/rule.h"

/// What shall be planned, as people say it: by the flags of `axiometry plan`, or by the members of a request to the
/// workbench, which go through the same table.
namespace axiometry::app {

/// A plan as it is asked for, before all is known that some texts depend on.
struct PlanRequestDraft {
  iso230_2::PlanRequest request;
  std::optional<std::uint64_t> seed;    ///< drawn when not given
  std::vector<std::string> areas;       ///< understood when the kind of the axis is known
  std::optional<std::string> sequence;  ///< list of the user-defined cycle
  std::optional<Position> periodic_at;
  const standards::AxisRule* rule = nullptr;  ///< rule whose cycle is kept too
  bool says_cycle = false;                    ///< which no rule changes then
};

/// One flag: its value, its help, and what it does. One row makes the flag of the command line and the member of
/// "further" of a request.
struct PlanOption {
  std::string_view name;    ///< "--travel"
  std::string_view values;  ///< "FROM:TO"
  std::string_view help;
  std::string_view group;
  bool repeated = false;

  /// Puts it into the wish. Fails on a text that is not of the form of `values`.
  Result<void> (*apply)(const std::string& text, PlanRequestDraft& wish);
};

/// In the order of the help.
std::span<const PlanOption> plan_options();

/// Flags that cannot be given together.
struct PlanOptionPair {
  std::string_view name;
  std::string_view other;
};
std::span<const PlanOptionPair> plan_options_apart();

/// The planner's request with all that was left open: seed and date. Fails as parse_area() and parse_sequence() do;
/// a sequence that the wish's request has already is left alone.
Result<iso230_2::PlanRequest> completed(const PlanRequestDraft& wish);

/// Fails where a seed was given and nothing was drawn, as where positions of targets were given. A request in JSON
/// always has a seed, and is not asked.
Result<void> check_seed_used(const PlanRequestDraft& wish, const Plan& plan);

/// With its further plans.
std::size_t planned_readings(const Plan& plan);

/// Fails on a plan of more readings than a page or an answer can show (100 000, with its further plans), and on names
/// that are no given_line(). Needs a sound plan.
Result<void> check_presentable(const Plan& plan);

/// A plan that was asked for as JSON, with its request: the same with all members that there are and the seed that was
/// drawn, so that asking again makes the same plan; null for a plan that was given as a whole.
struct RequestedPlan {
  PlannedTest planned;
  json::Value request;
};

/// From {"request": {…}} or {"plan": …} of the plan itself, as an object or as the text of its file (PlanSubject in
/// apps/server/openapi.json). Fails, with line and column, on members that are unknown, missing or of another kind, on
/// flags that are unknown or contradict each other, and as make_plan(), read_plan() and check_presentable() do.
Result<RequestedPlan> requested_plan(const json::Value& body);

/// The same of a request alone.
Result<RequestedPlan> requested_plan_of(const json::Value& request);

/// A plan as it is kept: its JSON with findings and duration, and the request as the member "request". Ends with a line
/// break; read_requested(write_requested(p)) is the same plan and request.
std::string write_requested(const RequestedPlan& plan);

/// Fails as read_plan() does.
Result<RequestedPlan> read_requested(std::string_view bytes);

/// PlanDraft of apps/server/openapi.json: the plan, what is said about it in the reader's language, and its figures as
/// SVG, for a dark page where that is asked for.
json::Value draft_value(const RequestedPlan& plan, const Reader& reader, bool dark = false);

}  // namespace axiometry::app
