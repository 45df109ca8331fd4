// SPDX-License-Identifier: Apache-2.0
#include "server/http/request_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "axiometry/app/files/given_text.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/time/iso_date.h"
#include "axiometry/report/option_words.h"

namespace axiometry::server {
Result<store::Id> id_of(const Request& request, std::string_view what) {
  const std::string_view segment = request.segment("id");
  const auto id = parse_count(segment);
  if (!id || *id == 0 || *id > static_cast<unsigned long long>(store::id_max))
    return fail(ErrorKind::not_found, fmt::format("found no {} {}", what, text::quoted(segment)));
  return static_cast<store::Id>(*id);
}

Result<std::optional<int>> version_of(const Request& request) {
  AXIOMETRY_TRY(const auto version, whole_of(request, "version", store::id_max));
  if (!version) return std::optional<int>();
  if (*version == 0) return fail("found the version 0, expected a whole number from 1");
  return std::optional(static_cast<int>(*version));
}

Result<std::optional<std::int64_t>> whole_of(const Request& request, std::string_view name, std::int64_t largest) {
  const auto text = request.parameter(name);
  if (!text || text->empty()) return std::optional<std::int64_t>();
  const auto number = parse_count(*text);
  if (!number || *number > static_cast<unsigned long long>(largest))
    return fail(fmt::format("found {}={}, expected a whole number from 0 to {}", name, text::quoted(*text), largest));
  return std::optional(static_cast<std::int64_t>(*number));
}

Result<std::optional<store::Id>> id_parameter(const Request& request, std::string_view name) {
  const auto text = request.parameter(name);
  if (!text || text->empty()) return std::optional<store::Id>();
  const auto number = parse_count(*text);
  if (!number || *number == 0 || *number > static_cast<unsigned long long>(store::id_max))
    return fail(
        fmt::format("found {}={}, expected a whole number from 1 to {}", name, text::quoted(*text), store::id_max));
  return std::optional(static_cast<store::Id>(*number));
}

Result<std::string> date_of(const Request& request, std::string_view name) {
  const std::string text(request.parameter(name).value_or(""));
  if (!text.empty() && iso_date(text) != text)
    return fail(fmt::format("found {}={}, expected a date such as 2026-01-31", name, text::quoted(text)));
  return text;
}

Result<DateRange> dates_of(const Request& request) {
  DateRange dates;
  AXIOMETRY_TRY(dates.from, date_of(request, "from"));
  AXIOMETRY_TRY(dates.to, date_of(request, "to"));
  if (!dates.from.empty() && !dates.to.empty() && dates.from > dates.to)
    return fail(fmt::format("found from={} after to={}, expected a day no later", text::quoted(dates.from),
                            text::quoted(dates.to)));
  return dates;
}

Result<bool> flag_of(const Request& request, std::string_view name, bool otherwise) {
  const auto text = request.parameter(name);
  if (!text || text->empty()) return otherwise;
  if (*text == "1" || *text == "true" || *text == "yes") return true;
  if (*text == "0" || *text == "false" || *text == "no") return false;
  return fail(fmt::format("found {}={}, expected 1 or 0", name, text::quoted(*text)));
}

Result<void> choose_number_style(std::string_view decimal, std::string_view unit, report::Options& options) {
  if (!decimal.empty()) {
    AXIOMETRY_TRY(options.numbers.decimal_mark, report::decimal_mark_of(decimal));
  }
  if (!unit.empty()) {
    AXIOMETRY_TRY(options.unit, report::unit_of(unit));
  }
  return {};
}

Result<report::Options> report_options_of(const Request& request) {
  report::Options options;
  options.language = request.language;
  options.numbers = language::usual_numbers(request.language);
  AXIOMETRY_TRY_VOID(
      choose_number_style(request.parameter("decimal").value_or(""), request.parameter("unit").value_or(""), options));
  return options;
}

Result<app::Reader> reader_of(const Request& request) {
  AXIOMETRY_TRY(const report::Options options, report_options_of(request));
  return app::Reader{request.language, options.numbers};
}

store::By by_of(const Request& request, std::string reason) { return {request.actor, std::move(reason)}; }

Result<json::Value> optional_json_body(const Request& request) {
  if (text::trim(request.body).empty()) return json::Value::object();
  return json_body(request);
}

Result<std::string> line_member(const json::Value& body, std::string_view name) {
  const json::Value* value = body.find(name);
  if (value == nullptr || value->is(json::Kind::null)) return std::string();
  if (!value->is(json::Kind::text))
    return fail(fmt::format("{}: found {}, expected a text", name, json::kind_name(value->kind())), value->at());
  return app::given_line(name, value->text());
}

Result<Pairs> options_member(const json::Value& body) {
  Pairs options;
  const json::Value* given = body.find("options");
  if (given == nullptr || given->is(json::Kind::null)) return options;
  if (!given->is(json::Kind::object))
    return fail(fmt::format("options: found {}, expected object", json::kind_name(given->kind())), given->at());
  for (const auto& [name, value] : given->members()) {
    if (value.is(json::Kind::array) || value.is(json::Kind::object))
      return fail(fmt::format("{}: found {}, expected a text", name, json::kind_name(value.kind())), value.at());
    if (value.is(json::Kind::text)) options.emplace_back(name, value.text());
    if (value.is(json::Kind::number)) options.emplace_back(name, format_exact(value.number()));
    if (value.is(json::Kind::boolean)) options.emplace_back(name, value.boolean() ? "1" : "0");
  }
  return options;
}

}  // namespace axiometry::server
