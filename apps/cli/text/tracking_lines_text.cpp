// SPDX-License-Identifier: Apache-2.0
#include "cli/text/tracking_lines_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/model/aligned.h"
#include "axiometry/report/conformity_text.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/report/finding_text.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/translated.h"
#include "axiometry/standards/error_motions/motion_estimate.h"
#include "axiometry/tracking/lengths/face_pairs.h"
#include "cli/text/findings_text.h"
#include "cli/text/flags_of_words.h"

namespace axiometry::cli {
namespace {

using uncertainty::Verdict;

constexpr std::size_t line_id_width = 9;
constexpr std::size_t cell_width = 8;
constexpr std::size_t range_width = 18;
constexpr std::size_t slope_width = 17;
constexpr std::string_view shown_parameters[] = {"E", "R", "B", "A"};

std::string heading(const app::EvaluatedLines& e, const report::Options& options, const Terminal& terminal) {
  const Vector3 s = e.plan.setup.station.position_mm;
  const auto number = [&](double x) { return format_fixed(x, 3, options.numbers); };
  const auto said = [&](std::string_view english) { return report::translated(english, options); };
  std::string title = said(is_aligned(e.plan.setup) ? "Diagonals by an aligned interferometer"
                                                    : "Lines from a tracking interferometer");
  if (!e.plan.machine.empty()) title += ", " + e.plan.machine;
  const std::string& file = e.lengths.file;
  return fmt::format(
      "{}\n{}\n{}\n\n", terminal.bold(report::printable(title)),
      is_aligned(e.plan.setup) ? said("An interferometer that is aligned with each line in turn")
                               : said(fmt::format("Station at {}, {}, {} mm, {}", number(s.x), number(s.y), number(s.z),
                                                  e.station_file ? "located" : "as planned")),
      terminal.faint(fmt::format("{} (SHA-256 {}…)", file == "-" ? said("standard input") : report::printable(file),
                                 e.lengths.sha256.substr(0, 12))));
}

/// The slope with so many decimals as its uncertainty has meaning; without one where nothing tells it.
std::string slope_text(double slope, double U, const report::Options& options) {
  if (!(U > 0.0)) return format_fixed(slope, 2, options.numbers);
  const int decimals = std::clamp(decimals_for(U, 2), 0, 3);
  return fmt::format("{} ± {}", format_fixed(slope, decimals, options.numbers),
                     format_fixed(U, decimals, options.numbers));
}

double slope_U(const tracking::EvaluatedLine& line) {
  return error_motions::coverage_of(line.slope_degrees_of_freedom) * line.slope_uncertainty_um_per_m;
}

std::string row(const tracking::EvaluatedLine& line, const app::Evaluated& test, const report::Options& options,
                const Terminal& terminal) {
  const auto& parameters = test.assessment.evaluation.parameters;
  std::string text = terminal.bold(left(report::printable(line.id), line_id_width));
  const auto [nearest, farthest] = std::ranges::minmax(line.distances_mm);
  text += right(report::translated(fmt::format("{} to {}", format_fixed(nearest, 0, options.numbers),
                                               format_fixed(farthest, 0, options.numbers)),
                                   options),
                range_width);
  for (const std::string_view key : shown_parameters) {
    const auto& value = parameters.*iso230_2::find_parameter(key)->member;
    text += right(value ? format_fixed(value->in_native(), 1, options.numbers) : "–", cell_width);
  }
  text += right(slope_text(line.slope_um_per_m, slope_U(line), options), slope_width);
  const double bound =
      line.length_difference_bounds.empty() ? std::nan("") : std::ranges::max(line.length_difference_bounds).in_um();
  const std::string shown = std::isnan(bound)              ? "–"
                            : bound > 0.0 && bound < 0.005 ? "< " + format_fixed(0.01, 2, options.numbers)
                                                           : format_fixed(bound, 2, options.numbers);
  text += right(shown, cell_width);
  text += "  " + std::string(is_diagonal(test.test.metadata.axis) ? "230-6" : "230-2");
  if (const auto verdict = iso230_2::overall_verdict(test.judgements)) {
    const std::string name = "  " + report::translated(uncertainty::verdict_name(*verdict), options);
    text += *verdict == Verdict::conforms           ? terminal.green(name)
            : *verdict == Verdict::does_not_conform ? terminal.red(name)
                                                    : terminal.yellow(name);
  }
  return text + "\n";
}

std::string table(const app::EvaluatedLines& e, const report::Options& options, const Terminal& terminal) {
  const auto said = [&](std::string_view english) { return report::translated(english, options); };
  std::string head = left(said("line"), line_id_width) + right(said("distances") + "/mm", range_width);
  for (const std::string_view key : shown_parameters) head += right(fmt::format("{}/µm", key), cell_width);
  head += right(said("slope") + "/(µm/m)", slope_width) + right("Δd/µm", cell_width) + "  ISO";
  std::string text = terminal.faint(head) + "\n";
  for (std::size_t k = 0; k < e.tests.size(); ++k) text += row(e.evaluation.lines[k], e.tests[k], options, terminal);
  return text +
         terminal.faint(wrapped(said(is_aligned(e.plan.setup)
                                         ? "Slopes with U (95 %) of their scatter, kept in E and A; distances from the "
                                           "beginning of each line"
                                         : "Slopes with U (95 %) of their scatter, kept in E and A; Δd: 95 % bound of "
                                           "the length difference that the uncertainty of the station causes"),
                                terminal.width(), 0)) +
         "\n\n";
}

std::string diagonals(const app::EvaluatedLines& e, const report::Options& options, const Terminal& terminal) {
  const auto& d = e.diagonals;
  if (!d.E && !d.R && !d.B) return "";
  std::string text;
  const auto add = [&](std::string_view name, const auto& largest) {
    if (largest)
      text += fmt::format("{}{} {} µm ({})", text.empty() ? "" : ", ", name,
                          format_fixed(largest->value.in_native(), 1, options.numbers), report::printable(largest->id));
  };
  add("E", d.E);
  add("R", d.R);
  add("B", d.B);
  return fmt::format("{} {}{}{}\n", terminal.bold(std::string(iso230_6::edition)),
                     report::translated("largest of the diagonals", options), report::colon(options), text) +
         terminal.faint(
             wrapped(report::translated("Errors can cancel along a diagonal: a small E proves little alone.", options),
                     terminal.width(), 0)) +
         "\n\n";
}

std::string pairs(const app::EvaluatedLines& e, const report::Options& options, const Terminal& terminal) {
  const auto pairs = tracking::face_pairs(e.evaluation.lines);
  if (pairs.empty()) return "";
  std::string text;
  for (const tracking::FacePair& pair : pairs)
    text += fmt::format(
        "{}{}/{}  {} {} µrad\n", left(pair.face, line_id_width), pair.first, pair.second, pair.term,
        pair.uncertainty_um_per_m
            ? slope_text(pair.squareness_um_per_m, pair.coverage_factor * *pair.uncertainty_um_per_m, options)
            : format_fixed(pair.squareness_um_per_m, 2, options.numbers));
  return terminal.bold(report::translated("Squareness from the two diagonals of a face", options)) + "\n" + text + "\n";
}

std::string squareness(const app::EvaluatedLines& e, const report::Options& options, const Terminal& terminal) {
  if (!e.evaluation.squareness) return "";
  std::string text, untold;
  for (const tracking::SquarenessTerm& term : e.evaluation.squareness->terms) {
    if (!term.value_um_per_m) {
      untold += fmt::format("{}{}", untold.empty() ? "" : ", ", term.id);
      continue;
    }
    text += left(term.id, line_id_width);
    text += term.uncertainty_um_per_m
                ? slope_text(*term.value_um_per_m, term.coverage_factor * *term.uncertainty_um_per_m, options)
                : format_fixed(*term.value_um_per_m, 2, options.numbers);
    text += term.id.starts_with("e_") ? " µm/m\n" : " µrad\n";
  }
  if (!text.empty())
    text = terminal.bold(report::translated("Scales and squareness from the slopes", options)) + "\n" + text;
  if (!untold.empty())
    text += terminal.faint(fmt::format("{}{}{}", report::translated("Not told by these lines", options),
                                       report::colon(options), untold)) +
            "\n";
  for (const std::string& note : e.evaluation.squareness->notes)
    text += terminal.faint(wrapped(report::printable(report::translated(note, options)), terminal.width(), 0)) + "\n";
  return text.empty() ? "" : text + "\n";
}

std::string findings(const app::EvaluatedLines& e, const report::Options& options, const Terminal& terminal) {
  std::string text;
  for (const tracking::Finding& finding : e.evaluation.findings) {
    const std::string name = left(report::translated(finding.serious ? "serious" : "note", options), 10);
    text += (finding.serious ? terminal.red(name) : terminal.faint(name)) +
            wrapped(report::printable(with_flags(report::translated(finding.message, options), finding.message)),
                    terminal.width(), 10) +
            "\n";
  }
  return text;
}

/// What of the tests departs from their standard, each once with its lines.
std::string departures_text(const app::EvaluatedLines& e, const report::Options& options, const Terminal& terminal) {
  std::vector<iso230_2::Finding> all;
  std::vector<std::vector<std::string>> lines;  // ids of the lines that have each finding
  for (std::size_t k = 0; k < e.tests.size(); ++k) {
    const iso230_2::Assessment& assessment = e.tests[k].assessment;
    const AxisKind kind = e.tests[k].test.metadata.axis.kind;
    for (auto& finding : report::shown_findings(assessment.findings, assessment, kind, options)) {
      if (finding.severity != iso230_2::Severity::departure) continue;
      const auto same = std::ranges::find_if(all, [&](const iso230_2::Finding& other) {
        return other.clause == finding.clause && other.message == finding.message;
      });
      const auto at = static_cast<std::size_t>(same - all.begin());
      if (same == all.end()) {
        all.push_back(std::move(finding));
        lines.emplace_back();
      }
      lines[at].push_back(e.evaluation.lines[k].id);
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i].message =
        fmt::format("{} {}: {}", lines[i].size() == 1 ? "line" : "lines", fmt::join(lines[i], ", "), all[i].message);
  return findings_text(all, options, terminal);
}

/// Why no verdict was given where there is a value, line by line.
std::string withheld_text(const app::EvaluatedLines& e, const report::Options& options, const Terminal& terminal) {
  std::string text;
  for (std::size_t k = 0; k < e.tests.size(); ++k)
    for (const std::string& reason : report::withheld_statements(e.tests[k].judgements)) {
      const std::string said =
          report::translated(fmt::format("line {}: {}", e.evaluation.lines[k].id, reason), options);
      text += terminal.yellow(wrapped(report::printable(with_flags(said, reason)), terminal.width(), 0)) + "\n";
    }
  return text.empty() ? text : text + "\n";
}

}  // namespace

std::string lines_summary(const app::EvaluatedLines& e, const report::Options& options, const Terminal& terminal) {
  return heading(e, options, terminal) + table(e, options, terminal) + diagonals(e, options, terminal) +
         pairs(e, options, terminal) + squareness(e, options, terminal) + withheld_text(e, options, terminal) +
         departures_text(e, options, terminal) + findings(e, options, terminal);
}

}  // namespace axiometry::cli
