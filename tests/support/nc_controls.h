// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/nc_klartext.h"

/// What each control makes of a program's text: the second opinion to src/axiometry/nc/dialects.
namespace axiometry::testing_support {

/// Throws when the control, as far as it is known here, would not take the program.
inline Trace run_program(std::string_view dialect, std::string_view program) {
  const std::set<std::string> mill = {"17", "40", "49", "80", "90", "94"};
  const auto with = [&](std::string exact) {
    std::set<std::string> start = mill;
    start.insert(std::move(exact));
    return start;
  };
  const WordRules fanuc = {.start = with("61"), .harmless = {"64"}, .dwell_letter = 'X'};
  WordRules rules = fanuc;
  if (dialect == "fanuc" || dialect == "mazak-eia" || dialect == "mitsubishi")
    return run_macro_b(program, rules, true, true);
  if (dialect == "haas") {
    rules.dwell_letter = 'P';
    return run_macro_b(program, rules, true, true);
  }
  if (dialect == "iso6983") {
    rules = {.start = {"17", "40", "80", "90", "94"}, .every_block = "9", .dwell_letter = 'X'};
    return run_macro_b(program, rules, true, false);
  }
  if (dialect == "grbl") return run_macro_b(program, {.start = with("61")}, false, false);
  if (dialect == "linuxcnc") return run_o_words(program, {.start = with("61.1"), .harmless = {"64"}});
  if (dialect == "siemens-840d") {
    rules = {.start = {"17", "40", "90", "94", "60", "601"}, .harmless = {"64"}, .metric = "710", .inch = "700"};
    rules.dwell_letter = 'F';
    return run_siemens(program, rules);
  }
  if (dialect == "okuma") {
    rules = {.start = {"17", "40", "80", "90", "94", "61"}, .harmless = {"64"}, .dwell_letter = 'F'};
    return run_okuma(program, rules);
  }
  if (dialect == "fagor") {
    rules = {.start = {"17", "40", "90", "94", "7"}, .metric = "71", .inch = "70", .dwell_letter = 'K'};
    rules.dwell_unit_s = 0.01;
    rules.dwell_needs_point = false;
    return run_fagor(program, rules);
  }
  if (dialect == "heidenhain") return run_klartext(program);
  throw std::runtime_error("nobody reads " + std::string(dialect));
}

}  // namespace axiometry::testing_support
