// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/compare_methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/app/results/named_findings_json.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/numeric/random/random.h"
#include "axiometry/report/translated.h"
#include "axiometry/tracking/polar/polar_network.h"

namespace axiometry::app {
namespace {

using json::Value;
using report::Align;
using report::plain;
using tracking::PolarFit;
using tracking::PolarReading;

constexpr std::size_t points_most = 2000, stations_most = 20;

/// A way of measuring: which stations, with angles or without.
struct Method {
  std::string name, id;
  std::vector<std::size_t> stations;
  bool with_angles = false;
  RangingUncertainty lengths, across;
};

std::vector<Method> methods_of(const CompareMethodsRequest& r) {
  std::vector<Method> methods;
  std::vector<std::size_t> all;
  const RangingUncertainty length = r.polar.length->expanded_uncertainty();
  const RangingUncertainty across = r.polar.kind->across->expanded_uncertainty();
  for (std::size_t j = 0; j < r.stations_mm.size(); ++j) {
    all.push_back(j);
    methods.push_back(
        {fmt::format("Polar, from station {}", j + 1), fmt::format("polar-{}", j + 1), {j}, true, length, across});
  }
  if (all.size() > 1) methods.push_back({"Polar, from all stations joined", "polar-all", all, true, length, across});
  methods.push_back({"Its lengths alone", "lengths-of-polar", all, false, r.polar_changes, {}});
  methods.push_back({"Multilateration", "multilateration", all, false, r.ranging, {}});
  return methods;
}

/// What a station reads without error; of lengths alone they begin at 0 at the first point.
std::vector<PolarReading> exact_readings(const CompareMethodsRequest& r, const Method& method) {
  std::vector<PolarReading> readings;
  for (std::size_t k = 0; k < method.stations.size(); ++k) {
    const Vector3 station = r.stations_mm[method.stations[k]];
    const double zero = method.with_angles ? 0.0 : distance(r.points_mm[0], station);
    for (std::size_t i = 0; i < r.points_mm.size(); ++i) {
      const Vector3 way = r.points_mm[i] - station;
      const double d = norm(way);
      PolarReading reading{i, k, 0, d - zero, method.lengths.standard_mm(d), {}};
      if (method.with_angles) {
        const double across = method.across.standard_mm(d) / d;
        reading.direction = tracking::PolarDirection{std::atan2(way.y, way.x),
                                                     std::atan2(way.z, std::hypot(way.x, way.y)), across, across};
      }
      readings.push_back(reading);
    }
  }
  return readings;
}

/// With errors of their uncertainties: three normal numbers for each reading. Across the beam the direction itself is
/// moved, so that nothing happens at the zenith.
void add_errors(std::vector<PolarReading>& readings, std::span<const double> normal) {
  for (std::size_t k = 0; k < readings.size(); ++k) {
    PolarReading& r = readings[k];
    r.length_mm += r.length_sigma_mm * normal[3 * k];
    if (!r.direction) continue;
    const tracking::PolarFrame frame = tracking::polar_frame(*r.direction);
    const Vector3 u = frame.along + r.direction->sideways_sigma_rad * normal[3 * k + 1] * frame.sideways +
                      r.direction->upwards_sigma_rad * normal[3 * k + 2] * frame.upwards;
    r.direction->azimuth_rad = std::atan2(u.y, u.x);
    r.direction->elevation_rad = std::atan2(u.z, std::hypot(u.x, u.y));
  }
}

double square(double x) { return x * x; }

void put_propagated(const CompareMethodsRequest& r, const PolarFit& fit, MethodOutcome& outcome) {
  Vector3 sums;
  for (std::size_t i = 0; i < fit.points_mm.size(); ++i) {
    double trace = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      sums[c] += fit.covariances_mm2[i][c][c];
      trace += fit.covariances_mm2[i][c][c];
    }
    const double u = 1000.0 * std::sqrt(std::max(trace, 0.0));
    if (u <= outcome.u_point_um_largest) continue;
    outcome.u_point_um_largest = u;
    outcome.worst_point = r.point_names[i];
  }
  const auto n = static_cast<double>(fit.points_mm.size());
  for (std::size_t c = 0; c < 3; ++c) outcome.u_um[c] = 1000.0 * std::sqrt(std::max(sums[c] / n, 0.0));
  outcome.u_point_um = norm(outcome.u_um);
  outcome.told_by_angles = fit.told_by_angles / static_cast<double>(fit.unknowns);
}

/// Root mean square distance of the points found from the true ones.
Result<double> scatter_of_trials(const CompareMethodsRequest& r, std::size_t stations,
                                 const std::vector<PolarReading>& exact, std::uint64_t stream,
                                 tracking::PolarOptions options) {
  options.checks = false;
  double sum = 0.0;
  std::vector<double> normal(3 * exact.size());
  for (std::size_t trial = 0; trial < r.trials; ++trial) {
    numeric::fill_normal({r.seed, stream, trial}, normal);
    std::vector<PolarReading> readings = exact;
    add_errors(readings, normal);
    AXIOMETRY_TRY(const PolarFit fit, tracking::adjust_polar(r.points_mm.size(), stations, readings, options));
    for (std::size_t i = 0; i < r.points_mm.size(); ++i) sum += square(distance(fit.points_mm[i], r.points_mm[i]));
  }
  return 1000.0 * std::sqrt(sum / static_cast<double>(r.trials * r.points_mm.size()));
}

MethodOutcome outcome_of(const CompareMethodsRequest& r, const Method& method, std::uint64_t stream) {
  MethodOutcome outcome;
  outcome.name = method.name;
  outcome.id = method.id;
  tracking::PolarOptions options;
  options.datum = tracking::PolarDatum::nominal;
  options.nominal_mm = r.points_mm;
  options.point_names = r.point_names;
  if (!method.with_angles && method.stations.size() < 4) {
    outcome.failure = "lengths alone need four stations or more";
    return outcome;
  }
  const std::vector<PolarReading> exact = exact_readings(r, method);
  const auto fit = tracking::adjust_polar(r.points_mm.size(), method.stations.size(), exact, options);
  if (!fit) {
    outcome.failure = fit.error().message;
    return outcome;
  }
  put_propagated(r, *fit, outcome);
  const auto scatter = scatter_of_trials(r, method.stations.size(), exact, stream, options);
  if (!scatter)
    outcome.failure = fmt::format("a trial failed: {}", scatter.error().message);
  else
    outcome.trials_point_um = *scatter;
  return outcome;
}

Result<void> check(const CompareMethodsRequest& r) {
  if (r.points_mm.size() < 3 || r.points_mm.size() > points_most)
    return fail(fmt::format("found {} points, expected 3 to {}", r.points_mm.size(), points_most));
  if (r.stations_mm.empty() || r.stations_mm.size() > stations_most)
    return fail(fmt::format("found {} stations, expected 1 to {}", r.stations_mm.size(), stations_most));
  for (std::size_t j = 0; j < r.stations_mm.size(); ++j)
    for (std::size_t i = 0; i < r.points_mm.size(); ++i)
      if (!(distance(r.stations_mm[j], r.points_mm[i]) >= 1.0))
        return fail(fmt::format("found station {} within 1 mm of point {}, expected it away from all points", j + 1,
                                r.point_names[i]));
  if (!r.polar.kind->across || !r.polar.length)
    return fail(
        fmt::format("found {}, of which Table 1 has no accuracy of {}, expected an instrument with angles and "
                    "lengths",
                    r.polar.kind->title, r.polar.kind->across ? "lengths" : "angles"));
  return {};
}

report::Table method_table(const ComparedMethods& compared, const report::Options& options) {
  report::Table table;
  table.groups = {{{}, 1}, {plain("u of a coordinate / µm"), 3}, {plain("u of a point / µm"), 3}, {{}, 1}};
  table.columns = {{plain("Method"), Align::start, true}};
  for (const char* axis : {"X", "Y", "Z"}) table.columns.push_back({plain(axis), Align::decimal});
  for (const char* name : {"all", "worst", "trials"}) table.columns.push_back({plain(name), Align::decimal});
  table.columns.push_back({plain("told by angles / %"), Align::decimal});
  for (const MethodOutcome& m : compared.methods) {
    auto& row = table.rows.emplace_back();
    row.push_back(word_cell(m.name));
    if (!m.failure.empty()) {
      while (row.size() < table.columns.size()) row.push_back({plain("–"), report::Tone::quiet});
      continue;
    }
    for (std::size_t c = 0; c < 3; ++c) row.push_back(number_cell(m.u_um[c], 2, options));
    row.push_back(number_cell(m.u_point_um, 2, options));
    row.push_back(number_cell(m.u_point_um_largest, 2, options));
    row.push_back(number_cell(m.trials_point_um, 2, options));
    row.push_back(number_cell(100.0 * m.told_by_angles, 0, options));
  }
  table.notes = {
      plain("Standard uncertainties (k = 1), root mean square over all points, relative to the points as a "
            "whole; of a point: of its three coordinates together. Trials: the same from the scatter of "
            "simulated measurements.")};
  return table;
}

Value methods_to_json(const ComparedMethods& compared) {
  Value object = Value::object();
  object.add("result", "compare-methods");
  object.add("instrument", compared.request.polar.kind->id);
  object.add("ranging", compared.request.ranging_name);
  object.add("trials", compared.request.trials);
  object.add("seed", compared.request.seed);
  Value& list = object.add("methods", Value::array());
  for (const MethodOutcome& m : compared.methods) {
    Value& item = list.push(Value::object());
    item.add("id", m.id);
    item.add("name", m.name);
    item.add("failure", m.failure.empty() ? Value() : Value(m.failure));
    if (!m.failure.empty()) continue;
    item.add("u_um", formats::vector_value(m.u_um));
    item.add("u_point_um", m.u_point_um);
    item.add("u_point_um_largest", m.u_point_um_largest);
    item.add("worst_point", m.worst_point);
    item.add("trials_point_um", m.trials_point_um);
    item.add("told_by_angles", m.told_by_angles);
  }
  object.add("findings", findings_value(compared.findings));
  object.add("program", program_to_json());
  return object;
}

}  // namespace

