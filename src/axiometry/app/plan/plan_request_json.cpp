// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/plan/plan_request.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/report/drawing/dark_page.h"
#include "axiometry/report/drawing/svg.h"
#include "axiometry/report/figures/programme.h"
#include "axiometry/report/translated.h"

namespace axiometry::app {
namespace {

using json::Kind;
using json::Value;

/// Members of a request that are flags under another name, with the kind they must have.
struct Member {
  std::string_view name;
  std::string_view flag;
  Kind kind;
  bool required = false;
};
constexpr Member flag_members[] = {
    {"axis", "--axis", Kind::text, true},
    {"kind", "--kind", Kind::text, true},
    {"from", "--travel", Kind::number, true},
    {"to", "--travel", Kind::number, true},
    {"positions", "--targets", Kind::array},
    {"targets", "--targets", Kind::number},
    {"cycle", "--cycle", Kind::text},
    {"runs", "--runs", Kind::number},
    {"feed", "--feed", Kind::number},
    {"dwell_s", "--dwell", Kind::number},
    {"overrun", "--overrun", Kind::number},
    {"seed", "--seed", Kind::number},
    {"further", "", Kind::object},
};

/// The error as one about that member.
std::unexpected<Error> about(std::string_view name, const Error& error, TextPosition at) {
  return fail(fmt::format("{}: {}", name, error.message), at);
}

Result<void> apply(std::string_view flag, std::string_view name, const std::string& text, TextPosition at,
                   PlanRequestDraft& wish) {
  const auto option = std::ranges::find(plan_options(), flag, &PlanOption::name);
  if (const auto done = option->apply(text, wish); !done) return about(name, done.error(), at);
  return {};
}

std::unexpected<Error> unknown(std::string_view what, std::string_view name, const std::vector<std::string_view>& known,
                               TextPosition at) {
  const auto near = text::nearest(name, known);
  return fail(fmt::format("found the unknown {} {}, expected {}", what, text::quoted(name),
                          near ? fmt::format("perhaps {}", text::quoted(*near))
                               : fmt::format("one of {}", fmt::join(known, ", "))),
              at);
}

/// Reads one request, member by member.
class RequestReader {
 public:
  explicit RequestReader(const Value& root) : root_(root) {}

  Result<PlanRequestDraft> operator()() {
    AXIOMETRY_TRY_VOID(check_members());
    AXIOMETRY_TRY_VOID(take_travel());
    AXIOMETRY_TRY_VOID(take_positions());
    for (const Member& member : flag_members) AXIOMETRY_TRY_VOID(take(member));
    AXIOMETRY_TRY_VOID(take_further());
    AXIOMETRY_TRY_VOID(check_together());
    return std::move(wish_);
  }

 private:
  const Value* given(std::string_view name) const {
    const Value* value = root_.find(name);
    return value != nullptr && !value->is(Kind::null) ? value : nullptr;
  }

  Result<void> check_members() const {
    if (!root_.is(Kind::object))
      return fail(fmt::format("found {}, expected a request for a plan", json::kind_name(root_.kind())), root_.at());
    for (const auto& [name, value] : root_.members()) {
      const auto member = std::ranges::find(flag_members, std::string_view(name), &Member::name);
      if (member == std::end(flag_members)) {
        std::vector<std::string_view> known;
        for (const Member& m : flag_members) known.push_back(m.name);
        return unknown("member", name, known, value.at());
      }
      if (!value.is(member->kind) && (member->required || !value.is(Kind::null)))
        return fail(fmt::format("{}: found {}, expected {}", name, json::kind_name(value.kind()),
                                json::kind_name(member->kind)),
                    value.at());
    }
    for (const Member& member : flag_members)
      if (member.required && root_.find(member.name) == nullptr)
        return fail(fmt::format("found no member \"{}\", expected axis, kind, from, to", member.name), root_.at());
    return {};
  }

  Result<void> take_travel() {
    const Value& from = *root_.find("from");
    const Value& to = *root_.find("to");
    wish_.request.axis.travel_begin = Position::native(from.number());
    wish_.request.axis.travel_end = Position::native(to.number());
    return {};
  }

  Result<void> take_positions() {
    const Value* positions = given("positions");
    if (positions == nullptr) return {};
    flags_.insert("--targets");
    if (given("targets") != nullptr) return fail("found positions and targets, expected one of them", positions->at());
    if (positions->items().size() > iso230_2::targets_most)
      return fail(fmt::format("positions: found {} of them, expected at most {}", positions->items().size(),
                              iso230_2::targets_most),
                  positions->at());
    if (positions->items().empty()) return fail("positions: found an empty list, expected positions", positions->at());
    for (const Value& x : positions->items()) {
      if (!x.is(Kind::number))
        return fail(fmt::format("positions: found {}, expected a number", json::kind_name(x.kind())), x.at());
      wish_.request.targets.push_back(Position::native(x.number()));
    }
    return {};
  }

