// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/named_findings_json.h"

#include <utility>

namespace axiometry::app {

json::Value findings_value(std::span<const NamedFinding> findings) {
  json::Value list = json::Value::array();
  for (const NamedFinding& f : findings) {
    json::Value& item = list.push(json::Value::object());
    item.add("id", f.id);
    item.add("severity", severity_word(f));
    item.add("message", f.message);
  }
  return list;
}

std::string_view severity_word(const NamedFinding& finding) { return finding.serious ? "serious" : "note"; }

std::vector<KeptFinding> kept_findings(const json::Value& result, std::string_view name) {
  std::vector<KeptFinding> kept;
  const json::Value* findings = result.is(json::Kind::object) ? result.find(name) : nullptr;
  if (findings == nullptr || !findings->is(json::Kind::array)) return kept;
  const auto text_of = [](const json::Value& finding, std::string_view member) {
    const json::Value* text = finding.is(json::Kind::object) ? finding.find(member) : nullptr;
    return text != nullptr && text->is(json::Kind::text) ? text->text() : std::string();
  };
  for (const json::Value& finding : findings->items())
    if (std::string message = text_of(finding, "message"); !message.empty())
      kept.push_back({text_of(finding, "id"), text_of(finding, "severity"), std::move(message)});
  return kept;
}

}  // namespace axiometry::app
