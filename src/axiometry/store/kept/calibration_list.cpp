// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/kept/calibration_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include "axiometry/base/text/text.h"
#include "axiometry/store/kept/assets.h"
#include "axiometry/store/kept/folded_text.h"
#include "axiometry/store/kept/test_records.h"

namespace axiometry::store {
namespace {

using CalibrationOrder = CalibrationFilter::Order;
using Versions = std::vector<Versioned<CalibrationRecord>>;

/// Conditions on the latest version, v; the texts of the filter must outlive the parameters.
struct Asked {
  std::string where;
  std::vector<Parameter> parameters;

  void add(std::string_view condition, Parameter parameter) {
    parameters.push_back(parameter);
    where += fmt::format("{} {} ${}", where.empty() ? "WHERE" : " AND", condition, parameters.size());
  }
};

Asked asked(const CalibrationFilter& filter, const std::string& end_of_day) {
  Asked question;
  if (!filter.kind.empty()) question.add("v.kind =", filter.kind);
  if (filter.machine) question.add("v.machine =", *filter.machine);
  if (filter.instrument) question.add("v.instrument =", *filter.instrument);
  if (!filter.measured_from.empty()) question.add("v.measured_on >=", filter.measured_from);
  if (!end_of_day.empty()) question.add("v.measured_on <=", end_of_day);
  if (!filter.withdrawn) question.add("v.withdrawn =", std::int64_t{0});
  return question;
}

std::string_view column_of(CalibrationOrder order) {
  switch (order) {
    case CalibrationOrder::received: break;
    case CalibrationOrder::measured: return "v.measured_on";
    case CalibrationOrder::title: return "v.title";
  }
  return "v.id";
}

bool has_words(const CalibrationRecord& calibration, const std::string& machine, std::span<const std::string> words) {
  constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
  std::string text = fmt::format("{} {} {}", calibration.title, calibration.notes, machine);
  for (const KeptFile& file : calibration.files) text += " " + file.name;
  text = folded(text, all);
  return std::ranges::all_of(words, [&](const std::string& word) { return text.contains(word); });
}

void sort_by_title(Versions& found, bool descending) {
  std::ranges::stable_sort(found, [&](const auto& a, const auto& b) {
    const std::string left = folded(a.value.title), right = folded(b.value.title);
    return descending ? right < left : left < right;
  });
}

Result<std::map<Id, std::string>> machine_names(Connection& connection) {
  AXIOMETRY_TRY(auto machines, all_assets<MachineRecord>(connection));
  std::map<Id, std::string> names;
  for (auto& machine : machines) names.emplace(machine.id, std::move(machine.value.name));
  return names;
}

Result<std::map<Id, std::string>> receipts(Connection& connection) {
  AXIOMETRY_TRY(const Rows rows, connection.query("SELECT id, at FROM calibration_version WHERE version = 1"));
  std::map<Id, std::string> times;
  for (const Row& row : rows) times.emplace(row.integer(0), row.text(1));
  return times;
}

}  // namespace

Result<CalibrationPage> find_calibrations(Connection& connection, const CalibrationFilter& filter) {
  const std::string after_all = "\xF4\x8F\xBF\xBF";  // a day includes its hours, and no date has a letter behind it
  const std::string end_of_day = filter.measured_to.empty() ? "" : filter.measured_to + after_all;
  const Asked question = asked(filter, end_of_day);
  const std::string_view direction = filter.descending ? "DESC" : "ASC";
  AXIOMETRY_TRY(Versions found,
                latest_assets<CalibrationRecord>(connection,
                                                 fmt::format("{} ORDER BY {} {}, v.id {}", question.where,
                                                             column_of(filter.order), direction, direction),
                                                 question.parameters));
  AXIOMETRY_TRY(const auto machines, machine_names(connection));
  const auto machine_of = [&](const CalibrationRecord& c) {
    const auto machine = c.machine ? machines.find(*c.machine) : machines.end();
    return machine == machines.end() ? std::string() : machine->second;
  };
  std::vector<std::string> words;
  const std::string text = folded(filter.text);
  for (const std::string_view word : text::words(text)) words.emplace_back(word);
  std::erase_if(found, [&](const auto& c) { return !has_words(c.value, machine_of(c.value), words); });
  if (filter.order == CalibrationOrder::title) sort_by_title(found, filter.descending);
  AXIOMETRY_TRY(const auto received, receipts(connection));
  CalibrationPage page{.rows = {}, .total = static_cast<std::int64_t>(found.size())};
  const std::int64_t first = std::clamp<std::int64_t>(filter.offset, 0, page.total);
  const std::int64_t count = std::clamp<std::int64_t>(filter.limit, 0, largest_page);
  for (std::int64_t k = first; k < std::min(page.total, first + count); ++k) {
    auto& calibration = found[static_cast<std::size_t>(k)];
    std::string machine = machine_of(calibration.value);
    const auto at = received.find(calibration.id);
    page.rows.push_back({std::move(calibration), at == received.end() ? "" : at->second, std::move(machine)});
  }
  return page;
}

}  // namespace axiometry::store
