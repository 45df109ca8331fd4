// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the source: ISO 230-2 leaves the correction of readings to the instrument's maker; see
// docs/theory/reading-corrections.md.
#include "axiometry/standards/readings/reading_correction.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/standards/readings/drift.h"
#include "axiometry/standards/readings/nde_correction.h"
#include "axiometry/standards/readings/reading_change.h"
#include "axiometry/standards/readings/test_air.h"
#include "axiometry/standards/readings/test_course.h"

namespace axiometry {
namespace {

std::string datum_text(const Test& test) {
  return format_exact(datum_of(test).in_native()) + (test.metadata.axis.kind == AxisKind::linear ? " mm" : "°");
}

Result<Test> applied(Test test, AppliedCorrection record, const ReadingChange& change) {
  AXIOMETRY_TRY(ChangedTest changed, change_readings(std::move(test), change));
  record.smallest = changed.smallest;
  record.largest = changed.largest;
  changed.test.provenance.corrections.push_back(std::move(record));
  return std::move(changed.test);
}

/// Slope of the displayed positions over the targets: near 1, or near −1 for a sensor that counts the other way.
double slope_of_displayed(const Test& test) {
  const Series& series = test.series;
  const double per_position = deviation_per_position(test.metadata.axis.kind);
  const double middle = 0.5 * (series.targets().front().in_native() + series.targets().back().in_native());
  double count = 0.0, sum_p = 0.0, sum_d = 0.0, sum_pp = 0.0, sum_pd = 0.0;
  for (Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < series.target_count(); ++i)
      for (const double x : series.cell(i, direction)) {
        if (std::isnan(x)) continue;
        const double p = series.targets()[i].in_native() - middle;
        const double displayed = p + x / per_position;
        count += 1.0;
        sum_p += p;
        sum_d += displayed;
        sum_pp += p * p;
        sum_pd += p * displayed;
      }
  return (sum_pd - sum_p * sum_d / count) / (sum_pp - sum_p * sum_p / count);
}

Result<Test> correct_sign(Test test) {
  if (test.metadata.instrument.sign_reversed == false)
    return fail("found instrument.sign_reversed = no, expected an instrument whose sign is reversed");
  const double slope = slope_of_displayed(test);
  if (!(std::abs(slope) > 0.5))  // ±1 but for the errors of the axis
    return fail(
        "found displayed positions that neither rise nor fall as the targets do, expected one to reverse a sign");
  AppliedCorrection record{"sign", "Sign of the readings", {}, {}, {}};
  if (slope > 0.0) {
    record.details = {{"What was reversed", "the deviations; displayed positions rise with the targets"}};
    return applied(std::move(test), std::move(record), [](const ReadingAt& r) { return -2.0 * r.deviation; });
  }
  record.details = {{"What was reversed", "the displayed positions, which fall as the targets rise"},
                    {"Datum", datum_text(test)}};
  return applied(std::move(test), std::move(record), [](const ReadingAt& r) { return -2.0 * r.length; });
}

Result<Test> correct_gain(Test test) {
  const auto gain = test.metadata.instrument.gain;
  if (!gain) return fail("found no gain of the sensor to correct with, expected instrument.gain");
  if (*gain == 0.0 || !std::isfinite(*gain))
    return fail(fmt::format("found instrument.gain = {}, expected a number other than 0", *gain));
  AppliedCorrection record{
      "gain", "Gain of the sensor", {{"Gain", format_exact(*gain)}, {"Datum", datum_text(test)}}, {}, {}};
  return applied(std::move(test), std::move(record),
                 [factor = *gain - 1.0](const ReadingAt& r) { return factor * r.length; });
}

/// What the corrections for the air share: the air of the test, and where it is looked at.
Result<TestAir> air_for(const Test& test, std::string_view id, AirEquation equation, std::vector<std::string> missing) {
  if (test.metadata.axis.kind == AxisKind::rotary)
    return fail(fmt::format("found a rotary axis, expected a linear one to correct readings for {}",
                            id == "air" ? "the air" : "the dead path"));
  if (was_corrected(test, id))
    return fail(fmt::format("found readings that are already corrected ({}), expected each correction once", id));
  std::ranges::copy(missing_for_air(test.metadata), std::back_inserter(missing));
  if (!missing.empty())
    return fail(fmt::format("found too little for the correction {}, expected also {}", id, fmt::join(missing, ", ")));
  return TestAir::make(test.metadata, equation);
}

Result<Test> correct_air(Test test, AirEquation equation) {
  const auto assumed = test.metadata.instrument.refractive_index;
  std::vector<std::string> missing;
  if (!assumed) missing.emplace_back("instrument.refractive_index (1 when lengths in vacuum are shown)");
  AXIOMETRY_TRY(const TestAir air, air_for(test, "air", equation, std::move(missing)));
  AppliedCorrection record{"air", "Refractive index of air", air.details(), {}, {}};
  record.details.push_back({"Index assumed by the instrument", format_exact(*assumed)});
  record.details.push_back({"Datum", datum_text(test)});
  record.details.push_back({"Course of the test", course_of(test).basis});
  return applied(std::move(test), std::move(record), [&air, r0 = *assumed - 1.0](const ReadingAt& reading) {
    const double r = air.refractivity(reading.share);
    return reading.length * (r0 - r) / (1.0 + r);  // D n_0/n − D
  });
}

Result<Test> correct_dead_path(Test test, AirEquation equation) {
  const auto dead_path = test.metadata.instrument.dead_path;
  std::vector<std::string> missing;
  if (!dead_path) missing.emplace_back("instrument.dead_path_mm");
  AXIOMETRY_TRY(const TestAir air, air_for(test, "dead-path", equation, std::move(missing)));
  AppliedCorrection record{"dead-path", "Dead path", {}, {}, {}};
  record.details = {{"Dead path", format_exact(dead_path->in_mm()) + " mm, beam longer at higher positions"}};
  if (dead_path->in_mm() < 0.0)
    record.details = {{"Dead path", format_exact(-dead_path->in_mm()) + " mm, beam shorter at higher positions"}};
  std::ranges::move(air.details(), std::back_inserter(record.details));
  record.details.push_back({"Course of the test", course_of(test).basis});
  const double at_start = air.refractivity(0.0);
  return applied(std::move(test), std::move(record),
                 [&air, at_start, length = dead_path->in_um()](const ReadingAt& reading) {
                   const double r = air.refractivity(reading.share);
                   return -length * (r - at_start) / (1.0 + r);
                 });
}

Result<Test> correct_drift(Test test) {
  const auto drift = drift_of(test);
  if (!course_of(test).order_known)
    return fail(
        "found neither the times of the readings nor a cycle that tells their order, expected one of them to "
        "estimate a drift");
  if (!drift)
    return fail("found no target with two readings from one direction, expected n of 2 or more to estimate a drift");
  const std::string_view unit = deviation_unit(test.metadata.axis.kind);
  const auto shown = [&](double x, std::string_view per) { return fmt::format("{:.4g} {}{}", x, unit, per); };
  AppliedCorrection record{"drift", "Drift", {}, {}, {}};
  record.details = {{"Drift over the test", shown(drift->over_test.in_native(), "")}};
  if (const auto rate = drift->per_hour(drift->over_test)) record.details.push_back({"Drift", shown(*rate, "/h")});
  if (drift->u) record.details.push_back({"Standard uncertainty over the test", shown(drift->u->in_native(), "")});
  record.details.push_back(
      {"Estimate", "least squares of a straight line in time, a constant per target and direction"});
  record.details.push_back({"Course of the test", drift->course.basis});
  return applied(std::move(test), std::move(record),
                 [b = drift->over_test.in_native()](const ReadingAt& r) { return -b * r.share; });
}

}  // namespace

bool was_corrected(const Test& test, std::string_view id) {
  const auto& done = test.provenance.corrections;
  return std::ranges::any_of(done, [&](const AppliedCorrection& correction) { return correction.id == id; });
}

Result<Test> correct_readings(Test test, const CorrectionRequest& request) {
  const AirEquation equation = request.air.value_or(AirEquation::ciddor);
  if (request.sign) {
    AXIOMETRY_TRY(test, correct_sign(std::move(test)));
  }
  if (request.gain) {
    AXIOMETRY_TRY(test, correct_gain(std::move(test)));
  }
  if (request.air) {
    AXIOMETRY_TRY(test, correct_air(std::move(test), equation));
  }
  if (request.dead_path) {
    AXIOMETRY_TRY(test, correct_dead_path(std::move(test), equation));
  }
  if (request.expansion) {
    AXIOMETRY_TRY(test, correct_expansion(std::move(test)));
  }
  if (request.drift) {
    AXIOMETRY_TRY(test, correct_drift(std::move(test)));
  }
  return test;
}

std::vector<SourceRemark> remarks_on_readings(const Test& test) {
  const InstrumentSettings& instrument = test.metadata.instrument;
  std::vector<SourceRemark> remarks;
  if (instrument.sign_reversed == true && !was_corrected(test, "sign"))
    remarks.push_back(
        {false, "the sign of the instrument is said to be reversed, and its readings were taken as they are"});
  if (instrument.gain && *instrument.gain != 1.0 && !was_corrected(test, "gain"))
    remarks.push_back(
        {false, fmt::format("a gain of {} of the sensor was given, and its readings were taken as they are",
                            format_exact(*instrument.gain))});
  if (was_corrected(test, "drift"))
    remarks.push_back({false,
                       "a drift was taken out that was estimated from the readings themselves: what the machine "
                       "does while it warms up is gone with it"});
  const auto of_scale = [](const InputDistribution& d) { return d.input.starts_with("scale:"); };
  if (was_corrected(test, "air") && std::ranges::none_of(test.metadata.gum.distributions, of_scale))
    remarks.push_back({false,
                       "readings were corrected by a measured temperature, pressure and humidity of the air, whose "
                       "uncertainty U holds only as far as that of the measuring device was stated with it: 0.2 °C, "
                       "0.1 kPa and 10 % are about 0.19, 0.27 and 0.09 µm per metre"});
  return remarks;
}

}  // namespace axiometry
