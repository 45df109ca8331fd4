// SPDX-License-Identifier: Apache-2.0
#include "server/routes/test_filter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "axiometry/app/files/given_text.h"
#include "axiometry/base/text/text.h"
#include "server/http/request_values.h"

namespace axiometry::server {
namespace {

using Order = store::TestFilter::Order;

constexpr std::array orders = {
    std::pair{std::string_view("received"), Order::received},
    std::pair{std::string_view("measured"), Order::measured},
    std::pair{std::string_view("title"), Order::title},
    std::pair{std::string_view("machine"), Order::machine},
    std::pair{std::string_view("A"), Order::A},
    std::pair{std::string_view("E"), Order::E},
    std::pair{std::string_view("R"), Order::R},
    std::pair{std::string_view("B"), Order::B},
};

/// Each word is looked for in every test.
Result<std::string> searched_text(const std::string& text) {
  constexpr std::size_t words_max = 30;
  AXIOMETRY_TRY(std::string line, app::given_line("text", text));
  const std::size_t words = text::words(line).size();
  if (words <= words_max) return line;
  return fail(fmt::format("found {} words to search for, expected at most {}", words, words_max));
}

/// Small letters, as hashes are kept.
Result<std::string> sha256_of(const Request& request) {
  const std::string_view given = request.parameter("sha256").value_or("");
  const std::string hash = text::to_lower(given);
  if (hash.empty() || (hash.size() == 64 && hash.find_first_not_of("0123456789abcdef") == std::string::npos))
    return hash;
  return fail(fmt::format("found sha256={}, expected 64 hexadecimal digits", text::quoted(given)));
}

}  // namespace

Result<store::TestFilter> test_filter_of(const Request& request) {
  constexpr std::int64_t limit_max = 1000;
  store::TestFilter filter;
  const auto text = [&](std::string_view name) { return std::string(request.parameter(name).value_or("")); };
  AXIOMETRY_TRY(filter.text, searched_text(text("text")));
  AXIOMETRY_TRY(const DateRange dates, dates_of(request));
  filter.measured_from = dates.from;
  filter.measured_to = dates.to;
  filter.verdict = text("verdict");
  AXIOMETRY_TRY(filter.sha256, sha256_of(request));
  AXIOMETRY_TRY(filter.machine, id_parameter(request, "machine"));
  AXIOMETRY_TRY(filter.axis, id_parameter(request, "axis"));
  AXIOMETRY_TRY(filter.instrument, id_parameter(request, "instrument"));
  AXIOMETRY_TRY(filter.withdrawn, flag_of(request, "withdrawn", false));
  AXIOMETRY_TRY(filter.descending, flag_of(request, "descending", true));
  AXIOMETRY_TRY(const auto offset, whole_of(request, "offset", store::id_max));
  AXIOMETRY_TRY(const auto limit, whole_of(request, "limit", limit_max));
  filter.offset = offset.value_or(0);
  filter.limit = limit.value_or(filter.limit);
  const std::string order = text("order");
  if (order.empty()) return filter;
  const auto row = std::ranges::find(orders, order, &std::pair<std::string_view, Order>::first);
  if (row == orders.end())
    return fail(fmt::format("found the order {}, expected received, measured, title, machine, A, E, R or B",
                            text::quoted(order)));
  filter.order = row->second;
  return filter;
}

}  // namespace axiometry::server
