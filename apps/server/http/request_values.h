// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/workbench/workbench_json.h"
#include "axiometry/report/report.h"
#include "axiometry/store/records.h"
#include "server/http/http.h"

/// What routes read out of requests, checked.
namespace axiometry::server {

/// The number of the path's {id}. Fails with not_found, naming `what`: "test".
Result<store::Id> id_of(const Request& request, std::string_view what);

/// ?version=. Fails on what is no whole number from 1.
Result<std::optional<int>> version_of(const Request& request);

/// A whole number of the query from 0 to `largest`. Fails on another.
Result<std::optional<std::int64_t>> whole_of(const Request& request, std::string_view name, std::int64_t largest);

/// The number of a thing in the archive, from 1. Fails on another value.
Result<std::optional<store::Id>> id_parameter(const Request& request, std::string_view name);

/// A date of the query, "2026-01-31"; empty where there is none. Fails on other text and on a day that does not exist.
Result<std::string> date_of(const Request& request, std::string_view name);

/// Days from ?from= to ?to=, each empty where there is none. Fails as date_of() does, and where the first is after the
/// last.
struct DateRange {
  std::string from, to;
};
Result<DateRange> dates_of(const Request& request);

/// "1", "true" and "yes", or "0", "false" and "no". Fails on other words.
Result<bool> flag_of(const Request& request, std::string_view name, bool otherwise);

/// The language of the request, and its decimal mark: ?decimal=comma or point, else the usual one. Fails on another
/// mark.
Result<app::Reader> reader_of(const Request& request);

/// ?decimal= and ?unit=um, mm, nm, deg or arcsec. Fails on other words.
Result<report::Options> report_options_of(const Request& request);
/// The same words from elsewhere; empty ones change nothing.
Result<void> choose_number_style(std::string_view decimal, std::string_view unit, report::Options& options);

store::By by_of(const Request& request, std::string reason = {});

/// The body as an object; no body stands for an empty one.
Result<json::Value> optional_json_body(const Request& request);

/// A line of text in the body; empty where there is none.
Result<std::string> line_member(const json::Value& body, std::string_view name);
/// The members of "options" as texts, as a query would have them; numbers and switches are taken as such.
Result<Pairs> options_member(const json::Value& body);

}  // namespace axiometry::server
