// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iterator>
#include <random>

#include "axiometry/app/files/output.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/plan/plan_text.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/time/iso_date.h"
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/report/documents/plan_sheet.h"
#include "axiometry/standards/rules/planned_rule.h"

namespace axiometry::app {
namespace {

report::Document sheet_of(const PlannedTest& planned, const report::Options& options) {
  return report::plan_sheet({planned.plan, planned.findings, planned.duration, planned.duration_in_all}, options);
}

}  // namespace

Result<PlannedTest> planned(Plan plan, std::optional<double> acceleration) {
  if (acceleration) {
    AXIOMETRY_TRY_VOID(check_acceleration(*acceleration));
    plan.acceleration = acceleration;
    for (Plan& part : plan.further) part.acceleration = acceleration;
  }
  const standards::AxisRule* rule = nullptr;
  if (!plan.rule.empty()) {
    AXIOMETRY_TRY(rule, standards::rule_named(plan.rule));
  }
  PlannedTest result;
  result.findings = iso230_2::plan_findings(plan);
  if (rule != nullptr)
    std::ranges::move(standards::planned_rule_findings(*rule, plan), std::back_inserter(result.findings));
  result.duration = iso230_2::estimated_duration(plan);
  result.duration_in_all = result.duration;
  for (const Plan& part : plan.further)
    result.duration_in_all = result.duration_in_all + iso230_2::estimated_duration(part);
  result.plan = std::move(plan);
  return result;
}

Result<Plan> read_plan_file(const std::string& file) {
  AXIOMETRY_TRY(const std::string bytes, whole_file(file));
  return in_file(formats::read_plan(bytes), file);
}

Result<std::vector<Approach>> read_sequence(const std::string& list_or_file) {
  if (auto sequence = parse_sequence(list_or_file)) return sequence;
  if (list_or_file != "-" && !std::filesystem::exists(list_or_file)) return parse_sequence(list_or_file);
  AXIOMETRY_TRY(const std::string text, whole_file(list_or_file));
  return in_file(parse_sequence(text), list_or_file);
}

std::uint64_t drawn_seed() { return std::random_device{}(); }

std::string today() {
  const char* fixed = std::getenv("SOURCE_DATE_EPOCH");
  const auto seconds = fixed ? parse_count(fixed) : std::nullopt;
  const std::time_t now = seconds ? static_cast<std::time_t>(*seconds) : std::time(nullptr);
  std::tm parts{};
  if ((seconds ? ::gmtime_r(&now, &parts) : ::localtime_r(&now, &parts)) == nullptr) return "";
  using namespace std::chrono;
  return iso_day(year(parts.tm_year + 1900) / month(static_cast<unsigned>(parts.tm_mon) + 1) /
                 day(static_cast<unsigned>(parts.tm_mday)));
}

Result<std::string> plan_date(std::string_view said) {
  if (text::trim(said).empty()) return today();
  if (std::string date = iso_date(said); !date.empty()) return date;
  return fail(formats::plan_date_refusal(said));
}

json::Value plan_to_json(const PlannedTest& planned) {
  json::Value root = formats::plan_value(planned.plan);
  root.add("findings", findings_to_json(planned.findings));
  root.add("duration_s", std::round(planned.duration_in_all.in_s() * 10.0) / 10.0);
  return root;
}

Result<std::string> plan_sheet_file(const PlannedTest& planned, std::string_view extension,
                                    const report::Options& options) {
  return document_bytes(sheet_of(planned, options), extension, options);
}

Result<void> write_plan_outputs(const PlannedTest& planned, const OutputNames& names, const report::Options& options) {
  AXIOMETRY_TRY_VOID(write_document(sheet_of(planned, options), names.reports, options));
  if (names.json.empty()) return {};
  return write_file(names.json, json::dump(plan_to_json(planned)) + "\n");
}

}  // namespace axiometry::app
