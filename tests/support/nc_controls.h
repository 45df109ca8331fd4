// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/nc_klartext.h"

/// What each control makes of a program's text: the second opinion to src/axiometry/nc/dialects.
namespace axiometry::testing_support {

/// Throws when the control, as far as it is known here, would not take the program.
inline Trace run_blocks(std::string_view dialect, std::string_view program, NcSetup setup) {
  const std::set<std::string> mill = {"17", "40", "49", "80", "90", "94"};
  const auto with = [&](std::string exact) {
    std::set<std::string> start = mill;
    start.insert(std::move(exact));
    return start;
  };
  const std::set<std::string> offsets = {"54", "55", "56", "57", "58", "59"};
  const WordRules fanuc = {
      .start = with("61"), .harmless = {"64"}, .dwell_letter = 'X', .offsets = offsets, .numbered_offset = "54.1"};
  WordRules rules = fanuc;
  if (dialect == "fanuc" || dialect == "mazak-eia" || dialect == "mitsubishi")
    return run_macro_b(program, rules, setup, true, true);
  if (dialect == "haas") {
    rules.dwell_letter = 'P';
    rules.numbered_offset = "154";
    return run_macro_b(program, rules, setup, true, true);
  }
  if (dialect == "iso6983") {
    rules = {.start = {"17", "40", "80", "90", "94"}, .every_block = "9", .dwell_letter = 'X', .offsets = offsets};
    return run_macro_b(program, rules, setup, true, false);
  }
  if (dialect == "grbl")
    return run_macro_b(program, {.start = with("61"), .offsets = offsets, .machine_g = "53"}, setup, false, false);
  if (dialect == "linuxcnc") {
    rules = {.start = with("61.1"), .harmless = {"64"}, .offsets = offsets, .machine_g = "53"};
    rules.offsets.insert({"59.1", "59.2", "59.3"});
    return run_o_words(program, rules, setup);
  }
  if (dialect == "siemens-840d") {
    rules = {.start = {"17", "40", "90", "94", "60", "601"}, .harmless = {"64"}, .metric = "710", .inch = "700"};
    rules.dwell_letter = 'F';
    rules.offsets = {"54", "57", "500", "505", "599"};
    rules.machine_g = "SUPA";
    return run_siemens(program, rules, setup);
  }
  if (dialect == "okuma") {
    rules = {.start = {"17", "40", "80", "90", "94", "61"}, .harmless = {"64"}, .dwell_letter = 'F'};
    rules.numbered_offset = "15";
    rules.offset_letter = 'H';
    return run_okuma(program, rules, setup);
  }
  if (dialect == "fagor") {
    rules = {.start = {"17", "40", "90", "94", "7"}, .metric = "71", .inch = "70", .dwell_letter = 'K'};
    rules.dwell_unit_s = 0.01;
    rules.dwell_needs_point = false;
    rules.offsets = offsets;
    rules.machine_g = "53";
    return run_fagor(program, rules, setup);
  }
  if (dialect == "heidenhain") return run_klartext(program, setup);
  throw std::runtime_error("nobody reads " + std::string(dialect));
}

inline Trace run_program(std::string_view dialect, std::string_view program, NcSetup setup = {}) {
  const bool crlf = ends_crlf(program);
  Trace trace = run_blocks(dialect, program, setup);
  trace.crlf = crlf;
  return trace;
}

}  // namespace axiometry::testing_support
