// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/nc_semicolon_readers.h"

/// Heidenhain's conversational language.
namespace axiometry::testing_support {

inline Trace run_klartext(std::string_view program, NcSetup setup) {
  std::vector<std::string> lines;
  for (std::string_view line : lines_of(program)) {
    if (nc_number(take_until(line, " ")) != static_cast<double>(lines.size())) throw std::runtime_error("block number");
    lines.push_back(without_semicolon_comment(line));
  }
  if (lines.size() < 2 || !lines.front().starts_with("BEGIN PGM ") || lines.back() != "END" + lines.front().substr(5))
    throw std::runtime_error("not from BEGIN to END of one program");
  const bool inch = lines.front().ends_with(" INCH");
  if (!inch && !lines.front().ends_with(" MM")) throw std::runtime_error("no unit");
  NcMachine machine(setup);
  std::map<double, std::size_t> labels;
  double left = -1.0;  // repeats of the section that is being repeated; negative: none is
  bool dwell = false, long_way = false;
  for (std::size_t k = 1; k + 1 < lines.size(); ++k) {
    std::string_view line = lines[k];
    if (std::exchange(dwell, false)) {
      machine.dwell(number_after(line, "CYCL DEF 9.1 DWELL "));
    } else if (line.starts_with("LBL ")) {
      if (const auto [label, added] = labels.emplace(number_after(line, "LBL "), k); !added && label->second != k)
        throw std::runtime_error("a label twice");
    } else if (line.starts_with("CALL LBL ")) {
      take_until(line, "CALL LBL ");
      const std::size_t begin = labels.at(nc_number(take_until(line, " REP ")));
      if (left < 0.0) left = nc_number(line);
      if (left > 0.0) k = begin;
      --left;
    } else if (line.starts_with("L ")) {
      line.remove_prefix(2);
      bool by = false;
      NcMachine::Words axes;
      for (std::string_view words = take_until(line, " R0 F"); !words.empty();) {
        const std::string_view word = words.substr(0, words.find(' '));
        words = trimmed(words.substr(word.size()));
        by = by || word.starts_with('I');
        if (by && !word.starts_with('I')) throw std::runtime_error("increments beside positions");
        const std::string_view coordinate = word.substr(by ? 2 : 1);
        if (!coordinate.starts_with('+') && !coordinate.starts_with('-'))
          throw std::runtime_error("a coordinate without a sign");
        axes.emplace_back(word.substr(by, 1), coordinate);
      }
      const bool of_machine = line.ends_with(" M91");
      if (of_machine) line.remove_suffix(4);
      if (by && (of_machine || !long_way)) throw std::runtime_error("an increment that may go elsewhere");
      if (by)
        machine.move_by(axes, nc_number(line), inch, 10.0);
      else
        machine.move(axes, nc_number(line), inch, 10.0,
                     of_machine ? std::optional<std::string>("machine") : std::nullopt);
    } else if (line == "CYCL DEF 9.0 DWELL TIME") {
      dwell = true;
    } else if (line == "M127") {
      long_way = true;
    } else if (line == "STOP") {
      machine.m_code(0);
    } else if (line.starts_with('M')) {
      machine.m_code(static_cast<unsigned>(number_after(line, "M")));
    } else if (!line.empty()) {
      throw std::runtime_error(std::string(line));
    }
  }
  return std::move(machine).finish();
}

}  // namespace axiometry::testing_support
