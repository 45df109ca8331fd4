// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/standards/test_standard.h"

namespace axiometry::report {

namespace {

/// Fields are grouped by the first part of their key; a group not named here stands under its own name.
struct Group {
  std::string_view prefix;
  std::string_view title;
  std::string_view title_when_resumed{};  ///< of fields that stand apart from the first ones
};
constexpr std::string_view conditions_title = "Test conditions";
constexpr std::string_view axis_title = "Axis under test";
constexpr Group groups[] = {
    {"test", "Test", conditions_title},
    {"machine", "Machine"},
    {"axis", axis_title},
    {"equipment", "Test equipment"},
    {"nde", "Correction for nominal differential expansion (NDE)"},
    {"sensors", "Temperature sensors"},
    {"environment", "Air near the measurement line"},
    {"instrument", "Settings of the instrument"},
    {"artefact", "Calibrated artefact"},
};
/// Groups that have sections of their own.
constexpr std::string_view shown_elsewhere[] = {"uncertainty", "tolerance"};

/// Two fields that are one fact: "Air temperature at the start" and "… at the end".
struct Pair {
  std::string_view first;
  std::string_view second;
  bool before_the_value = false;  ///< "from 0 mm to 500 mm", but "20 °C at the start, 21 °C at the end"
};
constexpr Pair pairs[] = {{" at the start", " at the end"}, {", from", ", to", true}};

/// Without breaks within, so that a line ends after a value with its words.
RichText unbroken(std::string_view text) {
  std::string all;
  for (char c : text) all += c == ' ' ? std::string("\u00a0") : std::string(1, c);
  return plain(all);
}

/// Longer texts get the whole width, below the columns of facts.
constexpr std::size_t longest_in_a_column = 240;  // bytes

std::string_view prefix(const Field& field) { return field.key.substr(0, field.key.find('.')); }

const Pair* pair_of(const Field& first, const Field& second) {
  for (const Pair& pair : pairs)
    if (first.title.ends_with(pair.first) && second.title.ends_with(pair.second) &&
        first.title.substr(0, first.title.size() - pair.first.size()) ==
            second.title.substr(0, second.title.size() - pair.second.size()))
      return &pair;
  return nullptr;
}

/// "20.6 °C at the start, 20.9 °C at the end", in the words of the titles.
TableCell paired_cell(const Field& first, const Field& second, const Pair& pair, const Metadata& metadata,
                      const Options& options) {
  const TableCell a = stated(first, metadata, options);
  const TableCell b = stated(second, metadata, options);
  if (a.tone == Tone::quiet && b.tone == Tone::quiet) return a;
  if (!pair.before_the_value)
    return {joined({a.text, unbroken(pair.first), plain(", "), b.text, unbroken(pair.second)})};
  return {joined({plain(fmt::format("{} ", pair.first.substr(2))), a.text,
                  plain(fmt::format("{} ", pair.second.substr(1))), b.text})};
}

/// Words that the program knows, and puts into the reader's language; every other role is the user's own.
bool is_known_sensor_role(const Field& field, const RecordColumn& column, const Cell& cell) {
  const auto* role = std::get_if<std::string>(&cell);
  return role && column.key == "role" && prefix(field) == "sensors" &&
         (*role == "machine" || *role == "equipment" || *role == "air");
}

TableCell record_cell(const Cell& cell, std::size_t decimals, const Options& options) {
  if (const auto* text = std::get_if<std::string>(&cell)) return text->empty() ? quiet_cell("–") : verbatim_cell(*text);
  const auto* x = std::get_if<double>(&cell);
  return x ? text_cell(format_fixed(*x, static_cast<int>(decimals), options.numbers)) : quiet_cell("–");
}

/// Decimals that show every number of a column fully, so that 21 stands as 21.0 below 20.4.
std::size_t decimals_of(const Records& records, std::size_t column, const Options& options) {
  std::size_t decimals = 0;
  for (const auto& record : records)
    if (const auto* x = std::get_if<double>(&record[column]))
      decimals = std::max(decimals, fraction_length(shown_exact(*x, options)));
  return decimals > 0 ? decimals - 1 : 0;  // decimals without the mark
}

Table record_table(const Field& field, const Records& records, const Options& options) {
  Table table;
  std::vector<std::size_t> shown;
  for (std::size_t c = 0; c < field.columns.size(); ++c) {
    const RecordColumn& column = field.columns[c];
    const auto states = [c](const auto& record) { return !std::holds_alternative<std::monostate>(record[c]); };
    if (!column.shown_empty && std::ranges::none_of(records, states)) continue;
    shown.push_back(c);
    std::string head(column.title);
    if (!column.unit.empty()) head += fmt::format(", {}", column.unit);
    table.columns.push_back({plain(head), column.type == FieldType::number ? Align::decimal : Align::start,
                             table.columns.empty(), column.type != FieldType::number});
  }
  for (const auto& record : records) {
    std::vector<TableCell> row;
    for (const std::size_t c : shown)
      row.push_back(is_known_sensor_role(field, field.columns[c], record[c])
                        ? text_cell(std::get<std::string>(record[c]))
                        : record_cell(record[c], decimals_of(records, c, options), options));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// What the readings themselves tell of the test (8.1: approaches, target positions).
std::vector<Fact> facts_of_readings(const Subject& subject, bool lists_targets, const Options& options) {
  const Series& series = subject.test.series;
  const AxisKind kind = subject.test.metadata.axis.kind;
  const int decimals = position_decimals(series.targets());
  const auto place = [&](Position p) {
    return format_fixed(p.in_native(), decimals, options.numbers) + (kind == AxisKind::linear ? "\u00a0mm" : "°");
  };
  std::size_t fewest = series.run_count(), most = 0;
  for (Direction direction : {Direction::up, Direction::down}) {
    if (!series.has(direction)) continue;
    for (std::size_t target = 0; target < series.target_count(); ++target) {
      fewest = std::min(fewest, series.count(target, direction));
      most = std::max(most, series.count(target, direction));
    }
  }
  const bool both = series.has_both_directions();
  const std::string runs = fewest == most ? fmt::format("{}", fewest) : fmt::format("{} to {}", fewest, most);
  const std::string_view directions = both                        ? " from each direction"
                                      : series.has(Direction::up) ? " from below (↑) only"
                                                                  : " from above (↓) only";
  return {{joined({plain("Number of approaches "), italic("n")}), text_cell(fmt::format("{}{}", runs, directions))},
          {plain("Target positions"),
           text_cell(fmt::format("{} from {} to {}{}", series.target_count(), place(series.targets().front()),
                                 place(series.targets().back()), lists_targets ? ", listed in Table 2" : ""))}};
}

constexpr std::string_view cycle_key = "test.cycle";

/// Readings of one direction are no standard test cycle, stated or not.
TableCell stated_cycle(const Field& field, const Subject& subject, const Options& options) {
  const Metadata& metadata = subject.test.metadata;
  const std::string_view label = subject.assessment.label;
  if (!metadata.conditions.cycle)
    return text_cell(label.empty() ? "not stated, taken to be the standard one" : fmt::format("not stated; {}", label));
  if (*metadata.conditions.cycle == TestCycle::standard && !label.empty())
    return text_cell(fmt::format("none but the standard one is given; {}", label));
  return stated(field, metadata, options);
}

/// What the section shows: groups of facts that stand in columns, and what needs the whole width below.
struct Identification {
  std::vector<Block> facts;
  std::vector<Block> tables;
  Facts long_facts{"Further particulars", {}};
};

void append_group(Identification& all, std::string_view title, std::span<const Field> fields, const Subject& subject,
                  bool lists_targets, const Options& options) {
  const Metadata& metadata = subject.test.metadata;
  Facts facts{std::string(title), {}};
  const auto add = [&](std::string_view name, TableCell value) {
    const bool is_long = plain_text(value.text).size() > longest_in_a_column;
    (is_long ? all.long_facts : facts).facts.push_back({plain(name), std::move(value)});
  };
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const Field& field = fields[k];
    const bool last = k + 1 == fields.size();
    if (const Pair* pair = last ? nullptr : pair_of(field, fields[k + 1])) {
      const Field& other = fields[++k];
      if (!is_given(field, metadata) && !is_given(other, metadata) && !is_wanted(field, metadata)) continue;
      add(field.title.substr(0, field.title.size() - pair->first.size()),
          paired_cell(field, other, *pair, metadata, options));
    } else if (field.type == FieldType::records && is_given(field, metadata)) {
      Table table = record_table(field, std::get<Records>(field.get(metadata)), options);
      table.caption = plain(field.title);
      all.tables.emplace_back(std::move(table));
    } else if (field.key == cycle_key) {
      add(field.title, stated_cycle(field, subject, options));
    } else if (is_given(field, metadata) || is_wanted(field, metadata)) {
      add(field.title, stated(field, metadata, options));
    }
  }
  if (title == axis_title && !octant_of(metadata.axis).empty())
    facts.facts.push_back({plain("Moves with growing position"), text_cell(octant_of(metadata.axis))});
  if (title == conditions_title)
    for (Fact& fact : facts_of_readings(subject, lists_targets, options)) facts.facts.push_back(std::move(fact));
  if (!facts.facts.empty()) all.facts.emplace_back(std::move(facts));
}

}  // namespace

Section identification_section(const Subject& subject, bool lists_targets, const Options& options) {
  Section section{"identification", "Identification of the test (Table 3)", false, {}};
  Identification all;
  const auto fields = metadata_fields();
  for (auto first = fields.begin(); first != fields.end();) {
    const auto end =
        std::find_if(first, fields.end(), [&](const Field& field) { return prefix(field) != prefix(*first); });
    const auto* known = std::ranges::find(groups, prefix(*first), &Group::prefix);
    const bool resumed =
        std::any_of(fields.begin(), first, [&](const Field& field) { return prefix(field) == prefix(*first); });
    const std::string_view title = known == std::end(groups) ? prefix(*first)
                                   : resumed                 ? known->title_when_resumed
                                                             : known->title;
    if (std::ranges::find(shown_elsewhere, prefix(*first)) == std::end(shown_elsewhere))
      append_group(all, title, {first, end}, subject, lists_targets, options);
    first = end;
  }
  section.blocks = std::move(all.facts);
  std::ranges::move(all.tables, std::back_inserter(section.blocks));
  if (!all.long_facts.facts.empty()) section.blocks.emplace_back(std::move(all.long_facts));
  return section;
}

}  // namespace axiometry::report
