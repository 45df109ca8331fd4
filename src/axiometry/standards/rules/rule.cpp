// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/rules/rule.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "axiometry/base/text/text.h"

namespace axiometry::standards {
namespace {

struct EvidenceWords {
  std::string_view key;
  std::string_view source;
  std::string_view words;
};

constexpr std::array<EvidenceWords, 4> words_of_evidence{{
    {"text", "text of the rule", "read in the text of the rule"},
    {"makers-text", "a maker's manual", "from a maker's manual, not checked against the text of the rule"},
    {"program", "another program", "from the code of another program, not checked against the text of the rule"},
    {"second-hand", "second-hand", "second-hand, not checked against the text of the rule"},
}};

}  // namespace

std::string_view evidence_key(Evidence evidence) { return words_of_evidence[static_cast<std::size_t>(evidence)].key; }

std::string_view evidence_source(Evidence evidence) {
  return words_of_evidence[static_cast<std::size_t>(evidence)].source;
}

std::string_view evidence_words(Evidence evidence) {
  return words_of_evidence[static_cast<std::size_t>(evidence)].words;
}

const AxisRule* find_axis_rule(std::string_view id) {
  const auto all = axis_rule_table();
  const auto found = std::ranges::find(all, id, &AxisRule::id);
  return found == all.end() ? nullptr : *found;
}

Result<const AxisRule*> rule_named(std::string_view id) {
  if (const AxisRule* rule = find_axis_rule(id)) return rule;
  std::vector<std::string_view> known;
  for (const auto* each : axis_rule_table()) known.push_back(each->id);
  return fail(fmt::format("found {}, expected one of {}", text::quoted(id), fmt::join(known, ", ")));
}

}  // namespace axiometry::standards
