// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/inputs/uncorrected_effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/standards/iso230_2/inputs/resolved_inputs.h"
#include "axiometry/standards/readings/artefact.h"
#include "axiometry/standards/readings/reading_change.h"
#include "axiometry/standards/readings/reading_correction.h"
#include "axiometry/standards/readings/station_offset.h"
#include "axiometry/standards/readings/test_air.h"
#include "axiometry/standards/readings/usual_expansion.h"

namespace axiometry::iso230_2 {
namespace {

constexpr double negligible_um = 0.005;
constexpr double metres_per_mm = 1e-3;

/// From the least to the largest of what several thermometers say: their mean could hide what each of them shows.
struct Extent {
  double low = 0.0;
  double high = 0.0;

  double farthest() const { return std::max(std::abs(low), std::abs(high)); }
  void see(double x) { *this = {std::min(low, x), std::max(high, x)}; }
};

Extent operator-(const Extent& a, const Extent& b) { return {a.low - b.high, a.high - b.low}; }

/// A relative error of lengths, µm/m.
struct Strain {
  Extent start, end;  ///< strain at the start and the end of the test
  Extent change;      ///< how far it changes from start to end

  static Strain of(double start, double end) { return {{start, start}, {end, end}, {end - start, end - start}}; }
  void see(const Strain& other) {
    for (const auto extent : {&Strain::start, &Strain::end, &Strain::change})
      for (const double x : {(other.*extent).low, (other.*extent).high}) (this->*extent).see(x);
  }
  double largest() const { return std::max(start.farthest(), end.farthest()); }
  double largest_change() const { return change.farthest(); }
};

Strain operator-(const Strain& a, const Strain& b) { return {a.start - b.start, a.end - b.end, a.change - b.change}; }

/// The lengths that a strain acts on, mm.
struct Lengths {
  double travel = 0.0;
  double farthest = 0.0;  ///< largest distance from the position where the instrument was set to zero
};

Lengths lengths_of(const Test& test) {
  const double datum = datum_of(test).in_native();
  const auto targets = test.series.targets();
  return {test.series.travel_native(),
          std::max(std::abs(targets.front().in_native() - datum), std::abs(targets.back().in_native() - datum))};
}

/// α ΔT of the thermometers of a role; nothing where none was read. A sensor read only once counts as constant.
std::optional<Strain> strain_of_sensors(double alpha, const Environment& environment, std::string_view role) {
  std::optional<Strain> found;
  for (const TemperatureSensor& sensor : environment.sensors) {
    if (!text::equal_ignoring_case(sensor.role, role) || !(sensor.start || sensor.end)) continue;
    const double start = (sensor.start ? *sensor.start : *sensor.end).in_celsius() - reference_temperature;
    const double end = (sensor.end ? *sensor.end : *sensor.start).in_celsius() - reference_temperature;
    const Strain own = Strain::of(alpha * start, alpha * end);
    if (found)
      found->see(own);
    else
      found = own;
  }
  return found;
}

std::optional<Strain> strain_of_air(double alpha, const Environment& environment) {
  const auto& start =
      environment.air_temperature_start ? environment.air_temperature_start : environment.air_temperature_end;
  if (!start) return strain_of_sensors(alpha, environment, "air");
  const auto difference = [&](Temperature t) { return alpha * (t.in_celsius() - reference_temperature); };
  return Strain::of(difference(*start), difference(environment.air_temperature_end.value_or(*start)));
}

/// α ΔT of the machine: of its own thermometers, else of whatever else was measured near it, and of a ΔT that was
/// stated where that is larger. Nothing while all of it lies within the range R(θ) that the uncertainty contains.
Strain machine_strain(const Metadata& metadata, double alpha) {
  const Environment& environment = metadata.environment;
  std::optional<Strain> found;
  for (const std::string_view role : {"machine", "equipment"})
    if (!found) found = strain_of_sensors(alpha, environment, role);
  if (!found) found = strain_of_air(alpha, environment);
  Strain strain = found.value_or(Strain{});
  if (const auto& stated = metadata.uncertainty.machine_temperature_difference) {
    const double stated_strain = alpha * stated->in_kelvin();
    if (std::abs(stated_strain) > strain.largest()) strain = Strain::of(stated_strain, stated_strain);
  }
  const auto& range = metadata.uncertainty.machine_temperature_range;
  const double inside = range ? 0.5 * std::abs(alpha) * range->in_kelvin() * (1.0 + 1e-9) : 0.0;
  return strain.largest() <= inside ? Strain{} : strain;
}

/// Machine less equipment: 4.1 allows the correction to happen by itself where both expand alike.
Strain strain_of_test(const Test& test) {
  const Metadata& metadata = test.metadata;
  const Strain strain = machine_strain(metadata, machine_expansion(metadata));
  const auto& alpha_equipment = metadata.nde.equipment_expansion;
  if (!alpha_equipment || is_artefact_test(test)) return strain;
  const auto own = strain_of_sensors(alpha_equipment->in_um_per_m_K(), metadata.environment, "equipment");
  return own ? strain - *own : strain;
}

class EffectCollector {
 public:
  explicit EffectCollector(const Test& test) : test_(test), linear_(test.metadata.axis.kind == AxisKind::linear) {}

