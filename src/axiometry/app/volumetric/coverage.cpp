// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <utility>

#include "axiometry/app/results/result_json.h"
#include "axiometry/app/volumetric/simulate_calibration.h"

namespace axiometry::app {
namespace {

using json::Value;
using volumetric::CoverageStudy;
using volumetric::CoverageTrial;

Value share_value(const volumetric::Share& share) {
  Value value = Value::object();
  value.add("share", share.share());
  value.add("z_rms", share.rms());
  value.add("values", share.count);
  return value;
}

Value total_value(const CoverageStudy::Total& total) {
  Value value = share_value(total.share);
  value.add("standard_error", total.standard_error);
  return value;
}

/// Of counts in all trials.
std::size_t sum_of(const CoverageStudy& coverage, std::size_t CoverageTrial::*which) {
  std::size_t sum = 0;
  for (const CoverageTrial& trial : coverage.trials) sum += trial.*which;
  return sum;
}

double field_rms(const CoverageStudy& coverage) {
  double sum = 0.0;
  for (const CoverageTrial& trial : coverage.trials) sum += trial.field_error_um_squared;
  return std::sqrt(sum / static_cast<double>(coverage.trials.size()));
}

}  // namespace

Result<CoverageStudy> coverage_of(const SimulateRequest& request, std::size_t trials) {
  AXIOMETRY_TRY(SimulationInputs inputs, simulation_inputs(request));
  volumetric::CoverageOptions options{.trials = trials, .seed = request.seed};
  if (inputs.has_errors) options.errors = std::move(inputs.errors);
  options.size = request.size;
  options.points = request.points;
  options.visits = std::move(inputs.visits);
  options.faults = request.faults;
  options.identify.sizes = {request.spans, request.spans, request.spans};
  options.identify.reversal = request.reversal;
  return volumetric::try_coverage(inputs.machine, options);
}

Value coverage_value(const SimulateRequest& request, const CoverageStudy& coverage) {
  Value root = Value::object();
  root.add("seed", static_cast<double>(request.seed));
  root.add("trials", coverage.trials.size());
  root.add("failed", coverage.failed);
  if (coverage.failed > 0) root.add("first_failure", coverage.first_failure);
  root.add("curves", total_value(coverage.total(&CoverageTrial::curves)));
  if (request.reversal != volumetric::Reversal::none)
    root.add("directions", total_value(coverage.total(&CoverageTrial::directions)));
  root.add("field", total_value(coverage.total(&CoverageTrial::field)));
  root.add("field_rms_um", field_rms(coverage));
  root.add("chi2_per_dof", coverage.chi_squared_per_dof());
  Value& errors = root.add("errors", Value::object());
  const auto names = volumetric::error_names();
  for (std::size_t e = 0; e < names.size(); ++e) {
    volumetric::Share share;
    for (const CoverageTrial& trial : coverage.trials) share.add(trial.errors[e]);
    errors.add(names[e], share_value(share));
  }
  Value& faults = root.add("faults", Value::object());
  faults.add("untold_breaks", request.faults.untold_breaks * coverage.trials.size());
  faults.add("breaks_found", sum_of(coverage, &CoverageTrial::breaks_found));
  faults.add("breaks_wrong", sum_of(coverage, &CoverageTrial::breaks_wrong));
  faults.add("outliers", request.faults.outliers * coverage.trials.size());
  faults.add("outliers_found", sum_of(coverage, &CoverageTrial::outliers_found));
  faults.add("set_aside_wrong", sum_of(coverage, &CoverageTrial::set_aside_wrong));
  root.add("program", program_to_json());
  return root;
}

std::string coverage_text(const CoverageStudy& coverage) {
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(
      out, "{} trials{}\n", coverage.trials.size(),
      coverage.failed > 0 ? fmt::format(", {} more failed: {}", coverage.failed, coverage.first_failure) : "");
  const auto line = [&](const char* what, volumetric::Share CoverageTrial::*which) {
    const CoverageStudy::Total total = coverage.total(which);
    if (total.share.count == 0 && which == &CoverageTrial::directions) return;
    fmt::format_to(out, "{} within 1.96 u: {:.2f} % +- {:.2f} % (95 % expected), rms of z {:.3f}, {} values\n", what,
                   100.0 * total.share.share(), 100.0 * total.standard_error, total.share.rms(), total.share.count);
  };
  line("Curves", &CoverageTrial::curves);
  line("Directions", &CoverageTrial::directions);
  line("Field", &CoverageTrial::field);
  fmt::format_to(out, "Field off by {:.3f} um rms; chi2/dof {:.4f}\n", field_rms(coverage),
                 coverage.chi_squared_per_dof());
  fmt::format_to(out, "Breaks found {}, wrong ones {}; outliers found {}, right readings set aside {}\n",
                 sum_of(coverage, &CoverageTrial::breaks_found), sum_of(coverage, &CoverageTrial::breaks_wrong),
                 sum_of(coverage, &CoverageTrial::outliers_found), sum_of(coverage, &CoverageTrial::set_aside_wrong));
  return text;
}

}  // namespace axiometry::app