Result<ComparedMethods> compare_methods(const CompareMethodsRequest& request) {
  AXIOMETRY_TRY_VOID(check(request));
  ComparedMethods compared{request, {}, {}};
  const std::vector<Method> methods = methods_of(request);
  for (std::size_t k = 0; k < methods.size(); ++k) compared.methods.push_back(outcome_of(request, methods[k], k));
  // A root mean square of N independent trials scatters by 1/√(2N) of itself at most: five times that is chance no
  // more.
  const double chance = 5.0 / std::sqrt(2.0 * static_cast<double>(request.trials));
  for (const MethodOutcome& m : compared.methods) {
    if (!m.failure.empty())
      compared.findings.push_back({"methods-no-result", false, fmt::format("{}: {}", m.name, m.failure)});
    else if (std::abs(m.trials_point_um / m.u_point_um - 1.0) > chance)
      compared.findings.push_back(
          {"methods-trials-scatter", true,
           fmt::format("{}: the trials scatter by {:.2f} times what is propagated: points bend by "
                       "more than lengths are known, and no covariance can be trusted",
                       m.name, m.trials_point_um / m.u_point_um)});
  }
  return compared;
}

Experiment present(const ComparedMethods& compared, const report::Options& options) {
  Experiment experiment{experiment_document("Polar measurement and multilateration",
                                            "Lee et al., Sensors 16 (2016) 482, Table 1, eqs 1 and 2"),
                        methods_to_json(compared)};
  report::Document& document = experiment.document;
  document.running_head = report::translated(document.running_head, options);
  document.identity = {
      {plain("Instrument with angles"), {report::verbatim(compared.request.polar.kind->title)}},
      {plain("Lengths alone"), {report::verbatim(compared.request.ranging_name)}},
      {plain("Points and stations"), word_cell(fmt::format("{} points, {} station{}", compared.request.points_mm.size(),
                                                           compared.request.stations_mm.size(),
                                                           compared.request.stations_mm.size() == 1 ? "" : "s"))},
      {plain("Trials"), word_cell(fmt::format("{}, seed {}", compared.request.trials, compared.request.seed))}};
  report::Section section{"methods", "Uncertainty of the points", true, {}};
  section.blocks.emplace_back(method_table(compared, options));
  document.sections.push_back(std::move(section));
  if (compared.findings.empty()) return experiment;
  report::Section findings{"findings", "Findings", false, {}};
  for (const NamedFinding& finding : compared.findings)
    findings.blocks.emplace_back(report::Paragraph{report::sentence(finding.message), report::Tone::caution});
  document.sections.push_back(std::move(findings));
  return experiment;
}

}  // namespace axiometry::app