  std::vector<UncorrectedEffect> all() && {
    if (linear_) {
      if (test_.metadata.nde.applied == true)
        other_coefficient();
      else
        expansion();
      air();
      dead_path();
    }
    gain();
    sign();
    station();
    return std::move(effects_);
  }

 private:
  void add(std::string key, std::string what, std::optional<double> on_lengths, std::optional<double> on_repeats,
           std::string remedy, Remedy by) {
    const auto small = [](const std::optional<double>& size) { return size && std::abs(*size) < negligible_um; };
    if (small(on_lengths) && small(on_repeats)) return;
    const auto size = [](const std::optional<double>& x) {
      return x ? std::optional(Deviation::native(*x)) : std::nullopt;
    };
    effects_.push_back(
        {std::move(key), std::move(what), size(on_lengths), size(on_repeats), std::move(remedy), std::move(by)});
  }

  void expansion() {
    const Strain strain = strain_of_test(test_);
    const Lengths lengths = lengths_of(test_);
    const double on_lengths = strain.largest() * lengths.travel * metres_per_mm;
    const bool unsaid = !test_.metadata.nde.applied;
    add("expansion",
        fmt::format("thermal expansion, about {:.1f} µm over the travel{}", on_lengths,
                    unsaid ? ", of which nobody said whether it was corrected," : ","),
        on_lengths, strain.largest_change() * lengths.farthest * metres_per_mm,
        unsaid ? "the correction for thermal expansion, or nde.applied = yes where the instrument has made it,"
               : "the correction for thermal expansion",
        {{"nde"}, unsaid ? std::vector<std::string>{"nde.applied"} : std::vector<std::string>{}});
  }

  /// The correction was made with another coefficient than the machine is said to have: by the inputs of the
  /// uncertainty, by its scale, or, where it was 0, by what machines usually have.
  void other_coefficient() {
    const Metadata& metadata = test_.metadata;
    const auto& corrected_with = metadata.nde.machine_expansion;
    if (!corrected_with) return;
    const double taken = corrected_with->in_um_per_m_K();
    double left = taken == 0.0 ? expansion_usual : 0.0;
    for (const auto& stated : {metadata.uncertainty.machine_expansion, metadata.axis.scale_expansion})
      if (const double own = stated ? stated->in_um_per_m_K() - taken : 0.0; std::abs(own) > std::abs(left)) left = own;
    const auto& range = metadata.uncertainty.machine_expansion_range;
    const double inside = 0.5 * (range ? range->in_um_per_m_K() : expansion_range_usual) * (1.0 + 1e-9);
    if (std::abs(left) <= inside) return;
    const Strain strain = machine_strain(metadata, left);
    const Lengths lengths = lengths_of(test_);
    const double on_lengths = strain.largest() * lengths.travel * metres_per_mm;
    add("expansion-coefficient",
        fmt::format("a correction for expansion with {} µm/(m·°C), which is not the coefficient of the machine, about "
                    "{:.1f} µm over the travel,",
                    format_exact(taken), on_lengths),
        on_lengths, strain.largest_change() * lengths.farthest * metres_per_mm, "one coefficient for both",
        {{}, {"nde.machine_expansion_um_per_m_C", "uncertainty.machine_expansion_um_per_m_C"}});
  }

