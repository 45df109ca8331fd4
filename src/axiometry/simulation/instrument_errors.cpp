// SPDX-License-Identifier: Apache-2.0
#include "axiometry/simulation/instrument_errors.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "axiometry/simulation/elementary.h"

namespace axiometry::simulation {
namespace {

constexpr double steps_max = 1e7;
constexpr double drift_step_s = 1.0;
constexpr double reference_celsius = 20.0;  // ISO 1

std::vector<double> uniform(std::uint64_t seed, Stream stream, std::size_t count) {
  std::vector<double> numbers(count);
  numeric::fill_uniform({seed, stream, 0}, numbers);
  return numbers;
}

}  // namespace

Result<InstrumentErrors> InstrumentErrors::make(const VirtualInstrument& instrument, const Plan& plan,
                                                const Timeline& timeline, std::uint64_t seed) {
  const double air_step = instrument.air.random_time.in_s() / nodes_per_correlation;
  const bool drifts = instrument.drift_per_root_hour.in_native() > 0.0;
  const bool turbulent = instrument.air.random.in_um_per_m() > 0.0;
  const double steps =
      std::max(drifts ? timeline.duration() / drift_step_s : 0.0, turbulent ? timeline.duration() / air_step : 0.0);
  if (steps > steps_max)
    return fail(fmt::format("found a test of {:.0f} s, {:.0f} steps of a random error, expected at most {:.0f}",
                            timeline.duration(), steps, steps_max));
  InstrumentErrors errors(instrument, plan, timeline.legs(), seed);
  if (drifts) errors.drift_ = SlowProcess::walk({seed, stream_drift, 0}, {0.0, timeline.duration(), drift_step_s});
  if (turbulent)
    errors.air_random_ = SlowProcess::stationary({seed, stream_air, 0}, {0.0, timeline.duration(), air_step},
                                                 exponential(-1.0 / nodes_per_correlation));
  return errors;
}

InstrumentErrors::InstrumentErrors(const VirtualInstrument& instrument, const Plan& plan, std::span<const Leg> legs,
                                   std::uint64_t seed)
    : instrument_(&instrument),
      legs_(legs),
      per_position_(deviation_per_position(plan.axis.kind)),
      first_(plan.targets.front().in_native()),
      air_(instrument.air.slow.in_um_per_m() > 0.0 || instrument.air.random.in_um_per_m() > 0.0),
      slipped_(legs.size()),
      outlier_(legs.size()) {
  std::array<double, 2> phases;
  numeric::fill_uniform({seed, stream_phases, 0}, phases);
  air_phase_ = phases[0];
  vibration_phase_ = phases[1];
  if (const auto& e = instrument.expansion)
    expansion_ = 1e-6 * (e->machine_expansion.in_um_per_m_K() - e->assumed_expansion.in_um_per_m_K()) *
                 (e->machine.in_celsius() - reference_celsius);

  const std::vector<double> slips = uniform(seed, stream_slip, legs.size());
  std::vector<double> sizes(legs.size());
  numeric::fill_normal({seed, stream_slip_size, 0}, sizes);
  double slipped = 0.0;
  for (std::size_t k = 0; k < legs.size(); ++k) {
    if (slips[k] < instrument.slip_probability) slipped += instrument.slip_size.in_native() * sizes[k];
    slipped_[k] = slipped;
  }
  const std::vector<double> outliers = uniform(seed, stream_outlier, legs.size());
  const std::vector<double> amounts = uniform(seed, stream_outlier_size, legs.size());
  for (std::size_t k = 0; k < legs.size(); ++k) {
    if (!legs[k].approach || outliers[k] >= instrument.outlier_probability) continue;
    const double u = 2.0 * amounts[k];  // its whole part is the sign, the rest the size
    outlier_[k] = (u < 1.0 ? -1.0 : 1.0) * instrument.outlier_size.in_native() * (0.5 + u - std::floor(u));
  }
}

double InstrumentErrors::at(std::size_t leg, double p, double t) const {
  const VirtualInstrument& i = *instrument_;
  double d = slipped_[leg] + (t >= legs_[leg].arrive ? outlier_[leg] : 0.0);
  d += expansion_ * (p - first_) * per_position_;
  if (i.drift_per_root_hour.in_native() > 0.0) d += i.drift_per_root_hour.in_native() / 60.0 * drift_.at(t);
  if (i.vibration.in_native() > 0.0)
    d += i.vibration.in_native() * wave(t / i.vibration_period.in_s() + vibration_phase_).sine;
  if (air_) {
    const double relative = i.air.slow.in_um_per_m() * wave(t / i.air.slow_period.in_s() + air_phase_).sine +
                            i.air.random.in_um_per_m() * air_random_.at(t);
    d += relative * 1e-6 * (p - first_ + i.air.dead_path.in_native()) * per_position_;
  }
  return d;
}

double InstrumentErrors::shown(double p, double deviation) const {
  const double step = instrument_->resolution.in_native();
  if (step == 0.0) return deviation;
  const double at = p * per_position_;
  return std::nearbyint((at + deviation) / step) * step - at;
}

}  // namespace axiometry::simulation
