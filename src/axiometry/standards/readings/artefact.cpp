// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the source: its text was not at hand.
#include "axiometry/standards/readings/artefact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "axiometry/base/decimal_tie.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/unit_sizes.h"
#include "axiometry/standards/iso230_2/programme.h"
#include "axiometry/standards/readings/reading_change.h"
#include "axiometry/standards/readings/usual_expansion.h"

namespace axiometry::iso230_2 {
namespace {

constexpr double nearest_share = 0.1;  // share of the interval by which a calibrated position may be off its target

/// Four decimals at most.
std::string mm(double x) { return format_exact(std::round(x * 1e4) / 1e4) + " mm"; }

struct ArtefactTemperature {
  double expansion = 0.0;  ///< µm/(m·°C)
  double start = 0.0;      ///< °C
  double end = 0.0;
  std::size_t sensors = 0;

  double strain(double share) const {
    return expansion * strain_per_um_per_m * (start + share * (end - start) - reference_temperature);
  }
};

std::optional<ExpansionCoefficient> expansion_of(const Metadata& metadata) {
  return metadata.nde.equipment_expansion ? metadata.nde.equipment_expansion : metadata.uncertainty.device_expansion;
}

std::optional<ArtefactTemperature> sensors_of(const Metadata& metadata) {
  ArtefactTemperature sum;
  for (const TemperatureSensor& sensor : metadata.environment.sensors) {
    if (!text::equal_ignoring_case(sensor.role, "equipment") || !(sensor.start || sensor.end)) continue;
    sum.start += (sensor.start ? *sensor.start : *sensor.end).in_celsius();
    sum.end += (sensor.end ? *sensor.end : *sensor.start).in_celsius();
    ++sum.sensors;
  }
  if (sum.sensors == 0) return std::nullopt;
  sum.start /= static_cast<double>(sum.sensors);
  sum.end /= static_cast<double>(sum.sensors);
  return sum;
}

/// What is known of the artefact's temperature; nothing where it counts as at 20 °C.
Result<std::optional<ArtefactTemperature>> temperature_of(const Metadata& metadata) {
  if (metadata.nde.applied == true) return std::nullopt;
  auto known = sensors_of(metadata);
  const auto alpha = expansion_of(metadata);
  if (known && !alpha)
    return fail(
        "found temperatures of the artefact and no expansion coefficient, expected nde.equipment_expansion_um_per_m_C "
        "(0 for an artefact that does not expand)");
  if (!known || alpha->in_um_per_m_K() == 0.0) return std::nullopt;
  known->expansion = alpha->in_um_per_m_K();
  return known;
}

Result<void> check_positions(const Test& test) {
  const auto& calibrated = test.metadata.artefact.calibrated_positions;
  const auto targets = test.series.targets();
  if (test.metadata.axis.kind == AxisKind::rotary)
    return fail("found calibrated positions of an artefact on a rotary axis, expected a linear one (Annex D)");
  if (calibrated.empty())
    return fail(
        "found no calibrated positions of the artefact, expected artefact.calibrated_positions, one per target");
  if (calibrated.size() != targets.size())
    return fail(fmt::format("found {} calibrated positions of the artefact for {} targets, expected one per target",
                            calibrated.size(), targets.size()));
  for (std::size_t i = 0; i < calibrated.size(); ++i) {
    if (!std::isfinite(calibrated[i]))
      return fail(fmt::format("found a calibrated position {} that is no number, expected one in mm", i + 1));
    if (i > 0 && calibrated[i] <= calibrated[i - 1])
      return fail(
          fmt::format("found the calibrated position {} at {} after {}, expected ascending ones in the order of "
                      "the targets",
                      i + 1, mm(calibrated[i]), mm(calibrated[i - 1])));
  }
  for (std::size_t i = 1; i < calibrated.size(); ++i) {
    const double nominal = targets[i].in_native() - targets[0].in_native();
    const double distance = calibrated[i] - calibrated[0];
    double interval = targets[i].in_native() - targets[i - 1].in_native();
    if (i + 1 < calibrated.size()) interval = std::min(interval, targets[i + 1].in_native() - targets[i].in_native());
    if (std::abs(distance - nominal) > nearest_share * interval)
      return fail(
          fmt::format("found the calibrated position {} at {} from the first, its target at {}, expected them "
                      "within {} of each other (a tenth of the interval)",
                      i + 1, mm(distance), mm(nominal), mm(nearest_share * interval)));
  }
  return {};
}

AppliedCorrection record_of(const Test& test, const std::optional<ArtefactTemperature>& temperature) {
  const Artefact& artefact = test.metadata.artefact;
  AppliedCorrection record;
  record.id = artefact_correction;
  record.title = "Calibrated positions of the artefact (Annex D)";
  record.details = {{"Deviation", "calibrated less indicated position, both from the first one"},
                    {"Calibrated positions at 20 °C",
                     fmt::format("{} from {} to {}", artefact.calibrated_positions.size(),
                                 mm(artefact.calibrated_positions.front()), mm(artefact.calibrated_positions.back()))}};
  if (temperature)
    record.details.push_back(
        {"Expansion of the artefact",
         fmt::format("{} µm/(m·°C), {:.2f} °C at the start, {:.2f} °C at the end{}",
                     format_exact(temperature->expansion), temperature->start, temperature->end,
                     temperature->sensors > 1 ? fmt::format(" (mean of {} sensors)", temperature->sensors) : "")});
  else
    record.details.push_back({"Expansion of the artefact", test.metadata.nde.applied == true
                                                               ? "none: the readings were already corrected for it"
                                                               : "none"});
  return record;
}

/// Findings about one test.
class Rules {
 public:
  explicit Rules(const Test& test) : test_(test), artefact_(test.metadata.artefact), targets_(test.series.targets()) {}