  void air() {
    const auto assumed = test_.metadata.instrument.refractive_index;
    if (!assumed || was_corrected(test_, "air")) return;
    const Lengths lengths = lengths_of(test_);
    const auto index = test_air();
    if (!index) {
      add("air", "the index of refraction of an air that was not measured", std::nullopt, std::nullopt,
          "the correction for the air after Ciddor, with temperature, pressure and humidity of the air,",
          {{"air=ciddor"}, missing_for_air(test_.metadata)});
      return;
    }
    const auto error = [&](double share) { return 1e6 * ((*assumed - 1.0) - index->refractivity(share)); };
    const Strain strain = Strain::of(error(0.0), error(1.0));
    const double on_lengths = strain.largest() * lengths.travel * metres_per_mm;
    add("air", fmt::format("the index of refraction of the air, about {:.1f} µm over the travel,", on_lengths),
        on_lengths, strain.largest_change() * lengths.farthest * metres_per_mm,
        "the correction for the air after Ciddor", {{"air=ciddor"}, {}});
  }

  void dead_path() {
    const auto length = test_.metadata.instrument.dead_path;
    if (!length || length->in_mm() == 0.0 || was_corrected(test_, "dead-path")) return;
    const auto index = test_air();
    if (!index) {
      add("dead-path", "a dead path in an air that was not measured", std::nullopt, std::nullopt,
          "the correction of the dead path, with temperature, pressure and humidity of the air,",
          {{"dead-path"}, missing_for_air(test_.metadata)});
      return;
    }
    const double size = std::abs(length->in_um() * (index->refractivity(1.0) - index->refractivity(0.0)));
    add("dead-path", fmt::format("a dead path, about {:.2g} µm in the course of the test,", size), size, size,
        "the correction of the dead path", {{"dead-path"}, {}});
  }

  void gain() {
    const auto gain = test_.metadata.instrument.gain;
    if (!gain || *gain == 1.0 || was_corrected(test_, "gain")) return;
    const double on_lengths =
        std::abs(*gain - 1.0) * lengths_of(test_).travel * deviation_per_position(test_.metadata.axis.kind);
    add("gain", fmt::format("a gain of {} of the sensor", format_exact(*gain)), on_lengths, on_lengths,
        "the correction of the gain", {{"gain"}, {}});
  }

  void sign() {
    if (test_.metadata.instrument.sign_reversed != true || was_corrected(test_, "sign")) return;
    add("sign", "the reversed sign of the instrument", std::nullopt, std::nullopt, "the correction of the sign",
        {{"sign"}, {}});
  }

  void station() {
    const std::string problem = station_offset_problem(test_.metadata);
    if (problem.empty()) return;
    add("station", fmt::format("the station of the tracking interferometer ({})", problem), std::nullopt, 0.0,
        "tracking.station_position with tracking.station_uncertainty_mm",
        {{}, {"tracking.station_position", "tracking.station_uncertainty_mm"}});
  }

  std::optional<TestAir> test_air() const {
    if (!missing_for_air(test_.metadata).empty()) return std::nullopt;
    auto air = TestAir::make(test_.metadata, AirEquation::ciddor);
    return air ? std::optional(*std::move(air)) : std::nullopt;
  }

  const Test& test_;
  bool linear_;
  std::vector<UncorrectedEffect> effects_;
};

/// Whether a parameter follows from differences along the axis, and not from one target alone.
bool depends_on_lengths(const ParameterInfo& parameter) {
  return parameter.key.front() == 'A' || parameter.key.front() == 'E' || parameter.key.front() == 'M';
}

}  // namespace

std::optional<Deviation> UncorrectedEffect::on(const ParameterInfo& parameter) const {
  if (!depends_on_lengths(parameter)) return on_repeats;
  if (!on_lengths || !on_repeats) return std::nullopt;
  return Deviation::native(std::max(on_lengths->in_native(), on_repeats->in_native()));
}

std::string UncorrectedEffect::reason() const {
  return fmt::format("{} is neither corrected nor in the uncertainty; {} mends that", what, remedy);
}

std::vector<UncorrectedEffect> uncorrected_effects(const Test& test) { return EffectCollector(test).all(); }

}  // namespace axiometry::iso230_2
