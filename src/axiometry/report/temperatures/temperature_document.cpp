// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/report/sections/sections.h"
#include "axiometry/report/temperatures/temperatures.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

using iso230_2::EnvironmentItem;
using iso230_2::EnvironmentStanding;

std::string shown_celsius(double x, int decimals, const Options& options) {
  return format_fixed(x, decimals, options.numbers);
}

Tone tone_of(EnvironmentStanding standing) {
  switch (standing) {
    case EnvironmentStanding::kept: return Tone::good;
    case EnvironmentStanding::exceeded: return Tone::bad;
    case EnvironmentStanding::known_in_part: return Tone::caution;
    case EnvironmentStanding::not_measured:
    case EnvironmentStanding::not_agreed: return Tone::quiet;
  }
  return Tone::normal;
}

Table gap_table(const std::vector<std::string>& gaps) {
  Table table;
  table.columns = {{plain("What is not known"), Align::start, true, true}};
  for (const std::string& gap : gaps) table.rows.push_back({{sentence(gap)}});
  return table;
}

}  // namespace

Table environment_table(const iso230_2::TestEnvironment& environment, const Options& options) {
  Table table;
  table.columns = {{plain("Quantity"), Align::start, true, true},
                   {plain("Measured")},
                   {plain("Agreed")},
                   {plain("Standing")},
                   {plain("Clause")}};
  for (const EnvironmentItem& item : environment.items) {
    const std::string agreed = agreed_text(item, options);
    table.rows.push_back({text_cell(item.title),
                          item.measured ? text_cell(measured_text(item, options)) : quiet_cell("not measured"),
                          agreed.empty() ? quiet_cell("–") : text_cell(agreed),
                          {plain(iso230_2::standing_text(item.standing)), tone_of(item.standing)},
                          text_cell(item.clause)});
  }
  const bool any_stated = std::ranges::any_of(environment.items, &EnvironmentItem::stated);
  const bool any_logged =
      std::ranges::any_of(environment.items, [](const EnvironmentItem& item) { return item.measured && !item.stated; });
  if (any_logged || !any_stated)
    table.notes.push_back(
        plain("Change per hour: the greatest within any hour; where less than an hour was recorded in one "
              "piece, the range of that piece divided by its length. Readings more than half an hour apart "
              "tell nothing of the time between them."));
  if (any_stated) table.notes.push_back(plain("(stated): on the word of who tested, by no log of temperatures."));
  return table;
}

Table sensor_table(const TemperatureLog& log, const Options& options) {
  Table table;
  table.columns = {{plain("Sensor"), Align::start, true, true},
                   {plain("Of")},
                   {plain("Readings"), Align::decimal},
                   {plain("Lowest, °C"), Align::decimal},
                   {plain("Highest, °C"), Align::decimal}};
  for (const TemperatureCourse& course : log.sensors) {
    const auto extremes = extremes_of(course);
    table.rows.push_back({verbatim_cell(course.location), text_cell(course.role),
                          text_cell(fmt::format("{}", course.celsius.size())),
                          text_cell(extremes ? shown_celsius(extremes->low, 2, options) : "–"),
                          text_cell(extremes ? shown_celsius(extremes->high, 2, options) : "–")});
  }
  return table;
}

std::string measured_text(const EnvironmentItem& item, const Options& options) {
  constexpr int usual = 2, fine = 4;
  constexpr double shown_by_usual = 0.01;
  const bool close = item.agreed && std::abs(*item.measured - *item.agreed) < shown_by_usual;
  const std::string text =
      fmt::format("{}\u00a0{}", shown_celsius(*item.measured, close ? fine : usual, options), item.unit);
  return item.stated ? fmt::format("{} (stated)", text) : text;
}

std::string agreed_text(const EnvironmentItem& item, const Options& options) {
  if (!item.agreed) return "";
  std::string value = format_exact(*item.agreed);
  std::ranges::replace(value, '.', options.numbers.decimal_mark);
  return fmt::format("at {} {} {}", item.lower_limit ? "least" : "most", value, item.unit);
}

Document compose(const TemperatureSubject& subject, const Options& options) {
  Document document;
  document.kind = "Temperatures about a test";
  document.title = "Temperatures before and during the test";
  document.edition = "ISO 230-2:2014, 4.1 and 7";
  document.running_head = translated(document.title, options);
  document.date = subject.began;
  const bool exceeded = subject.environment.exceeded(), open = subject.environment.open();
  const bool any_agreed = std::ranges::any_of(subject.environment.items,
                                              [](const EnvironmentItem& item) { return item.agreed.has_value(); });
  const std::string_view status = exceeded     ? "An agreed limit is exceeded"
                                  : open       ? "Not known whether every agreed limit was kept"
                                  : any_agreed ? "The agreed limits were kept"
                                               : "No limits were agreed";
  document.running_status = std::string(status);
  Notice notice{exceeded     ? Tone::bad
                : open       ? Tone::caution
                : any_agreed ? Tone::good
                             : Tone::normal,
                plain(status),
                {}};
  const std::vector<std::string> gaps = iso230_2::gaps_of(subject.environment, options.numbers);
  for (const std::string& gap : gaps) notice.lines.push_back(sentence(gap));
  document.status.push_back(std::move(notice));
  const auto as_said = [](const std::string& text) {
    return text.empty() ? quiet_cell("not stated") : verbatim_cell(text);
  };
  document.identity = {
      {plain("Test began"), as_said(subject.began)},
      {plain("Test ended"), as_said(subject.ended)},
      {plain("Log begins"), subject.log.begin ? text_cell(moment_text(*subject.log.begin)) : quiet_cell("not stated")}};
  document.sections.push_back(
      {"quantities", "What was measured and what was agreed", true, {environment_table(subject.environment, options)}});
  // Also for tables for spreadsheets, which have no notices.
  if (!gaps.empty()) document.sections.back().blocks.emplace_back(gap_table(gaps));
  document.sections.push_back({"course", "Course", true, {temperature_figure(subject, options)}});
  document.sections.push_back({"sensors", "Temperature sensors", false, {sensor_table(subject.log, options)}});
  Facts facts;
  facts.facts = {{plain("File"), verbatim_cell(subject.file)},
                 {plain("SHA-256"), verbatim_cell(subject.sha256)},
                 {plain("Program"), verbatim_cell(document.generator)}};
  Section provenance{"provenance", "Provenance", false, {std::move(facts)}};
  if (!subject.log.remarks.empty()) {
    Notice read{Tone::normal, plain("How the log was read"), {}};
    for (const std::string& remark : subject.log.remarks) read.lines.push_back(sentence(remark));
    provenance.blocks.emplace_back(std::move(read));
  }
  document.sections.push_back(std::move(provenance));
  return document;
}

}  // namespace axiometry::report