  std::vector<Finding> operator()() const {
    std::vector<Finding> all;
    for (auto finding : {temperature(), turned(), one_side(), shorter_than_axis(), equal_steps()})
      if (finding) all.push_back(*std::move(finding));
    return all;
  }

 private:
  static Finding note(std::string id, std::string message) {
    return {std::move(id), "Annex D", Severity::note, std::move(message)};
  }

  std::optional<Finding> temperature() const {
    const Metadata& m = test_.metadata;
    const auto alpha = expansion_of(m);
    if (m.nde.applied == true || sensors_of(m) || (alpha && alpha->in_um_per_m_K() == 0.0)) return std::nullopt;
    return Finding{"artefact-temperature", "Annex D", Severity::missing,
                   "found no temperature of the artefact, expected a sensor with role equipment and "
                   "nde.equipment_expansion_um_per_m_C; its calibrated positions are used as at 20 °C"};
  }

  std::optional<Finding> turned() const {
    return note("artefact-indicated-positions",
                fmt::format("found the readings to be positions that the machine indicated at {} calibrated places of "
                            "the artefact; the deviations are calibrated less indicated positions",
                            targets_.size()));
  }

  std::optional<Finding> one_side() const {
    if (test_.series.has_both_directions()) return std::nullopt;
    return note(
        "artefact-one-side",
        "found places of the artefact probed from one side only, expected both: the reversal error does not show");
  }

  std::optional<Finding> shorter_than_axis() const {
    const auto whole = axis_ends(test_.metadata.axis).length_native();
    if (!whole) return std::nullopt;
    const double spans = targets_.back().in_native() - targets_.front().in_native();
    const double intervals = static_cast<double>(targets_.size() - 1);
    if (spans + 2.0 * spans / intervals >= *whole) return std::nullopt;  // less than an interval at each end
    return note("artefact-shorter-than-axis",
                fmt::format("found an artefact that spans {} of an axis travel of {}, expected it to be set up again "
                            "with an overlap where the whole travel counts; the results hold for that part only",
                            mm(spans), mm(*whole)));
  }