  /// What has a flag that reads its text.
  Result<void> take(const Member& member) {
    const Value* value = given(member.name);
    if (value == nullptr || member.kind == Kind::array || member.kind == Kind::object || member.flag == "--travel")
      return {};
    // A page always says the cycle; the standard one contradicts nothing, and gives way to that of another rule.
    if (member.name == "cycle" && value->text() == "standard") return {};
    flags_.insert(std::string(member.flag));
    if (member.kind == Kind::text) return apply(member.flag, member.name, value->text(), value->at(), wish_);
    const bool counts = member.name == "targets" || member.name == "runs" || member.name == "seed";
    const double x = value->number();
    if (counts && (x < 0.0 || x >= static_cast<double>(seed_limit) || x != std::floor(x)))
      return fail(fmt::format("{}: found {}, expected a whole number", member.name, format_exact(x)), value->at());
    return apply(member.flag, member.name, counts ? fmt::format("{:.0f}", x) : format_exact(x), value->at(), wish_);
  }

  Result<void> take_further() {
    const Value* further = given("further");
    if (further == nullptr) return {};
    for (const auto& [name, value] : further->members()) {
      if (!value.is(Kind::text))
        return fail(fmt::format("{}: found {}, expected a string", name, json::kind_name(value.kind())), value.at());
      AXIOMETRY_TRY_VOID(take_flag(name, value));
    }
    return {};
  }

  Result<void> take_flag(const std::string& name, const Value& value) {
    const std::string flag = "--" + name;
    std::vector<std::string_view> known;
    for (const PlanOption& option : plan_options())
      if (std::ranges::find(flag_members, option.name, &Member::flag) == std::end(flag_members))
        known.push_back(option.name.substr(2));
    if (std::ranges::find(known, std::string_view(name)) == known.end()) {
      const auto member = std::ranges::find(flag_members, std::string_view(flag), &Member::flag);
      if (member != std::end(flag_members))
        return fail(fmt::format("found {} in further, expected it as the member \"{}\"", name, member->name),
                    value.at());
      return unknown("flag", name, known, value.at());
    }
    if (text::trim(value.text()).empty()) return {};  // a field that was left empty
    flags_.insert(flag);
    const auto option = std::ranges::find(plan_options(), std::string_view(flag), &PlanOption::name);
    if (!option->repeated) return apply(flag, name, std::string(text::trim(value.text())), value.at(), wish_);
    for (std::string_view part : text::split(value.text(), ','))
      AXIOMETRY_TRY_VOID(apply(flag, name, std::string(text::trim(part)), value.at(), wish_));
    return {};
  }

  Result<void> check_together() const {
    for (const PlanOptionPair& pair : plan_options_apart())
      if (flags_.contains(std::string(pair.name)) && flags_.contains(std::string(pair.other)))
        return fail(
            fmt::format("found both {} and {}, expected one of them", pair.name.substr(2), pair.other.substr(2)),
            root_.at());
    if (wish_.periodic_at && !wish_.request.periodic)
      return fail("found at without periodic, expected both or neither", root_.at());
    return {};
  }

