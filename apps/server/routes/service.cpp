// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "axiometry/base/version.h"
#include "axiometry/language/language.h"
#include "server/routes/routes.h"
#include "server/routes/vocabulary.h"

namespace axiometry::server {
namespace {

json::Value text_or_null(const std::string& text) { return text.empty() ? json::Value() : json::Value(text); }

json::Value count_value(std::int64_t count) { return static_cast<double>(count); }

json::Value counts_value(const store::Counts& counts) {
  json::Value value = json::Value::object();
  value.add("machines", count_value(counts.machines));
  value.add("axes", count_value(counts.axes));
  value.add("instruments", count_value(counts.instruments));
  value.add("plans", count_value(counts.plans));
  value.add("tests", count_value(counts.tests));
  value.add("documents", count_value(counts.documents));
  value.add("content_bytes", count_value(counts.content_bytes));
  return value;
}

json::Value store_value(const store::Info& info, const store::Counts& counts, language::Language language) {
  json::Value value = json::Value::object();
  value.add("kind", info.kind);
  value.add("location", info.location);
  value.add("schema", info.schema);
  value.add("writable", info.writable);
  value.add("why_not", text_or_null(language::translated(info.why_not, language)));
  value.add("counts", counts_value(counts));
  return value;
}

Result<Response> health(const ServiceContext& context, const Request& request) {
  json::Value value = json::Value::object();
  value.add("status", "ok");
  if (!context.token.knows(request)) return json_response(value);
  AXIOMETRY_TRY(const store::Counts counts, context.store.counts());
  json::Value program = json::Value::object();
  program.add("name", "axiometry");
  program.add("version", version);
  value.add("program", std::move(program));
  value.add("store", store_value(context.store.info(), counts, request.language));
  json::Value limits = json::Value::object();
  limits.add("upload_bytes", context.upload_bytes);
  value.add("limits", std::move(limits));
  value.add("token", context.token.wanted());
  return json_response(value);
}

Response description() {
  return {.body = std::string(openapi_files().front().bytes),
          .headers = {{"Cache-Control", "no-cache"}, {"Content-Disposition", "inline; filename=\"openapi.json\""}}};
}

}  // namespace

void add_service_routes(Router& router, const ServiceContext& context) {
  router.add("GET", "/api/health", [context](const Request& request) { return health(context, request); });
  router.add("GET", "/api/openapi.json", [](const Request&) -> Result<Response> { return description(); });
  router.add("GET", "/api/vocabulary",
             [](const Request& request) -> Result<Response> { return json_response(vocabulary(request.language)); });
}

}  // namespace axiometry::server
