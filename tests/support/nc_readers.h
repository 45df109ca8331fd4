// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "tests/support/nc_words.h"

/// Interpreters of the languages with comments in round brackets: loops, and what stands round the blocks.
namespace axiometry::testing_support {

constexpr std::size_t endless = 1'000'000;

inline void check_characters(std::string_view text, std::string_view allowed) {
  for (char c : text)
    if (!(c >= 'A' && c <= 'Z') && !(c >= '0' && c <= '9') && c != ' ' && allowed.find(c) == std::string_view::npos)
      throw std::runtime_error("a character that the control may not take: " + std::string(text));
}

/// Text outside "(…)"; brackets within brackets are no comment on any control.
inline std::string without_bracket_comments(std::string_view line) {
  std::string text;
  while (line.find('(') != std::string_view::npos) {
    text += take_until(line, "(");
    check_characters(take_until(line, ")"), ".,+-/=[]:");
  }
  if (line.find(')') != std::string_view::npos) throw std::runtime_error("a comment that ends early");
  return std::string(trimmed(text.append(line)));
}

inline double number_after(std::string_view text, std::string_view word) {
  if (!text.starts_with(word)) throw std::runtime_error("no " + std::string(word) + " in " + std::string(text));
  return nc_number(trimmed(text.substr(word.size())));
}

/// Fanuc and what follows it: O number between per cents, WHILE … DO1 with #1. Without a number, no per cents (grbl).
inline Trace run_macro_b(std::string_view program, const WordRules& rules, NcSetup setup, bool with_number,
                         bool macros) {
  WordMachine machine(rules, setup);
  std::vector<std::string> lines;
  for (std::string_view line : lines_of(program)) lines.push_back(without_bracket_comments(line));
  if (with_number) {
    if (lines.size() < 3 || lines.front() != "%" || lines.back() != "%") throw std::runtime_error("no per cents");
    if (!lines[1].starts_with('O') || nc_number(lines[1].substr(1)) < 1) throw std::runtime_error("no program number");
    lines = {lines.begin() + 2, lines.end() - 1};
  }
  std::optional<double> counter;
  std::optional<std::size_t> loop;
  std::size_t steps = 0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    std::string_view line = lines[k];
    if (++steps > endless) throw std::runtime_error("an endless loop");
    if ((line.starts_with('#') || line.starts_with("WHILE") || line.starts_with("END")) && !macros)
      throw std::runtime_error("a macro");
    if (line == "#1=#1+1")
      counter = counter.value() + 1.0;
    else if (line.starts_with("#1="))
      counter = number_after(line, "#1=");
    else if (line.starts_with("WHILE")) {
      take_until(line, "[#1 LE ");
      const bool again = counter.value() <= nc_number(take_until(line, "]"));
      if (line != " DO1") throw std::runtime_error("no DO1");
      loop = k;
      while (!again && lines.at(k) != "END1") ++k;
    } else if (line == "END1")
      k = loop.value() - 1;
    else if (!line.empty())
      machine.block(line);
  }
  return std::move(machine).finish();
}

/// LinuxCNC: o1 repeat [5] … o1 endrepeat.
inline Trace run_o_words(std::string_view program, const WordRules& rules, NcSetup setup) {
  WordMachine machine(rules, setup);
  std::vector<std::string> lines;
  for (std::string_view line : lines_of(program)) lines.push_back(without_bracket_comments(line));
  std::string label;
  std::size_t begin = 0;
  double left = 0.0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    std::string_view line = lines[k];
    if (line.empty()) continue;
    if (!line.starts_with('o')) {
      machine.block(line);
    } else if (line.ends_with("endrepeat")) {
      if (line != label + " endrepeat") throw std::runtime_error("another loop ends");
      if (--left > 0.0)
        k = begin;
      else
        label.clear();
    } else {
      if (!label.empty()) throw std::runtime_error("a loop in a loop");
      label = take_until(line, " repeat [");
      left = nc_number(take_until(line, "]"));
      begin = k;
    }
  }
  return std::move(machine).finish();
}

/// Okuma: VC1 counts, IF [VC1 LT 5] NR1 jumps to the block of that name.
inline Trace run_okuma(std::string_view program, const WordRules& rules, NcSetup setup) {
  WordMachine machine(rules, setup);
  std::vector<std::string> lines;
  for (std::string_view line : lines_of(program)) lines.push_back(without_bracket_comments(line));
  if (lines.empty() || !lines.front().starts_with('O')) throw std::runtime_error("no program name");
  std::optional<double> counter;
  for (std::size_t k = 1, steps = 0; k < lines.size(); ++k) {
    if (++steps > endless) throw std::runtime_error("an endless loop");
    std::string_view line = lines[k];
    if (line.starts_with("NR")) {
      if (take_until(line, " ").size() > 5) throw std::runtime_error("a long block name");
      if (line != "VC1=VC1+1") throw std::runtime_error("no counting");
      counter = counter.value() + 1.0;
    } else if (line.starts_with("VC1=")) {
      counter = number_after(line, "VC1=");
    } else if (line.starts_with("IF [VC1 LT ")) {
      take_until(line, "IF [VC1 LT ");
      if (counter.value() >= nc_number(take_until(line, "] "))) continue;
      const std::string label = std::string(line) + " ";
      while (!lines.at(k).starts_with(label)) --k;
      --k;
    } else if (!line.empty()) {
      machine.block(line);
    }
  }
  return std::move(machine).finish();
}

}  // namespace axiometry::testing_support