  const Value& root_;
  PlanRequestDraft wish_;
  std::set<std::string> flags_;
};

/// With every member that a request may have, and the seed.
Value settled(const Value& request, std::uint64_t seed) {
  Value whole = Value::object();
  for (const Member& member : flag_members) {
    const Value* value = request.find(member.name);
    const bool given = value != nullptr && !value->is(Kind::null);
    if (member.name == "seed")
      whole.add(member.name, static_cast<double>(seed));
    else if (member.name == "cycle")
      whole.add(member.name, given ? *value : Value("standard"));
    else if (member.kind == Kind::object)
      whole.add(member.name, given ? *value : Value::object());
    else
      whole.add(member.name, given ? *value : Value());
  }
  return whole;
}

Result<RequestedPlan> given_plan(const Value& value) {
  AXIOMETRY_TRY(Plan plan, value.is(Kind::text) ? formats::read_plan(value.text()) : formats::plan_from_value(value));
  AXIOMETRY_TRY_VOID(check_presentable(plan));
  AXIOMETRY_TRY(PlannedTest test, planned(std::move(plan), {}));
  return RequestedPlan{std::move(test), {}};
}

/// As it was asked for, of plans that were kept before they held it themselves.
std::optional<double> asked_acceleration(const Value& request) {
  const Value* further = request.is(Kind::object) ? request.find("further") : nullptr;
  const Value* text = further != nullptr && further->is(Kind::object) ? further->find("acceleration") : nullptr;
  return text != nullptr && text->is(Kind::text) ? parse_number(text::trim(text->text())) : std::nullopt;
}

Value positions_value(const std::vector<Position>& positions) {
  Value list = Value::array();
  for (const Position x : positions) list.push(x.in_native());
  return list;
}

Value findings_told(std::span<const iso230_2::Finding> findings, const Reader& reader) {
  std::vector<iso230_2::Finding> told(findings.begin(), findings.end());
  for (iso230_2::Finding& finding : told)
    finding.message = language::translated(finding.message, reader.language, reader.numbers);
  return findings_to_json(told);
}

Value part_value(const Plan& plan, std::size_t part, const Reader& reader, bool dark) {
  report::Options options;
  options.numbers = reader.numbers;
  options.language = reader.language;
  report::Figure figure = report::with_words_translated(report::programme_figure(plan, options), options);
  Value value = Value::object();
  value.add("part", part);
  value.add("title", language::translated(plan.title, reader.language, reader.numbers));
  value.add("cycle", cycle_name(plan.cycle));
  value.add("runs", plan.runs);
  value.add("readings", approaches(plan).size());
  value.add("targets", positions_value(plan.targets));
  value.add("duration_s", std::round(iso230_2::estimated_duration(plan).in_s() * 10.0) / 10.0);
  value.add("figure_svg", report::to_svg(dark ? report::for_dark_page(std::move(figure)) : figure));
  return value;
}

}  // namespace

std::string write_requested(const RequestedPlan& plan) {
  Value value = plan_to_json(plan.planned);
  if (plan.request.is(Kind::object)) value.add("request", plan.request);
  return json::dump(value) + "\n";
}

Result<RequestedPlan> read_requested(std::string_view bytes) {
  AXIOMETRY_TRY(const Value value, json::parse(bytes));
  AXIOMETRY_TRY(Plan plan, formats::plan_from_value(value));
  const Value* request = value.find("request");
  RequestedPlan read;
  if (request != nullptr) read.request = *request;
  const std::optional<double> asked = plan.acceleration ? std::nullopt : asked_acceleration(read.request);
  AXIOMETRY_TRY(read.planned, planned(std::move(plan), asked));
  return read;
}

Value draft_value(const RequestedPlan& plan, const Reader& reader, bool dark) {
  const PlannedTest& test = plan.planned;
  Value parts = Value::array();
  parts.push(part_value(test.plan, 1, reader, dark));
  for (const Plan& further : test.plan.further) parts.push(part_value(further, parts.items().size() + 1, reader, dark));
  Value value = Value::object();
  value.add("plan", plan_to_json(test));
  value.add("targets", positions_value(test.plan.targets));
  value.add("duration_s", std::round(test.duration_in_all.in_s() * 10.0) / 10.0);
  value.add("findings", findings_told(test.findings, reader));
  value.add("conforming", test.conforming());
  value.add("figure_svg", *parts.items().front().find("figure_svg"));
  value.add("request", plan.request);
  value.add("parts", std::move(parts));
  return value;
}

Result<RequestedPlan> requested_plan_of(const Value& request) {
  AXIOMETRY_TRY(const PlanRequestDraft wish, RequestReader(request)());
  AXIOMETRY_TRY(const iso230_2::PlanRequest complete, completed(wish));
  AXIOMETRY_TRY(Plan plan, iso230_2::make_plan(complete));
  AXIOMETRY_TRY_VOID(check_presentable(plan));
  AXIOMETRY_TRY(PlannedTest test, planned(std::move(plan), {}));
  return RequestedPlan{std::move(test), settled(request, complete.seed)};
}

Result<RequestedPlan> requested_plan(const Value& body) {
  const Value* request = body.find("request");
  const Value* plan = body.find("plan");
  const bool has_request = request != nullptr && !request->is(Kind::null);
  const bool has_plan = plan != nullptr && !plan->is(Kind::null);
  if (has_request == has_plan)
    return fail(fmt::format("found {}, expected one of them",
                            has_plan ? "both a request and a plan" : "neither a request nor a plan"),
                body.at());
  return has_plan ? given_plan(*plan) : requested_plan_of(*request);
}

}  // namespace axiometry::app
