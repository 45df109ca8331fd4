// SPDX-License-Identifier: Apache-2.0
#include "server/routes/made_documents.h"

#include <fmt/format.h>

#include <utility>

#include "axiometry/app/results/outputs.h"
#include "axiometry/base/text/text.h"
#include "server/http/request_values.h"

namespace axiometry::server {

Result<report::Options> document_options_of(const Request& request) {
  if (!wants_json(request)) AXIOMETRY_TRY_VOID(app::document_writer(text::to_lower(request.segment("extension"))));
  return report_options_of(request);
}

Result<Response> document_response(const report::Document& document, const Request& request,
                                   const report::Options& options, std::string_view stem) {
  AXIOMETRY_TRY(const bool to_keep, flag_of(request, "download", false));
  const std::string extension = text::to_lower(request.segment("extension"));
  AXIOMETRY_TRY(std::string bytes, app::document_bytes(document, extension, options));
  const std::string_view type = app::media_type_of(extension);
  if (to_keep) return download(std::move(bytes), type, fmt::format("{}.{}", stem, extension));
  Response response{
      .content_type = std::string(type), .body = std::move(bytes), .headers = {{"Cache-Control", "no-store"}}};
  if (extension == "html" || extension == "svg")
    response.headers.emplace_back("Content-Security-Policy", document_policy);
  return response;
}

Result<app::ReportRequest> report_request_of(const Request& request) {
  AXIOMETRY_TRY(const report::Options options, report_options_of(request));
  return app::ReportRequest{std::string(request.segment("extension")), options, request.language, request.stop};
}

Result<Response> rendered_response(app::Rendered rendered, const Request& request) {
  AXIOMETRY_TRY(const bool as_file, flag_of(request, "download", false));
  if (as_file || rendered.media_type == "application/json")
    return download(std::move(rendered.bytes), rendered.media_type, rendered.file_name);
  const bool is_document = rendered.media_type.starts_with("text/html") || rendered.media_type == "image/svg+xml";
  Response response{.content_type = std::move(rendered.media_type), .body = std::move(rendered.bytes)};
  if (is_document) response.headers.emplace_back("Content-Security-Policy", document_policy);
  return response;
}

bool wants_json(const Request& request) { return text::to_lower(request.segment("extension")) == "json"; }

Response json_file(const json::Value& value, std::string_view stem) {
  return download(json::dump(value) + "\n", "application/json", fmt::format("{}.json", stem));
}

Response made_text_response(std::string program, bool to_keep, std::string_view file_name) {
  constexpr std::string_view type = "text/plain; charset=utf-8";
  if (to_keep) return download(std::move(program), type, file_name);
  return {.content_type = std::string(type), .body = std::move(program), .headers = {{"Cache-Control", "no-store"}}};
}

}  // namespace axiometry::server
