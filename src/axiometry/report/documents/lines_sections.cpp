// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/documents/lines_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "axiometry/model/aligned.h"
#include "axiometry/report/claim_text.h"
#include "axiometry/report/figures/tracking/lines_overview.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/standards/test_standard.h"
#include "axiometry/tracking/lengths/face_pairs.h"

namespace axiometry::report {
namespace {

using iso230_2::AxisParameters;
using iso230_2::ParameterInfo;

/// In the order of the columns.
constexpr std::array<std::string_view, 5> overview_parameters = {"E", "R", "B", "A", "M"};

bool any_uncertainty(const LinesSubject& subject) {
  return std::ranges::any_of(
      subject.lines, [](const AssessedLine& line) { return iso230_2::method_of_record(line.assessment).has_value(); });
}

TableCell number_cell(double x, int decimals, const Options& options) {
  return std::isfinite(x) ? text_cell(format_fixed(x, decimals, options.numbers)) : quiet_cell("–");
}

void append_parameter(std::vector<TableCell>& row, std::string_view key, const AssessedLine& line, bool with_U,
                      const Options& options) {
  const ParameterInfo& parameter = *iso230_2::find_parameter(key);
  const bool exists = (line.assessment.evaluation.parameters.*parameter.member).has_value();
  const ShownParameter shown = show(parameter, line.assessment, line.line.test.metadata.axis.kind, options);
  row.push_back(exists ? TableCell{strong(shown.value)} : quiet_cell("–"));
  if (with_U) row.push_back(exists && !shown.U.empty() ? text_cell(shown.U) : quiet_cell("–"));
}

/// Whether U stands beside this parameter: those by which machines are accepted most.
bool wants_U(std::string_view key) { return key == "E" || key == "A"; }

std::vector<TableCell> overview_row(const AssessedLine& line, bool with_U, const Options& asked) {
  const Options options = fitted(asked, line.assessment.evaluation.parameters);
  const Axis& axis = line.line.test.metadata.axis;
  const std::string octant = octant_of(axis);
  std::vector<TableCell> row = {TableCell{strong_verbatim(line.line.id)}, text_cell(standard_of(axis)),
                                octant.empty() ? quiet_cell("–") : text_cell(octant),
                                number_cell(line.line.test.series.travel_native(), 1, options)};
  for (std::string_view key : overview_parameters) append_parameter(row, key, line, with_U && wants_U(key), options);
  row.push_back(number_cell(line.line.slope_um_per_m, 2, options));
  const double slope_u = line.line.slope_uncertainty_um_per_m;
  row.push_back(slope_u > 0.0 ? number_cell(slope_u, 2, options) : quiet_cell("–"));
  const iso230_2::Claims claims = iso230_2::claims_of(line.line.test, line.assessment);
  const iso230_2::Claim& tested = claim(claims, iso230_2::ClaimKind::tested);
  row.push_back(tested.holds()            ? TableCell{plain("kept"), Tone::good}
                : is_contradicted(tested) ? TableCell{strong("departs"), Tone::bad}
                                          : TableCell{strong("not all stated"), Tone::caution});
  return row;
}

Table overview_table(const LinesSubject& subject, const Options& options) {
  const bool with_U = any_uncertainty(subject);
  const std::string unit(parameter_scale(AxisKind::linear, options.unit).unit);
  Table table;
  table.columns = {{plain("Line"), Align::start, true},
                   {plain("After")},
                   {plain("Direction")},
                   {plain("Length / mm"), Align::decimal}};
  for (std::string_view key : overview_parameters) {
    table.columns.push_back({joined({italic(key), plain(" / " + unit)}), Align::decimal, false, false, true});
    if (with_U && wants_U(key)) table.columns.push_back({italic("U"), Align::decimal});
  }
  table.columns.push_back({plain("Slope / µm/m"), Align::decimal, false, false, true});
  table.columns.push_back({italic("u"), Align::decimal});
  table.columns.push_back({plain("Tested after it")});
  for (const AssessedLine& line : subject.lines) table.rows.push_back(overview_row(line, with_U, options));
  table.dense = true;
  table.notes = {
      plain("The slope is that of a straight line through the means (least squares); it was not removed, and "
            "all values contain it. Its u is the standard uncertainty of this line alone, without what the "
            "scale of the instrument does to all lines alike.")};
  if (with_U)
    table.notes.push_back(joined(
        {italic("U"), plain(" is the expanded uncertainty of the value before it ("), italic("k"), plain(" = 2).")}));
  return table;
}

std::string_view term_title(std::string_view id) {
  constexpr std::pair<std::string_view, std::string_view> titles[] = {
      {"e_x", "Scale of X"},           {"e_y", "Scale of Y"},           {"e_z", "Scale of Z"},
      {"C0Y", "Squareness of Y to X"}, {"B0Z", "Squareness of Z to X"}, {"A0Z", "Squareness of Z to Y"}};
  for (const auto& [key, title] : titles)
    if (key == id) return title;
  return id;
}

constexpr std::string_view student_note =
    "U for about 95 %: k is Student’s t for the targets and runs that tell the scatter of these slopes, 2 where they "
    "are many.";

Table squareness_table(const tracking::ScalesAndSquareness& squareness, const Options& options) {
  Table table;
  table.columns = {{plain("Quantity"), Align::start, true, true},
                   {plain("Symbol")},
                   {plain("Value"), Align::decimal},
                   {italic("U"), Align::decimal},
                   {italic("k"), Align::decimal},
                   {plain("Unit")}};
  for (const tracking::SquarenessTerm& term : squareness.terms) {
    const bool is_scale = term.id.starts_with("e_");
    const bool has_U = term.value_um_per_m && term.uncertainty_um_per_m;
    table.rows.push_back(
        {text_cell(term_title(term.id)), TableCell{is_scale ? symbol(term.id) : verbatim(term.id)},
         term.value_um_per_m ? number_cell(*term.value_um_per_m, 2, options) : quiet_cell("cannot be told"),
         has_U ? number_cell(term.coverage_factor * *term.uncertainty_um_per_m, 2, options) : quiet_cell("–"),
         has_U ? number_cell(term.coverage_factor, 2, options) : quiet_cell("–"),
         text_cell(is_scale ? "µm/m" : "µrad")});
  }
  table.notes = {plain("A positive scale: the axis goes farther than it was told. C0Y, B0Z and A0Z after ISO 230-1, X "
                       "primary and Y secondary axis; a positive C0Y turns Y about +Z."),
                 plain(student_note)};
  return table;
}

Table residual_table(const LinesSubject& subject, const Options& options) {
  const tracking::ScalesAndSquareness& squareness = *subject.evaluation.squareness;
  Table table;
  table.caption = plain("What the scales and angles leave of the slopes");
  table.columns = {{plain("Line"), Align::start, true},
                   {plain("Slope / µm/m"), Align::decimal},
                   {plain("Remainder / µm/m"), Align::decimal}};
  for (std::size_t k = 0; k < squareness.residuals_um_per_m.size(); ++k) {
    const tracking::EvaluatedLine& line = subject.evaluation.lines[k];
    table.rows.push_back({verbatim_cell(line.id), number_cell(line.slope_um_per_m, 2, options),
                          number_cell(squareness.residuals_um_per_m[k], 2, options)});
  }
  table.notes = {plain(fmt::format("χ² = {} with {} degree{} of freedom.",
                                   format_fixed(squareness.chi_squared, 2, options.numbers),
                                   squareness.degrees_of_freedom, squareness.degrees_of_freedom == 1 ? "" : "s"))};
  return table;
}

/// The target of a line that stands nearest to the station.
std::optional<std::size_t> nearest(const tracking::EvaluatedLine& line) {
  const auto& distances = line.distances_mm;
  if (distances.empty() || line.length_difference_bounds.size() != distances.size()) return std::nullopt;
  return static_cast<std::size_t>(std::ranges::min_element(distances) - distances.begin());
}

std::vector<TableCell> length_difference_row(const tracking::EvaluatedLine& line, const RangingUncertainty& ranging,
                                             const Options& options) {
  const auto at = nearest(line);
  const auto across = [&](double mm) { return at ? number_cell(1000.0 * mm, 1, options) : quiet_cell("–"); };
  std::vector<TableCell> row = {TableCell{strong_verbatim(line.id)}, across(line.offset.larger_mm),
                                across(line.offset.smaller_mm)};
  if (!at) {
    row.insert(row.end(), 5, quiet_cell("–"));
    return row;
  }
  const double distance = line.distances_mm[*at], from = line.negligible_from_mm;
  row.push_back(number_cell(distance, 1, options));
  const double bound_um = line.length_difference_bounds[*at].in_um();
  row.push_back(bound_um > 0.0 && bound_um < 0.0005 ? text_cell("<\u00a0" + format_fixed(0.001, 3, options.numbers))
                                                    : number_cell(bound_um, 3, options));
  row.push_back(number_cell(2.0 * Length::mm(ranging.standard_mm(distance)).in_um(), 3, options));
  row.push_back(std::isfinite(from) ? number_cell(from, from < 10.0 ? 1 : 0, options) : quiet_cell("nowhere"));
  row.push_back(distance >= from ? TableCell{plain("negligible"), Tone::good}
                                 : TableCell{strong("in the budget"), Tone::caution});
  return row;
}

std::string shown_point(Vector3 p, int decimals, const Options& options) {
  return fmt::format("{} / {} / {}\u00a0mm", format_fixed(p.x, decimals, options.numbers),
                     format_fixed(p.y, decimals, options.numbers), format_fixed(p.z, decimals, options.numbers));
}

std::string station_uncertainty_text(const Station& station, const Options& options) {
  if (!station.covariance_mm2) return "";
  const Matrix3& c = *station.covariance_mm2;
  const Vector3 um{1000.0 * std::sqrt(std::max(c[0][0], 0.0)), 1000.0 * std::sqrt(std::max(c[1][1], 0.0)),
                   1000.0 * std::sqrt(std::max(c[2][2], 0.0))};
  return fmt::format("{} / {} / {}\u00a0µm", format_fixed(um.x, 1, options.numbers),
                     format_fixed(um.y, 1, options.numbers), format_fixed(um.z, 1, options.numbers));
}

Facts setup_facts(const TrackingPlan& plan, const Options& options) {
  const TrackingSetup& setup = plan.setup;
  const std::string uncertainty = station_uncertainty_text(setup.station, options);
  Facts facts{"Set-up", {}};
  const auto add = [&](std::string_view name, const std::string& value) {
    facts.facts.push_back({plain(name), value.empty() ? quiet_cell("not stated") : text_cell(value)});
  };
  if (is_aligned(setup)) {
    add("Interferometer", "aligned with each line in turn");
  } else {
    add("Station X / Y / Z", shown_point(setup.station.position_mm, 4, options));
    add("Standard uncertainty of the station, X / Y / Z", uncertainty);
  }
  add("Reflector from where the axes stand", shown_point(setup.tool_offset_mm, 3, options));
  add("Travels from", shown_point(setup.travel.lowest_mm, 3, options));
  add("Travels to", shown_point(setup.travel.highest_mm, 3, options));
  add("Instrument", fmt::format("U = {}\u00a0µm + {}\u00a0µm/m\u00a0·\u00a0L (k = 2)",
                                shown_short(setup.ranging.constant.in_um(), options),
                                shown_short(setup.ranging.per_length.in_um_per_m(), options)));
  facts.facts.push_back({plain("Planned on"), plan.date.empty() ? quiet_cell("not stated") : verbatim_cell(plan.date)});
  return facts;
}

Table lost_table(const TrackingPlan& plan) {
  Table table;
  table.caption = plain(is_aligned(plan.setup) ? "Lines that cannot be measured"
                                               : "Lines that cannot be measured from this station");
  table.columns = {{plain("Line"), Align::start, true}, {plain("Reason"), Align::start, false, true}};
  for (const LostLine& line : plan.lost)
    table.rows.push_back({TableCell{strong_verbatim(line.id)}, TableCell{sentence(line.reason)}});
  return table;
}

}  // namespace

Subject subject_of(const AssessedLine& line) { return {line.line.test, line.assessment, line.judgements}; }

bool has_diagonal(const LinesSubject& subject) {
  return std::ranges::any_of(subject.lines,
                             [](const AssessedLine& line) { return is_diagonal(line.line.test.metadata.axis); });
}

Section overview_section(const LinesSubject& subject, const Options& options) {
  Section section{"overview", "All lines", true, {}};
  section.blocks.emplace_back(overview_table(subject, options));
  section.blocks.emplace_back(lines_overview_figure(subject, options));
  return section;
}

Section lines_claim_section(const LinesSubject& subject) {
  Section section{"claims", "Claims", false, {}};
  Table table;
  table.columns = {{plain("Line"), Align::start, true},
                   {plain("Computed after clause 3")},
                   {plain("Tested in accordance")},
                   {plain("Report complete")},
                   {plain("Clauses that speak against the test")}};
  for (const AssessedLine& line : subject.lines) {
    const iso230_2::Claims claims = iso230_2::claims_of(line.line.test, line.assessment);
    std::vector<TableCell> row = {TableCell{strong_verbatim(line.line.id)}};
    for (const iso230_2::Claim& claim : claims)
      row.push_back(claim.holds() ? TableCell{plain("Yes"), Tone::good}
                                  : TableCell{strong("No"), is_contradicted(claim) ? Tone::bad : Tone::caution});
    std::vector<std::string> clauses;
    for (const iso230_2::Finding& point : claim(claims, iso230_2::ClaimKind::tested).against)
      if (std::ranges::find(clauses, point.clause) == clauses.end()) clauses.push_back(point.clause);
    row.push_back(clauses.empty() ? quiet_cell("–") : text_cell(fmt::format("{}", fmt::join(clauses, ", "))));
    table.rows.push_back(std::move(row));
  }
  section.blocks.emplace_back(std::move(table));
  return section;
}

Table face_pair_table(std::span<const tracking::FacePair> pairs, const Options& options) {
  Table table;
  table.caption = plain("Squareness from the two diagonals of a face");
  table.columns = {{plain("Face"), Align::start, true},
                   {plain("Diagonals")},
                   {plain("Difference of slopes / µm/m"), Align::decimal, false, false, true},
                   {plain("Squareness")},
                   {plain("µrad"), Align::decimal},
                   {italic("U"), Align::decimal},
                   {italic("k"), Align::decimal}};
  for (const tracking::FacePair& pair : pairs)
    table.rows.push_back({verbatim_cell(pair.face), verbatim_cell(fmt::format("{}, {}", pair.first, pair.second)),
                          number_cell(pair.slope_difference_um_per_m, 2, options), verbatim_cell(pair.term),
                          number_cell(pair.squareness_um_per_m, 2, options),
                          pair.uncertainty_um_per_m
                              ? number_cell(pair.coverage_factor * *pair.uncertainty_um_per_m, 2, options)
                              : quiet_cell("–"),
                          pair.uncertainty_um_per_m ? number_cell(pair.coverage_factor, 2, options) : quiet_cell("–")});
  table.notes = {
      plain("From the law of cosines: with the direction u of the first diagonal the angle is the difference of the "
            "slopes over twice the product of its two components. What the scales of the axes and of the instrument do "
            "to both diagonals alike cancels; what changed between the two, such as the temperature, does not, and is "
            "not in U."),
      plain(student_note)};
  return table;
}

Section diagonal_section(const LinesSubject& subject, const Options& options) {
  Section section{"diagonals", "Diagonals (ISO 230-6)", true, {}};
  Facts facts;
  const auto add = [&](std::string_view name, std::string_view key,
                       const std::optional<iso230_6::DiagonalSummary::Largest>& largest) {
    const auto line = std::ranges::find_if(
        subject.lines, [&](const AssessedLine& candidate) { return largest && candidate.line.id == largest->id; });
    TableCell value = quiet_cell("not applicable");
    if (line != subject.lines.end()) {
      const Options own = fitted(options, line->assessment.evaluation.parameters);
      const ShownParameter shown = show(*iso230_2::find_parameter(key), line->assessment, AxisKind::linear, own);
      value = {joined({strong(shown.value), plain(fmt::format("\u00a0{}, along {}", shown.unit, largest->id))})};
    }
    facts.facts.push_back({joined({plain(name), plain(" "), italic(key)}), std::move(value)});
  };
  add("Largest bidirectional systematic deviation", "E", subject.diagonals.E);
  add("Largest repeatability", "R", subject.diagonals.R);
  add("Largest reversal error", "B", subject.diagonals.B);
  section.blocks.emplace_back(std::move(facts));
  section.blocks.emplace_back(Notice{
      Tone::caution,
      plain("Errors of several axes may cancel along a diagonal"),
      {plain(
          "A small E of one diagonal proves little alone: look at all of them together, and at the single axes. Scale "
          "errors and squareness show as slopes.")}});
  if (const auto pairs = tracking::face_pairs(subject.evaluation.lines); !pairs.empty())
    section.blocks.emplace_back(face_pair_table(pairs, options));
  const bool rays = std::ranges::any_of(subject.lines, [](const AssessedLine& line) {
    return is_diagonal(line.line.test.metadata.axis) && line.line.id.find('-') == std::string::npos;
  });
  if (rays)
    section.blocks.emplace_back(Paragraph{
        plain("xy, xz, yz and xyz are rays from the station, over what of the travels can be reached and seen "
              "from there; they are not the full diagonals of the box of travels.")});
  return section;
}

Section squareness_section(const LinesSubject& subject, const Options& options) {
  const tracking::ScalesAndSquareness& squareness = *subject.evaluation.squareness;
  Section section{"squareness", "Scales and squareness from the slopes", true, {}};
  section.blocks.emplace_back(squareness_table(squareness, options));
  if (squareness.degrees_of_freedom > 0 && squareness.residuals_um_per_m.size() == subject.evaluation.lines.size())
    section.blocks.emplace_back(residual_table(subject, options));
  for (const std::string& note : squareness.notes) section.blocks.emplace_back(Paragraph{sentence(note), Tone::quiet});
  return section;
}

Section length_difference_section(const LinesSubject& subject, const Options& options) {
  Section section{"length-difference", "Effect of the station’s uncertainty", true, {}};
  Table table;
  table.columns = {{plain("Line"), Align::start, true},
                   {joined({symbol("u_1"), plain(" / µm")}), Align::decimal},
                   {joined({symbol("u_2"), plain(" / µm")}), Align::decimal},
                   {plain("Nearest target / mm"), Align::decimal, false, false, true},
                   {plain("|Δd| there / µm"), Align::decimal},
                   {joined({italic("U"), plain(" of the instrument / µm")}), Align::decimal},
                   {plain("Negligible from / mm"), Align::decimal, false, false, true},
                   {plain("In this test")}};
  for (const tracking::EvaluatedLine& line : subject.evaluation.lines)
    table.rows.push_back(length_difference_row(line, subject.plan.setup.ranging, options));
  table.dense = true;
  table.notes = {
      joined({symbol("u_1"), plain(" and "), symbol("u_2"),
              plain(" are the standard uncertainties of the station across the line, in its two principal directions. "
                    "|Δd| holds the length difference with 95\u00a0%, relative to the farthest target.")}),
      plain(
          "From the distance stated on, |Δd| is less than a third of the instrument’s own uncertainty, which makes it "
          "5\u00a0% of both together."),
  };
  if (!subject.plan.setup.station.covariance_mm2)
    section.blocks.emplace_back(
        Notice{Tone::caution,
               plain("The uncertainty of the station is not known"),
               {plain("Its effect on the lengths is not in the budgets; locate the station from six points.")}});
  section.blocks.emplace_back(std::move(table));
  return section;
}

Section setup_section(const LinesSubject& subject, const Options& options) {
  Section section{"setup", "Set-up of the measurement", false, {}};
  section.blocks.emplace_back(setup_facts(subject.plan, options));
  if (!subject.plan.lost.empty()) section.blocks.emplace_back(lost_table(subject.plan));
  Figure figure = layout_figure(layout_of(subject.plan), options);
  figure.title = is_aligned(subject.plan.setup) ? "Travels of the reflector and lines"
                                                : "Station, travels of the reflector and lines";
  section.blocks.emplace_back(std::move(figure));
  return section;
}

std::optional<Table> tracking_finding_table(std::span<const tracking::Finding> findings) {
  if (findings.empty()) return std::nullopt;
  Table table;
  table.caption = plain("Lengths, beam and station");
  table.columns = {{plain("Kind"), Align::start, true}, {plain("Finding"), Align::start, false, true}};
  for (const bool serious : {true, false})
    for (const tracking::Finding& finding : findings)
      if (finding.serious == serious)
        table.rows.push_back({serious ? TableCell{strong("Serious"), Tone::bad} : TableCell{plain("Note"), Tone::quiet},
                              TableCell{sentence(finding.message)}});
  return table;
}

std::string shown_mm(double mm, int decimals, const Options& options) {
  return std::isfinite(mm) ? fmt::format("{}\u00a0mm", format_fixed(mm, decimals, options.numbers)) : "–";
}

}  // namespace axiometry::report
