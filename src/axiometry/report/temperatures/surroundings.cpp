// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "axiometry/report/sections/sections.h"
#include "axiometry/report/temperatures/temperatures.h"

namespace axiometry::report {
namespace {

/// Of whose word all this is.
Facts facts_of_log(const iso230_2::LoggedEnvironment& logged) {
  const auto as_said = [](const std::string& text) {
    return text.empty() ? quiet_cell("not stated") : verbatim_cell(text);
  };
  const std::string& by_readings = logged.ended_by_readings;
  Facts facts;
  facts.facts = {{plain("Test began"), as_said(logged.began)},
                 {plain("Test ended"), by_readings.empty()
                                           ? as_said(logged.ended)
                                           : text_cell(fmt::format("{} (by the times of the readings)", by_readings))},
                 {plain("File"), verbatim_cell(subject_of(logged).file)},
                 {plain("SHA-256"), verbatim_cell(logged.sha256)}};
  return facts;
}

/// Of a test without a log; nothing where it states no figure and no limit.
std::optional<Section> stated_section(const Subject& subject, const Options& options) {
  const iso230_2::TestEnvironment* stated = subject.environment;
  if (stated == nullptr) return std::nullopt;
  const auto known = [](const iso230_2::EnvironmentItem& item) { return item.measured || item.agreed; };
  if (std::ranges::none_of(stated->items, known)) return std::nullopt;
  return Section{
      "surroundings", "Temperatures before and during the test", true, {environment_table(*stated, options)}};
}

}  // namespace

TemperatureSubject subject_of(const iso230_2::LoggedEnvironment& logged) {
  const std::string name = logged.file.substr(logged.file.find_last_of('/') + 1);
  return {name == "-" ? "(standard input)" : name,
          logged.sha256,
          logged.began,
          logged.ended,
          logged.log,
          logged.test,
          logged.environment};
}

std::optional<Figure> surroundings_figure(const Subject& subject, const Options& options) {
  if (subject.temperatures == nullptr) return std::nullopt;
  return temperature_figure(subject_of(*subject.temperatures), options);
}

std::optional<Section> surroundings_section(const Subject& subject, const Options& options) {
  if (subject.temperatures == nullptr) return stated_section(subject, options);
  const iso230_2::LoggedEnvironment& logged = *subject.temperatures;
  Section section{"surroundings", "Temperatures before and during the test", true, {}};
  section.blocks.emplace_back(temperature_figure(subject_of(logged), options));
  section.blocks.emplace_back(environment_table(logged.environment, options));
  const auto gaps = iso230_2::gaps_of(logged.environment, options.numbers);
  if (!gaps.empty()) {
    Notice notice{Tone::caution, plain("What is not known"), {}};
    for (const std::string& gap : gaps) notice.lines.push_back(sentence(gap));
    section.blocks.emplace_back(std::move(notice));
  }
  section.blocks.emplace_back(sensor_table(logged.log, options));
  section.blocks.emplace_back(facts_of_log(logged));
  return section;
}

}  // namespace axiometry::report
