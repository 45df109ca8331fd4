// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "axiometry/base/text/text.h"
#include "axiometry/store/kept/assets.h"
#include "axiometry/store/kept/folded_text.h"
#include "axiometry/store/kept/same_bytes.h"
#include "axiometry/store/kept/test_list.h"

// How a page of a list is found in a few milliseconds among 100 000 tests, whatever is asked for: what fits a filter is
// either little, then it is taken from an index (or from one pass over the searched words) and sorted, or much, then
// an index in the wanted order is walked until the page is full, which is soon. What is between is as slow as the
// geometric mean of both. Databases guess which it is, by statistics that may be missing; here it is counted, which
// the page's total needs anyhow.
namespace axiometry::store {
namespace {

using Order = TestFilter::Order;

constexpr std::size_t few = 2000;  // matches that are sorted at once

/// Conditions and their parameters, as they are put together.
class Conditions {
 public:
  /// `$` in the condition is the parameter.
  void add(std::string_view condition, Parameter parameter) {
    parameters.push_back(parameter);
    std::string numbered;
    for (const char c : condition) numbered += c == '$' ? fmt::format("${}", parameters.size()) : std::string(1, c);
    add(numbered);
  }
  void add(std::string_view condition) { where += fmt::format("{} {}", where.empty() ? "WHERE" : " AND", condition); }

  std::string where;
  std::vector<Parameter> parameters;
};

struct Search {
  const TestFilter& filter;
  std::vector<std::string> words;  // folded; all must be found

  explicit Search(const TestFilter& asked) : filter(asked) {
    const std::string text = folded(asked.text);
    for (const std::string_view word : text::words(text)) words.emplace_back(word);
  }

