// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/compensate_flags.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/axis_table.h"
#include "cli/failure.h"
#include "cli/flags/option_text.h"

namespace axiometry::cli {
namespace {

Result<double> number_in(const std::string& text) {
  if (const auto number = parse_number(text)) return *number;
  return fail(fmt::format("found {}, expected a number", text::quoted(text)));
}

/// Larger ones are too large anyhow (app::check_request).
unsigned bounded(unsigned long long n) { return static_cast<unsigned>(std::min(n, 4'294'967'295ull)); }

void add_grid_flags(const Verb& verb, app::CompensateRequest& request) {
  constexpr const char* group = "Positions of the table, mm or °";
  const auto add_place = [&](const char* name, const char* description, std::optional<double>& target) {
    add_number(verb, {name, "NUMBER", description}, [&target](double x) { target = x; })->group(group);
  };
  add_place("--start", "The first one (within the targets)", request.grid.start);
  add_place("--end", "The last one (within the targets)", request.grid.end);
  add_read(verb, {"--step", "NUMBER", "Their spacing, or auto (auto)"},
           [&request](const std::string& text) -> Result<void> {
             if (text::to_lower(text) == "auto") {
               request.grid.step.reset();
               return {};
             }
             AXIOMETRY_TRY(request.grid.step, number_in(text));
             return {};
           })
      ->group(group);
  add_count(verb, {"--points", "N", "How many"}, [&request](unsigned long long n) {
    request.grid.points = static_cast<std::size_t>(n);
  })->group(group);
  verb.add_flag("--hold-ends", request.hold_ends,
                "Beyond the targets hold the value at the last one, which nobody measured there")
      ->group(group);
  add_number(verb, {"--reference", "NUMBER", "Reference point of the machine, where the table does nothing (0)"},
             [&request](double x) { request.table.reference = x; })
      ->group(group);
}

void add_table_flags(const Verb& verb, app::CompensateRequest& request) {
  constexpr const char* group = "Table";
  verb.add_option("--axis", request.axis, "As the control names it (as the test does)")
      ->type_name("AXIS")
      ->group(group);
  add_read(verb, {"--method", "WORD", "least-squares of all readings, or interpolation of means (least-squares)"},
           [&request](const std::string& text) -> Result<void> {
             if (text != "least-squares" && text != "interpolation")
               return fail(fmt::format("found {}, expected least-squares or interpolation", text::quoted(text)));
             request.method =
                 text == "interpolation" ? compensation::Method::interpolation : compensation::Method::least_squares;
             return {};
           })
      ->group(group);
  verb.add_flag("--smooth", request.smooth, "As smooth as foretells targets best that are left out")->group(group);
  add_read(verb,
           {"--curves", "WORD",
            "both-ways: one curve although the control has one for each direction; with-backlash: one, and the number "
            "for the reversal beside it"},
           [&request](const std::string& text) -> Result<void> {
             for (const TableCurves curves : {TableCurves::both_ways, TableCurves::with_backlash})
               if (text == curves_name(curves)) {
                 request.curves = curves;
                 return {};
               }
             return fail(fmt::format("found {}, expected both-ways or with-backlash", text::quoted(text)));
           })
      ->group(group);
  verb.add_flag("--turned-sign", request.table.turned_sign,
                "The other sign than was inferred of the control, where a re-test has shown it")
      ->group(group);
  verb.add_flag("--inch", request.table.in_inch, "The control counts in inches")->group(group);
  add_count(verb, {"--number", "N", "Of the table, encoder, joint or first point, as the control counts (0)"},
            [&request](unsigned long long n) { request.table.number = bounded(n); })
      ->group(group);
  add_read(verb, {"--resolution", "NUMBER", "What one count of the control stands for, µm or ″ (1)"},
           [&request](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(request.table.resolution, number_in(text));
             request.resolution_said = true;
             return {};
           })
      ->group(group);
  add_count(verb, {"--magnification", "N", "By which the control multiplies the table's numbers (1)"},
            [&request](unsigned long long n) { request.table.magnification = bounded(n); })
      ->group(group);
  add_count(verb,
            {"--largest", "N", "Number that the control takes in its table (the least that is known of its kind)"},
            [&request](unsigned long long n) { request.table.largest = bounded(n); })
      ->group(group);
  add_read(verb, {"--steps-per-unit", "NUMBER", "Steps per mm or ° of a control without tables, before any change"},
           [&request](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(request.table.steps_per_unit, number_in(text));
             if (request.table.steps_per_unit != 0.0) return {};
             return fail(fmt::format("found {}, expected a number above 0", text::quoted(text)));
           })
      ->group(group);
}

}  // namespace

void add_measured_flags(const Verb& verb, app::CompensateRequest& request) {
  constexpr const char* group = "Table";
  add_read(verb,
           {"--periodic", "WORD",
            "leave: the periodic part of screw or scale stays out of the table; keep: as the readings have it (keep)"},
           [&request](const std::string& text) -> Result<void> {
             if (text != "keep" && text != "leave")
               return fail(fmt::format("found {}, expected keep or leave", text::quoted(text)));
             request.periodic = text == "leave" ? compensation::Periodic::leave : compensation::Periodic::keep;
             return {};
           })
      ->group(group);
  add_number(verb, {"--period", "NUMBER", "Its period, mm or ° (axis.expected_period of the test)"},
             [&request](double x) { request.period = x; })
      ->group(group);
  add_read(verb, {"--existing-unit", "UNIT", "mm or inch: of the table that was active (that of the new one)"},
           [&request](const std::string& text) -> Result<void> {
             if (text != "mm" && text != "inch")
               return fail(fmt::format("found {}, expected mm or inch", text::quoted(text)));
             request.existing_in_inch = text == "inch";
             return {};
           })
      ->group(group);
}

void check_control_named(const app::CompensateRequest& request) {
  if (request.control.empty()) throw MissingOption("--for");
  if (const auto known = nc::axis_table_named(request.control); !known)
    throw UsageError("--for", known.error().message);
}

void add_compensate_flags(const Verb& verb, app::CompensateRequest& request) {
  verb.add_option("--for", request.control, "One of 'axiometry compensate --list'")->type_name("CONTROL");
  add_grid_flags(verb, request);
  add_table_flags(verb, request);
}

}  // namespace axiometry::cli
