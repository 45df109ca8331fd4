// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/drawing/picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/report/claim_text.h"
#include "axiometry/report/drawing/svg.h"
#include "axiometry/report/figures/conformity.h"
#include "axiometry/report/figures/contribution.h"
#include "axiometry/report/figures/distribution.h"
#include "axiometry/report/figures/drift_recording.h"
#include "axiometry/report/figures/figures.h"
#include "axiometry/report/figures/mean_deviations.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/symbols.h"
#include "axiometry/report/temperatures/temperatures.h"
#include "axiometry/report/translated.h"
#include "axiometry/standards/test_standard.h"

namespace axiometry::report {
namespace {

constexpr Colour black{0.1, 0.1, 0.1};
constexpr Colour grey{0.4, 0.4, 0.4};
constexpr Colour white{1.0, 1.0, 1.0};

std::string subject_line(const Metadata& metadata, const Options& options) {
  std::string line = translated(title_of(metadata.axis), options);
  for (const std::string& part : {metadata.machine.name, metadata.machine.serial_number}) {
    if (!part.empty()) line += " · " + part;
  }
  return line;
}

std::string status_line(const Subject& subject) {
  const iso230_2::Claims claims = iso230_2::claims_of(subject.test, subject.assessment);
  const std::string standing = standing_text(claims, subject.test.metadata.axis);
  std::vector<std::string> clauses;
  for (const iso230_2::Finding& finding : claim(claims, iso230_2::ClaimKind::tested).against) {
    const bool departs = finding.severity == iso230_2::Severity::departure;
    if (departs && std::ranges::find(clauses, finding.clause) == clauses.end()) clauses.push_back(finding.clause);
  }
  return clauses.empty() ? standing : fmt::format("{} (departs from {})", standing, fmt::join(clauses, ", "));
}

Text text(std::string_view line, Point at, double size, Colour colour, bool bold) {
  return {.runs = {{.text = plot::shortened(line, plot::plate_width - at.x, size), .bold = bold}},
          .at = at,
          .size = size,
          .colour = colour,
          .anchor = Anchor::start,
          .degrees = 0.0};
}

struct Heading {
  std::string title;
  std::string status;
  std::string date;
};

Figure heading(const Heading& lines) {
  constexpr double date_room = 90.0;
  constexpr double title_size = 11.0;
  Figure figure{.width = plot::plate_width, .height = 40.0, .title = {}, .description = {}, .operations = {}};
  figure.operations.push_back(text(plot::shortened(lines.title, plot::plate_width - date_room, title_size), {0.0, 10.0},
                                   title_size, black, true));
  figure.operations.push_back(text(lines.status, {0.0, 22.0}, 8.0, grey, false));
  Text date = text(plot::shortened(lines.date, date_room, 8.0), {0.0, 10.0}, 8.0, grey, false);
  date.at.x = plot::plate_width;
  date.anchor = Anchor::end;
  if (!date.runs.front().text.empty()) figure.operations.push_back(date);
  return figure;
}

Figure on_paper(std::vector<Figure> parts, const Heading& lines) {
  parts.insert(parts.begin(), heading(lines));
  Figure page = stacked(parts);
  const Path paper{.points = {{0, 0}, {page.width, 0}, {page.width, page.height}, {0, page.height}},
                   .closed = true,
                   .stroke = {.colour = white, .width = 0.0, .dashes = {}},
                   .fill = white};
  page.operations.insert(page.operations.begin(), paper);
  return page;
}

}  // namespace

Figure picture(const Subject& subject, const Options& options) {
  std::vector<Figure> parts = figures(subject, options);
  if (auto temperatures = surroundings_figure(subject, options)) parts.push_back(*std::move(temperatures));
  if (auto conformity = conformity_figure(subject, options)) parts.push_back(*std::move(conformity));
  if (auto distributions = distribution_figure(subject, options)) parts.push_back(*std::move(distributions));
  if (auto composed = mean_annex_a_figure(subject, options)) parts.push_back(*std::move(composed));
  if (auto means = mean_deviation_figure(subject, options)) parts.push_back(*std::move(means));
  if (auto drawn = mean_interval_figure(subject, options)) parts.push_back(*std::move(drawn));
  if (auto contributions = contribution_figure(subject, options)) parts.push_back(*std::move(contributions));
  if (auto recording = drift_recording_figure(subject, options)) parts.push_back(*std::move(recording));
  for (Figure& part : parts) part = with_words_translated(std::move(part), options);
  return on_paper(std::move(parts), {subject_line(subject.test.metadata, options),
                                     translated(status_line(subject), options), subject.test.metadata.conditions.date});
}

Figure picture(const Document& document) {
  std::vector<Figure> parts;
  for (const Section& section : document.sections)
    for (const Block& block : section.blocks)
      if (const auto* figure = std::get_if<Figure>(&block)) parts.push_back(*figure);
  return on_paper(std::move(parts),
                  {document.title, fmt::format("{} · {}", document.kind, document.edition), document.date});
}

}  // namespace axiometry::report
