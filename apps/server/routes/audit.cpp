// SPDX-License-Identifier: Apache-2.0
// The audit trail.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "axiometry/app/workbench/equipment_json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "server/http/request_values.h"
#include "server/routes/routes.h"
#include "server/routing/adder.h"

namespace axiometry::server {
namespace {

using json::Value;
using store::Store;

/// "test 12"; empty where none is asked for.
Result<std::string> subject_of(const Request& request) {
  constexpr std::string_view kinds[] = {"test", "machine",     "axis",         "instrument",
                                        "plan", "calibration", "compensation", "document"};
  const std::string_view subject = request.parameter("subject").value_or("");
  const std::size_t space = std::min(subject.find(' '), subject.size());
  const std::string_view number = subject.substr(std::min(space + 1, subject.size()));
  const bool is_one = std::ranges::find(kinds, subject.substr(0, space)) != std::end(kinds) && parse_count(number);
  if (subject.empty() || is_one) return std::string(subject);
  return fail(fmt::format("found subject={}, expected one of {}, with its number, as in \"test 12\"",
                          text::quoted(subject), fmt::join(kinds, ", ")));
}

Result<Response> audit(Store& store, const Request& request) {
  constexpr std::int64_t limit_usual = 100;
  constexpr std::int64_t limit_max = 1000;
  AXIOMETRY_TRY(const auto before, whole_of(request, "before", store::id_max));
  AXIOMETRY_TRY(const auto limit, whole_of(request, "limit", limit_max));
  AXIOMETRY_TRY(const std::string subject, subject_of(request));
  AXIOMETRY_TRY(const auto entries, store.audit(subject, before.value_or(0), limit.value_or(limit_usual)));
  Value object = Value::object();
  Value& rows = object.add("entries", Value::array());
  for (const store::AuditEntry& entry : entries) rows.push(app::to_json(entry));
  return json_response(object);
}

}  // namespace

void add_audit_routes(Router& router, const Context& context) {
  adder(router, context.store)("GET", "/api/audit", audit);
}

}  // namespace axiometry::server