  /// A gauge has the steps it has. When they hold whole periods of the scale each reading has the same periodic error.
  std::optional<Finding> equal_steps() const {
    const double step =
        (targets_.back().in_native() - targets_.front().in_native()) / static_cast<double>(targets_.size() - 1);
    for (std::size_t i = 1; i < targets_.size(); ++i)
      if (std::abs(targets_[i].in_native() - targets_[i - 1].in_native() - step) > equal_interval * step)
        return std::nullopt;
    const auto& period = test_.metadata.axis.expected_period;
    if (!period || period->in_native() <= 0.0)
      return note(
          "artefact-equal-steps",
          fmt::format("found the equal steps of the artefact (every {}): they do not show an error whose period "
                      "is a part of them; axis.expected_period is not known",
                      mm(step)));
    const double periods = step / period->in_native();
    constexpr double near = 0.02;  // share of a period, for every step
    if (std::abs(periods - std::round(periods)) > near || periods < 0.5) return std::nullopt;
    return note("artefact-equal-steps",
                fmt::format("found steps of the artefact (every {}) that hold {:.0f} whole period{} of {}: a periodic "
                            "error is the same at all of them and does not show",
                            mm(step), periods, std::round(periods) == 1.0 ? "" : "s", mm(period->in_native())));
  }

  const Test& test_;
  const Artefact& artefact_;
  std::span<const Position> targets_;
};

}  // namespace

bool is_artefact_test(const Test& test) {
  const auto& corrections = test.provenance.corrections;
  return std::ranges::find(corrections, artefact_correction, &AppliedCorrection::id) != corrections.end();
}

bool artefact_takes_place_of_device(const Metadata& metadata) {
  const Artefact& artefact = metadata.artefact;
  return metadata.axis.kind == AxisKind::linear &&
         (!artefact.calibrated_positions.empty() || artefact.calibration_uncertainty ||
          artefact.calibration_uncertainty_per_length || artefact.probing_uncertainty);
}

Result<Test> apply_artefact(Test test) {
  if (is_artefact_test(test))
    return fail("found an artefact test whose deviations are already made, expected readings");
  AXIOMETRY_TRY_VOID(check_positions(test));
  AXIOMETRY_TRY(const std::optional<ArtefactTemperature> temperature, temperature_of(test.metadata));
  const std::vector<Position> targets(test.series.targets().begin(), test.series.targets().end());
  const std::vector<double> calibrated = test.metadata.artefact.calibrated_positions;
  AppliedCorrection record = record_of(test, temperature);
  AXIOMETRY_TRY(ChangedTest changed, change_readings(std::move(test), [&](const ReadingAt& reading) {
                  const auto i = static_cast<std::size_t>(
                      std::ranges::lower_bound(targets, Position::native(reading.target)) - targets.begin());
                  const double nominal = targets[i].in_native() - targets[0].in_native();
                  const double distance = calibrated[i] - calibrated[0];
                  const double strain = temperature ? temperature->strain(reading.share) : 0.0;
                  const double deviation = ((distance - nominal) + distance * strain) * um_per_mm - reading.deviation;
                  // Four positions and three operations, each half an ulp of the largest of them; twice that.
                  const double magnitude =
                      (std::abs(calibrated[i]) + std::abs(calibrated[0]) + std::abs(nominal)) * um_per_mm;
                  return (strain == 0.0 ? nearest_decimal(deviation, 4.0 * unit_roundoff * magnitude) : deviation) -
                         reading.deviation;
                }));
  record.smallest = changed.smallest;
  record.largest = changed.largest;
  test = std::move(changed.test);
  test.provenance.corrections.push_back(std::move(record));
  return test;
}

std::vector<Finding> artefact_findings(const Test& test) {
  if (is_artefact_test(test)) return Rules(test)();
  if (test.metadata.artefact.calibrated_positions.empty()) return {};
  return {{"artefact-not-used", "Annex D", Severity::note,
           "found calibrated positions of an artefact that were not used: the readings were taken for deviations"}};
}

}  // namespace axiometry::iso230_2