  /// What is asked of test_list itself, beside words and instrument.
  bool of_list() const {
    return filter.machine || filter.axis || !filter.measured_from.empty() || !filter.measured_to.empty() ||
           !filter.verdict.empty() || !filter.sha256.empty();
  }
};

/// What stands in front of columns whose indexes shall not be used: nothing where they may be.
struct Marks {
  std::string_view withdrawn;  ///< what is not withdrawn is nearly everything
  std::string_view measured;
  std::string_view others;
};

/// Conditions on columns of test_list, which is called l.
void add_list_conditions(Conditions& conditions, const TestFilter& filter, const Marks& marks) {
  const auto column = [&](std::string_view name, std::string_view rest) {
    return fmt::format("{}l.{} {}", name == "measured_on" ? marks.measured : marks.others, name, rest);
  };
  if (!filter.withdrawn) conditions.add(fmt::format("{}l.withdrawn = 0", marks.withdrawn));
  if (filter.machine) conditions.add(column("machine", "= $"), *filter.machine);
  if (filter.axis) conditions.add(column("axis", "= $"), *filter.axis);
  if (!filter.measured_from.empty()) conditions.add(column("measured_on", ">= $"), filter.measured_from);
  // A day includes its hours: "2026-11-22T09:30" is on "2026-11-22". No date has a letter behind U+10FFFF.
  static const std::string after_all = "\xF4\x8F\xBF\xBF";
  if (!filter.measured_to.empty())
    conditions.add(column("measured_on", "<= $ || '" + after_all + "'"), filter.measured_to);
  if (!filter.verdict.empty()) conditions.add(column("verdict", "= $"), filter.verdict);
  if (!filter.sha256.empty()) conditions.add(column("content", "= $"), filter.sha256);
}

/// `words` is where they stand: a column, or a look at the row of the same test.
void add_words(Conditions& conditions, const Search& search, std::string_view words) {
  for (const std::string& word : search.words)
    conditions.add(fmt::format("instr({}, $) > 0", words), std::string_view(word));
}

constexpr std::string_view words_of_test = "(SELECT s.words FROM test_search s WHERE s.test = l.test)";

void add_instrument(Conditions& conditions, const TestFilter& filter) {
  conditions.add(fmt::format("EXISTS (SELECT 1 FROM list_instrument i WHERE i.instrument = ${}{} AND i.test = l.test)",
                             "", filter.withdrawn ? "" : " AND i.withdrawn = 0"),
                 *filter.instrument);
}

/// Tables and conditions of a search.
struct Query {
  std::string from;
  Conditions conditions;
};

/// Read by the narrowest table that can tell.
Query query_of_few(const Search& search, std::string_view unindexed) {
  const TestFilter& filter = search.filter;
  Query query;
  if (search.of_list()) {
    query.from = "test_list l";
    add_list_conditions(query.conditions, filter, {.withdrawn = unindexed, .measured = "", .others = ""});
  } else if (!search.words.empty()) {
    query.from = "test_search l";
    if (!filter.withdrawn) query.conditions.add("l.withdrawn = 0");
    add_words(query.conditions, search, "l.words");
  } else {
    query.from = "list_instrument l";
    if (!filter.withdrawn) query.conditions.add("l.withdrawn = 0");
    query.conditions.add("l.instrument = $", *filter.instrument);
    return query;
  }
  if (search.of_list()) add_words(query.conditions, search, words_of_test);
  if (filter.instrument) add_instrument(query.conditions, filter);
  return query;
}

/// Walks along the order: each test is looked at until there are enough.
Query query_of_many(const Search& search, std::string_view unindexed) {
  Query query;
  query.from = "test_list l";
  // By arrival the index of what is not withdrawn is in the right order itself, and by date that of the dates.
  const Order order = search.filter.order;
  add_list_conditions(query.conditions, search.filter,
                      {.withdrawn = order == Order::received ? "" : unindexed,
                       .measured = order == Order::measured ? "" : unindexed,
                       .others = unindexed});
  if (search.filter.instrument) add_instrument(query.conditions, search.filter);
  add_words(query.conditions, search, words_of_test);
  return query;
}

struct Matches {
  std::int64_t total = 0;
  std::vector<Id> ids;  // of all when they are few, else none
};

std::vector<Id> ids_of(const Rows& rows) {
  std::vector<Id> ids;
  for (const Row& row : rows) ids.push_back(row.integer(0));
  return ids;
}

/// Of all tests: as ids have no gaps, the last one says how many there are; few are withdrawn.
Result<Matches> all_matches(Connection& connection, bool withdrawn) {
  AXIOMETRY_TRY(
      const Rows rows,
      connection.query("SELECT (SELECT coalesce(max(test), 0) FROM test_list), (SELECT count(*) FROM test_list "
                       "WHERE withdrawn = 1)"));
  return Matches{rows[0].integer(0) - (withdrawn ? 0 : rows[0].integer(1)), {}};
}

Result<Matches> matches(Connection& connection, const Search& search) {
  if (!search.of_list() && search.words.empty() && !search.filter.instrument)
    return all_matches(connection, search.filter.withdrawn);
  const Query query = query_of_few(search, connection.unindexed());
  const std::string matching = fmt::format("FROM {} {}", query.from, query.conditions.where);
  const auto& parameters = query.conditions.parameters;
  AXIOMETRY_TRY(const Rows rows,
                connection.query(fmt::format("SELECT l.test {} LIMIT {}", matching, few + 1), parameters));
  if (rows.size() <= few) return Matches{static_cast<std::int64_t>(rows.size()), ids_of(rows)};
  AXIOMETRY_TRY(const Rows count, connection.query(fmt::format("SELECT count(*) {}", matching), parameters));
  return Matches{count[0].integer(0), {}};
}

/// Ties are broken by arrival, so that no test is on two pages.
std::string order_of(const TestFilter& filter) {
  const std::string_view direction = filter.descending ? "DESC" : "ASC";
  const auto by = [&](std::string_view rest) { return fmt::format("{}, l.test {}", rest, direction); };
  const auto value = [&](std::string_view column) { return by(fmt::format("l.{} {} NULLS LAST", column, direction)); };
  switch (filter.order) {
    case Order::received: break;
    case Order::measured: return by(fmt::format("l.measured_on {}", direction));
    case Order::title: return by(fmt::format("l.title_key {}", direction));
    case Order::machine: return by(fmt::format("l.machine_key {0}, l.axis_key {0}", direction));
    case Order::A: return value("value_a");
    case Order::E: return value("value_e");
    case Order::R: return value("value_r");
    case Order::B: return value("value_b");
  }
  return fmt::format("l.test {}", direction);
}

/// A condition that `column` is one of some ids, which are the parameter `place`: both databases have a way to pass
/// a list as one text, so that the statement stays the same.
std::string among(const Connection& connection, std::string_view column, std::size_t place) {
  return connection.is_sqlite() ? fmt::format("{} IN (SELECT value FROM json_each(${}))", column, place)
                                : fmt::format("{} = ANY (CAST(${} AS integer[]))", column, place);
}

std::string list_text(const Connection& connection, std::span<const Id> ids) {
  return fmt::format("{}{}{}", connection.is_sqlite() ? '[' : '{', fmt::join(ids, ","),
                     connection.is_sqlite() ? ']' : '}');
}

Result<std::vector<Id>> page_of(Connection& connection, const Search& search, const Matches& found) {
  const TestFilter& filter = search.filter;
  const std::int64_t offset = std::max<std::int64_t>(filter.offset, 0);
  const std::int64_t limit = std::clamp<std::int64_t>(filter.limit, 0, largest_page);
  if (offset >= found.total || limit == 0) return std::vector<Id>();
  Query query;
  const std::string ids = list_text(connection, found.ids);
  if (found.ids.empty()) {
    query = query_of_many(search, connection.unindexed());
  } else {
    query.from = "test_list l";
    query.conditions.add(among(connection, "l.test", 1));
    query.conditions.parameters.emplace_back(ids);
  }
  AXIOMETRY_TRY(const Rows rows,
                connection.query(fmt::format("SELECT l.test FROM {} {} ORDER BY {} LIMIT {} OFFSET {}", query.from,
                                             query.conditions.where, order_of(filter), limit, offset),
                                 query.conditions.parameters));
  return ids_of(rows);
}

/// Figures of the latest versions, by test.
Result<std::map<Id, std::vector<FigureRecord>>> figures_of(Connection& connection, std::span<const Id> tests,
                                                           std::span<const std::string> parameters) {
  const std::string ids = list_text(connection, tests);
  std::vector<Parameter> values = {ids};
  for (const std::string& parameter : parameters) values.emplace_back(parameter);
  std::map<Id, std::vector<FigureRecord>> figures;
  if (parameters.empty()) return figures;
  AXIOMETRY_TRY(
      const Rows rows,
      connection.query(
          fmt::format("SELECT f.test, f.parameter, f.value, f.expanded_uncertainty, f.tolerance, "
                      "f.verdict, f.low, f.high, f.method FROM test_list l JOIN figure f ON f.test = l.test AND "
                      "f.version = l.version WHERE {} AND f.parameter IN ({}) ORDER BY f.test, "
                      "f.place",
                      among(connection, "l.test", 1), places(2, parameters.size())),
          values));
  for (const Row& row : rows) figures[row.integer(0)].push_back(figure_of(row, 1));
  return figures;
}

/// Of a test of both directions without those of one; of a test of one direction what it has in their place.
std::vector<FigureRecord> of_a_list(std::vector<FigureRecord> figures) {
  const auto has = [&](std::string_view parameter) {
    return std::ranges::find(figures, parameter, &FigureRecord::parameter) != figures.end();
  };
  std::vector<FigureRecord> kept;
  for (const FigureRecord& figure : figures)
    if (const std::size_t sense = figure.parameter.find('_');
        sense == std::string::npos || !has(std::string_view(figure.parameter).substr(0, sense)))
      kept.push_back(figure);
  return kept;
}

TestRow row_of(const Row& row) {
  TestRow listed;
  listed.id = row.integer(0);
  listed.version = row.number(1);
  listed.withdrawn = row.flag(2);
  listed.conforming = row.flag(3);
  listed.machine = row.optional_integer(4);
  listed.axis = row.optional_integer(5);
  listed.unit = row.text(6);
  listed.verdict = row.text(7);
  listed.measured_on = row.text(8);
  listed.received_at = row.text(9);
  listed.title = row.text(10);
  listed.file_name = row.text(11);
  listed.machine_name = row.text(12);
  listed.axis_name = row.text(13);
  listed.axis_kind = row.text(14);
  listed.label = row.text(15);
  return listed;
}

Result<Rows> list_rows(Connection& connection, std::span<const Id> ids) {
  return connection.query(
      fmt::format("SELECT test, version, withdrawn, conforming, machine, axis, unit, verdict, measured_on, received_at,"
                  " title, file_name, machine_name, axis_name, axis_kind, label FROM test_list l WHERE {}",
                  among(connection, "l.test", 1)),
      {list_text(connection, ids)});
}

}  // namespace

Result<TestPage> find_tests(Connection& connection, const TestFilter& filter) {
  static const std::vector<std::string> shown = {"A",      "A_up", "A_down", "E",      "E_up",
                                                 "E_down", "R",    "R_up",   "R_down", "B"};
  const Search search(filter);
  AXIOMETRY_TRY(const Matches found, matches(connection, search));
  AXIOMETRY_TRY(const std::vector<Id> ids, page_of(connection, search, found));
  AXIOMETRY_TRY(const Rows rows, list_rows(connection, ids));
  AXIOMETRY_TRY(auto figures, figures_of(connection, ids, shown));
  std::map<Id, TestRow> by_id;
  for (const Row& row : rows) by_id.emplace(row.integer(0), row_of(row));
  TestPage page{.rows = {}, .total = found.total};
  for (const Id id : ids) {
    TestRow& row = page.rows.emplace_back(std::move(by_id.at(id)));
    row.figures = of_a_list(std::move(figures[id]));
  }
  return page;
}

Result<std::vector<TrendPoint>> find_trend(Connection& connection, Id axis, std::span<const std::string> parameters,
                                           std::int64_t limit) {
  AXIOMETRY_TRY(const auto known, get_asset<AxisRecord>(connection, axis));
  AXIOMETRY_TRY(auto repeated, repeated_tests(connection, axis));
  std::set<Id> once_more;
  for (const auto& [counted, others] : repeated) once_more.insert(others.begin(), others.end());
  AXIOMETRY_TRY(const Rows newest,
                connection.query("SELECT test FROM test_list WHERE axis = $1 AND withdrawn = 0 ORDER BY CASE WHEN "
                                 "measured_on = '' THEN substr(received_at, 1, 10) ELSE measured_on END DESC, test "
                                 "DESC LIMIT $2",
                                 {known.id, std::max<std::int64_t>(limit, 0) + std::ssize(once_more)}));
  std::vector<Id> ids = ids_of(newest);
  std::erase_if(ids, [&](Id test) { return once_more.contains(test); });
  ids.resize(std::min(ids.size(), static_cast<std::size_t>(std::max<std::int64_t>(limit, 0))));
  AXIOMETRY_TRY(const Rows rows, list_rows(connection, ids));
  AXIOMETRY_TRY(auto figures, figures_of(connection, ids, parameters));
  std::vector<TrendPoint> points;
  for (const Row& row : rows) {
    TestRow test = row_of(row);
    points.push_back({.test = test.id,
                      .version = test.version,
                      .title = std::move(test.title),
                      .measured_on = std::move(test.measured_on),
                      .received_at = std::move(test.received_at),
                      .unit = std::move(test.unit),
                      .conforming = test.conforming,
                      .label = std::move(test.label),
                      .verdict = std::move(test.verdict),
                      .figures = std::move(figures[test.id]),
                      .same_bytes = std::move(repeated[test.id])});
  }
  const auto day = [](const TrendPoint& p) {  // one that states none stands on the day it came
    return p.measured_on.empty() ? p.received_at.substr(0, 10) : p.measured_on;
  };
  std::ranges::sort(points, {}, [&](const TrendPoint& p) { return std::pair(day(p), p.test); });
  return points;
}

}  // namespace axiometry::store
