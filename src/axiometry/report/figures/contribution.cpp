// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/contribution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/label.h"
#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/symbols.h"
#include "axiometry/report/method_values.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

using iso230_2::Contribution;
using plot::label;
using plot::Operations;
namespace ink = plot::ink;

constexpr std::size_t most_rows = 10;
constexpr double title_width = 152.0;
constexpr double title_gap = 8.0;
constexpr double column_gap = 9.0;
constexpr double head_height = 15.0;
constexpr double input_pitch = 21.0;
constexpr double share_bar_height = 5.0;
constexpr double right_edge = plot::plate_width - 2.0;

/// Inputs beyond the most that are shown, as one: the root of the sum of their squares.
std::vector<Contribution> shown_contributions(const iso230_2::Assessment& assessment) {
  std::vector<Contribution> all = contributions(assessment);
  if (all.size() <= most_rows) return all;
  Contribution others{"", fmt::format("{} others together", all.size() - most_rows + 1), {}};
  for (std::size_t k = most_rows - 1; k < all.size(); ++k)
    for (std::size_t p = 0; p < others.u.size(); ++p) others.u[p] = std::hypot(others.u[p], all[k].u[p]);
  all.resize(most_rows - 1);
  all.push_back(std::move(others));
  return all;
}

Path rectangle(double left, double top, double right, double bottom, Colour fill) {
  return {.points = {{left, top}, {right, top}, {right, bottom}, {left, bottom}},
          .closed = true,
          .stroke = ink::solid(ink::none, 0.0),
          .fill = fill};
}

/// One cell: u and its share above a bar.
void draw_cell(Operations& operations, double u, double part, bool is_largest, Point corner, double width,
               const ParameterScale& scale, const Options& options) {
  const double top = corner.y + 12.0;
  operations.push_back(rectangle(corner.x, top, corner.x + width, top + share_bar_height, ink::minor_grid_grey));
  if (part > 0.0)
    operations.push_back(rectangle(corner.x, top, corner.x + std::max(width * part, 0.4), top + share_bar_height,
                                   is_largest ? ink::blue : ink::faint(ink::blue, 0.45)));
  const std::string number = shown_uncertainty(Deviation::native(u), scale, options);
  plot::Runs amount = {plot::plain(u == 0.0 ? "–" : number)};
  amount.front().bold = is_largest;
  operations.push_back(label(std::move(amount), {corner.x, corner.y + 9.0}, ink::text_size, Anchor::start,
                             u == 0.0 ? ink::grey : ink::black));
  if (u == 0.0) return;
  operations.push_back(label({plot::plain(shown_percent(part, options))}, {corner.x + width, corner.y + 9.0},
                             ink::tick_text_size, Anchor::end, ink::grey));
}

std::string description(const std::vector<Contribution>& all, const std::vector<std::size_t>& parameters,
                        const Subject& subject, const Options& options) {
  const AxisKind kind = subject.test.metadata.axis.kind;
  std::string text;
  for (std::size_t p : parameters)
    if (const auto first = leading(all, p, subject.assessment))
      text += fmt::format("{}Largest contribution to {}: {}.", text.empty() ? "" : " ", iso230_2::parameters[p].symbol,
                          leading_statement(*first, kind, options));
  return text;
}

}  // namespace

std::optional<Figure> contribution_figure(const Subject& subject, const Options& asked) {
  const Options options = fitted(asked, subject.assessment.evaluation.parameters);
  const AxisKind kind = subject.test.metadata.axis.kind;
  const ParameterScale scale = parameter_scale(kind, options.unit);
  const auto all = shown_contributions(subject.assessment);
  std::vector<std::size_t> parameters = main_parameters(subject.assessment.evaluation.parameters);
  std::erase_if(parameters, [&](std::size_t p) { return !leading(all, p, subject.assessment); });
  if (all.empty() || parameters.empty()) return std::nullopt;

  Figure figure{.width = plot::plate_width, .height = 0.0, .title = {}, .description = {}, .operations = {}};
  Operations& operations = figure.operations;
  const double header = plot::draw_label(operations, translated(subject.assessment.label, options), 0.0, right_edge);
  const auto count = static_cast<double>(parameters.size());
  const double left = title_width + title_gap;
  const double width = std::min(95.0, (right_edge - left + column_gap) / count - column_gap);
  const auto column = [&](std::size_t c) { return left + static_cast<double>(c) * (width + column_gap); };
  for (std::size_t c = 0; c < parameters.size(); ++c) {
    plot::Runs head = {plot::italic("u"), plot::plain("(")};
    head = plot::joined(plot::joined(head, plot::symbol(iso230_2::parameters[parameters[c]])), {plot::plain(")")});
    operations.push_back(label(plot::joined(head, {plot::plain(fmt::format(" / {}", scale.unit))}),
                               {column(c), header + 9.0}, ink::text_size, Anchor::start));
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double top = header + head_height + input_pitch * static_cast<double>(k);
    operations.push_back(plot::line({0.0, top}, {right_edge, top}, ink::solid(ink::grid_grey, 0.4)));
    operations.push_back(
        label({plot::plain(plot::shortened(translated(all[k].title, options), title_width, ink::text_size))},
              {0.0, top + 12.5}, ink::text_size, Anchor::start));
    for (std::size_t c = 0; c < parameters.size(); ++c) {
      const std::size_t p = parameters[c];
      const bool is_largest = leading(all, p, subject.assessment)->contribution == &all[k];
      draw_cell(operations, all[k].u[p], share(all, k, p), is_largest, {column(c), top}, width, scale, options);
    }
  }
  figure.height = header + head_height + input_pitch * static_cast<double>(all.size()) + 1.0;
  figure.title =
      fmt::format("Contributions of the inputs to the standard uncertainty ({}), and their parts of the variance",
                  iso230_2::method_title(contributing_method(subject.assessment)));
  figure.description = description(all, parameters, subject, options);
  return figure;
}

}  // namespace axiometry::report
