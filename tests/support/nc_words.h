// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "tests/support/nc_machine.h"

/// Blocks of words, as every control but Heidenhain's reads them.
namespace axiometry::testing_support {

/// What the words of one control mean.
struct WordRules {
  std::set<std::string> start;       ///< G words that must have come before the first move, besides the unit
  std::set<std::string> harmless{};  ///< others that may come
  std::string metric = "21";
  std::string inch = "20";
  std::string every_block{};  ///< a G word that must stand in each move
  char dwell_letter = 'P';
  double dwell_unit_s = 1.0;  ///< of a number as it stands
  bool dwell_needs_point = true;
  std::set<std::string> offsets{};  ///< G words of work offsets: "54"
  std::string machine_g{};          ///< G word by which a block's positions are those of the machine
  std::string numbered_offset{};    ///< G word of offsets that a number follows: "54.1"
  char offset_letter = 'P';         ///< of that number
};

/// Runs blocks of words: "N10 G1 X1=5.0 F100".
class WordMachine {
 public:
  explicit WordMachine(WordRules rules, NcSetup setup = {}) : rules_(std::move(rules)), machine_(setup) {}

  void block(std::string_view text) {
    std::vector<std::pair<std::string, std::string_view>> words = words_of(text);
    if (!words.empty() && words.front().first == "N") {
      nc_number(words.front().second);
      words.erase(words.begin());
    }
    bool suppressed = false;  // Siemens: SUPA
    std::multimap<std::string, std::string_view> g_and_m;
    std::map<std::string, std::string_view> others;
    for (const auto& [letter, value] : words) {
      if (letter == "G" || letter == "M")
        g_and_m.emplace(letter, value);
      else if (letter == "S" && value == "UPA" && rules_.machine_g == "SUPA")
        suppressed = true;
      else if (letter == "D" && value == "0" && rules_.machine_g == "SUPA" && words.size() == 1)
        tool_off_ = true;
      else if (letter == std::string(1, rules_.offset_letter) && !rules_.numbered_offset.empty() && words.size() == 2 &&
               words.front() == std::pair<std::string, std::string_view>("G", rules_.numbered_offset))
        return machine_.select_frame(rules_.numbered_offset + letter + std::string(value));
      else if (letter.find_first_not_of("FPKXYZUVWABC0123456789") != std::string::npos)
        throw std::runtime_error("the word " + letter);
      else if (!others.emplace(letter, value).second)
        throw std::runtime_error("a word twice: " + letter);
    }
    bool move = false, dwell = false, exact = rules_.every_block.empty();
    std::optional<std::string> frame;
    if (suppressed && !tool_off_) throw std::runtime_error("SUPA with the tool's offset");
    if (suppressed) frame = "machine";
    for (auto [g, end] = g_and_m.equal_range("G"); g != end; ++g) {
      const std::string code(g->second);
      if (code == "1")
        move = true;
      else if (code == "4")
        dwell = true;
      else if (code == rules_.metric || code == rules_.inch)
        unit_ = code;
      else if (code == rules_.every_block)
        exact = true;
      else if (code == rules_.machine_g)
        frame = "machine";
      else if (rules_.offsets.contains(code))
        machine_.select_frame(code);
      else if (code == "91")
        incremental_ = true;
      else if (code == "90" && std::exchange(incremental_, false))
        seen_.insert(code);
      else if (rules_.start.contains(code))
        seen_.insert(code);
      else if (!rules_.harmless.contains(code))
        throw std::runtime_error("G" + code);
    }
    if (move)
      run_move(others, exact, frame);
    else if (frame)
      throw std::runtime_error("a frame without a move");
    else if (dwell)
      run_dwell(others);
    else if (!others.empty())
      throw std::runtime_error("words without a command: " + others.begin()->first);
    for (auto [m, end] = g_and_m.equal_range("M"); m != end; ++m)
      machine_.m_code(static_cast<unsigned>(nc_number(m->second)));
  }

  Trace finish() && {
    if (incremental_) throw std::runtime_error("increments are left on");
    return std::move(machine_).finish();
  }

 private:
  static std::vector<std::pair<std::string, std::string_view>> words_of(std::string_view text) {
    std::vector<std::pair<std::string, std::string_view>> words;
    text = trimmed(text);
    while (!text.empty()) {
      const std::size_t blank = std::min(text.find(' '), text.size());
      const std::string_view word = text.substr(0, blank);
      const std::size_t equals = word.find('=');
      if (word[0] < 'A' || word[0] > 'Z') throw std::runtime_error("no word: " + std::string(word));
      if (equals == std::string_view::npos)
        words.emplace_back(word.substr(0, 1), word.substr(1));
      else
        words.emplace_back(word.substr(0, equals), word.substr(equals + 1));
      text = trimmed(text.substr(blank));
    }
    return words;
  }

  void run_move(const std::map<std::string, std::string_view>& words, bool exact,
                const std::optional<std::string>& frame) {
    if (seen_ != rules_.start || unit_.empty() || !exact) throw std::runtime_error("a move before a safe start");
    if (!words.contains("F")) throw std::runtime_error("a move without a feed");
    NcMachine::Words axes;
    for (const auto& [letter, value] : words)
      if (letter != "F") axes.emplace_back(letter, value);
    if (incremental_ && frame) throw std::runtime_error("increments in the machine's frame");
    if (incremental_)
      machine_.move_by(axes, nc_number(words.at("F")), unit_ == rules_.inch);
    else
      machine_.move(axes, nc_number(words.at("F")), unit_ == rules_.inch, 1.0, frame);
  }

  void run_dwell(const std::map<std::string, std::string_view>& words) {
    if (words.size() != 1 || words.begin()->first != std::string(1, rules_.dwell_letter))
      throw std::runtime_error("a dwell with other words");
    const std::string_view value = words.begin()->second;
    if ((value.find('.') != std::string_view::npos) != rules_.dwell_needs_point)
      throw std::runtime_error("point in dwell");
    machine_.dwell(nc_number(value) * rules_.dwell_unit_s);
  }

  WordRules rules_;
  NcMachine machine_;
  std::set<std::string> seen_;
  std::string unit_;
  bool incremental_ = false;
  bool tool_off_ = false;
};

}  // namespace axiometry::testing_support
