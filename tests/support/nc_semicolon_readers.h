// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/nc_readers.h"

/// Interpreters of the languages in which a comment goes from a semicolon to the end of the line.
namespace axiometry::testing_support {

inline std::string without_semicolon_comment(std::string_view line) {
  const std::size_t at = line.find(';');
  if (at != std::string_view::npos) check_characters(line.substr(at + 1), ".,+-/=[]():");
  return std::string(trimmed(line.substr(0, at)));
}

/// Siemens: FOR … ENDFOR over a variable that was declared first, MSG("…").
inline Trace run_siemens(std::string_view program, const WordRules& rules, NcSetup setup) {
  WordMachine machine(rules, setup);
  std::vector<std::string> lines;
  for (std::string_view line : lines_of(program)) lines.push_back(without_semicolon_comment(line));
  std::string variable;
  bool blocks = false;
  std::size_t begin = 0;
  double value = 0.0, last = 0.0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    std::string_view line = lines[k];
    if (line.empty()) continue;
    if (line.starts_with("DEF INT ")) {
      if (blocks) throw std::runtime_error("a declaration after blocks");
      variable = line.substr(8);
    } else if (line.starts_with("FOR ")) {
      take_until(line, "FOR " + variable + " = ");
      value = nc_number(take_until(line, " TO "));
      last = nc_number(line);
      begin = k;
    } else if (line == "ENDFOR") {
      if (++value <= last) k = begin;
    } else if (line.find("MSG(") != std::string_view::npos) {
      take_until(line, "MSG(");
      if (line == ")") continue;
      take_until(line, "\"");
      check_characters(take_until(line, "\""), ".,+-/=[]():");
      if (line != ")") throw std::runtime_error("a message that ends early");
    } else {
      machine.block(line);
      blocks = true;
    }
  }
  return std::move(machine).finish();
}

/// Fagor 8055: (RPT N1,N2) N4 drives the blocks between two labels four times more.
inline Trace run_fagor(std::string_view program, const WordRules& rules, NcSetup setup) {
  WordMachine machine(rules, setup);
  std::vector<std::string> lines;
  for (std::string_view line : lines_of(program)) lines.push_back(without_semicolon_comment(line));
  if (lines.empty() || !lines.front().starts_with('%') || !lines.front().ends_with(",MX--,"))
    throw std::runtime_error("no program name");
  const auto numberless = [&](std::string_view line) {  // blocks are driven again, so their numbers come again
    if (line.starts_with('N')) take_until(line, " ");
    return line;
  };
  const auto find_label = [&](std::string_view label) {
    std::optional<std::size_t> found;
    for (std::size_t k = 0; k < lines.size(); ++k)
      if (lines[k].starts_with(std::string(label) + " ") && std::exchange(found, k))
        throw std::runtime_error("two labels");
    return found.value();
  };
  for (std::size_t k = 1; k < lines.size(); ++k) {
    std::string_view line = numberless(lines[k]);
    if (line.starts_with("(MSG \"")) {
      check_characters(line.substr(6, line.size() - 8), ".,+-/=");
    } else if (line.starts_with("(RPT ")) {
      take_until(line, "(RPT ");
      const std::size_t first = find_label(take_until(line, ","));
      const std::size_t last = find_label(take_until(line, ") "));
      if (first > last || last >= k) throw std::runtime_error("labels out of order");
      for (double times = number_after(line, "N"); times > 0.0; --times)
        for (std::size_t j = first; j <= last; ++j) machine.block(numberless(lines[j]));
    } else {
      machine.block(line);
    }
  }
  return std::move(machine).finish();
}

}  // namespace axiometry::testing_support
