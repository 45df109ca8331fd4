// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/named_findings_json.h"

namespace axiometry::app {

json::Value findings_value(std::span<const NamedFinding> findings) {
  json::Value list = json::Value::array();
  for (const NamedFinding& f : findings) {
    json::Value& item = list.push(json::Value::object());
    item.add("id", f.id);
    item.add("severity", f.serious ? "serious" : "note");
    item.add("message", f.message);
  }
  return list;
}

}  // namespace axiometry::app
