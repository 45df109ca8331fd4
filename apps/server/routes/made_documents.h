// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/app/workbench/workbench_values.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/report/document.h"
#include "axiometry/report/report.h"
#include "server/http/http.h"

/// What routes have in common: what they make to look at or to take along.
namespace axiometry::server {

/// What the query asks of the document that the path's {extension} names. Fails where nothing writes such a one, before
/// anything is computed for it.
Result<report::Options> document_options_of(const Request& request);

/// As the path's {extension} says: a document to look at, or with ?download= as a file.
Result<Response> document_response(const report::Document& document, const Request& request,
                                   const report::Options& options, std::string_view stem);

/// What the path's {extension} and the query ask of a report of the archive.
Result<app::ReportRequest> report_request_of(const Request& request);
/// That report, to look at, or with ?download= as a file; JSON always as a file.
Result<Response> rendered_response(app::Rendered rendered, const Request& request);

/// Whether the path's {extension} is json.
bool wants_json(const Request& request);
Response json_file(const json::Value& value, std::string_view stem);

/// Text to look at, or to keep as a file.
Response made_text_response(std::string program, bool to_keep, std::string_view file_name);

}  // namespace axiometry::server
