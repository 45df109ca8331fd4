// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the source: α, ΔT, R(θ) and R(α) follow Annex A's defaults where the paper has none; the
// alignment may come from Annex A's misalignment over L; noise of single readings and runs is not in the paper.
#include "axiometry/standards/iso230_2_inputs_items.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "axiometry/base/contract.h"
#include "axiometry/standards/iso230_2_artefact.h"
#include "axiometry/standards/station_offset.h"
#include "axiometry/standards/usual_expansion.h"

namespace axiometry::iso230_2 {
namespace {

using uncertainty::Distribution;
using uncertainty::Normal;
using uncertainty::Uniform;

constexpr double absurd_scale = 1e9;  // µm/m, a device that knows nothing

constexpr std::array catalogue = {
    KnownInput{"machine_expansion", "α", "Expansion coefficient of the machine", "17, A.7", Effect::machine_expansion,
               "µm/(m·°C)", ""},
    KnownInput{"machine_temperature", "ΔT", "Temperature of the machine, less 20 °C", "16, A.5",
               Effect::machine_temperature, "°C", ""},
    KnownInput{"device_expansion", "α_D", "Expansion coefficient of the measuring device", "A.8",
               Effect::device_expansion, "µm/(m·°C)", ""},
    KnownInput{"device_temperature", "ΔT_D", "Temperature of the measuring device, less 20 °C", "A.6",
               Effect::device_temperature, "°C", ""},
    KnownInput{"alignment", "θ", "Misalignment of the measuring device", "18, A.4", Effect::alignment, "°", ""},
    KnownInput{"station", "Δ₁", "Station beside the line, larger component", "Lee et al. 19", Effect::station, "mm",
               ""},
    KnownInput{"station_smaller", "Δ₂", "Station beside the line, smaller component", "Lee et al. 19", Effect::station,
               "mm", ""},
    KnownInput{"device", "c_c", "Calibration of the measuring device", "23, A.1 to A.3", Effect::scale, "µm/m", "″"},
    KnownInput{"artefact_calibration", "c_a", "Calibration of the artefact", "Annex D, A.1", Effect::target, "µm", ""},
    KnownInput{"artefact_calibration_length", "c_al", "Calibration of the artefact, by length", "Annex D, A.2",
               Effect::scale, "µm/m", ""},
    KnownInput{"probing", "c_p", "Probing of the artefact", "Annex D", Effect::target_direction, "µm", ""},
    KnownInput{"environment", "c_e", "Instrument away from standard conditions", "24", Effect::scale, "µm/m", ""},
    KnownInput{"axis_resolution", "c_r", "Resolution of the axis", "22", Effect::target, "µm", "″"},
    KnownInput{"instrument_resolution", "c_sr", "Resolution of the measuring instrument", "23", Effect::target, "µm",
               "″"},
    KnownInput{"environmental_variation", "E_VE", "Environmental variation of a reading", "A.9", Effect::reading, "µm",
               "″"},
    KnownInput{"run_drift", "d", "Drift from run to run", "", Effect::run, "µm", "″"},
};

Distribution valid(Distribution::Form form) {
  auto distribution = Distribution::make(std::move(form));
  AXIOMETRY_CONTRACT(distribution.has_value());
  return *std::move(distribution);
}
Distribution uniform_about(double centre, double width) {
  return valid(Uniform{centre - width / 2.0, centre + width / 2.0});
}

/// A number with where it came from when nobody gave it.
struct Sourced {
  double value = 0.0;
  std::string note;
};

std::optional<Sourced> sourced(const std::optional<ExpansionCoefficient>& x, std::string note) {
  return x ? std::optional(Sourced{x->in_um_per_m_K(), std::move(note)}) : std::nullopt;
}

/// The largest departure from 20 °C that sensors of this role have shown, with its sign.
std::optional<Sourced> sourced_from_sensors(const Environment& environment, std::string_view role) {
  const auto largest = largest_sensor_difference(environment, role);
  return largest ? std::optional(Sourced{*largest, "largest of the sensors"}) : std::nullopt;
}

/// What is known about the expansion of the machine or of the device.
struct ThermalItems {
  std::string key;
  std::string whose;
  std::optional<Sourced> alpha;
  std::optional<Sourced> difference;
  std::optional<double> temperature_range;  // R(θ)
  std::optional<double> alpha_range;        // R(α)
};

std::optional<Sourced> difference_of(const std::optional<TemperatureDifference>& given, const Environment& environment,
                                     std::string_view role) {
  return given ? std::optional(Sourced{given->in_kelvin(), ""}) : sourced_from_sensors(environment, role);
}

ThermalItems machine_items(const Metadata& metadata) {
  const AnnexAInputs& annex = metadata.uncertainty;
  ThermalItems items{"machine", "machine", {}, {}, {}, {}};
  const auto of_the_correction = sourced(metadata.nde.machine_expansion, "of the NDE correction");
  if (metadata.nde.applied == true) items.alpha = of_the_correction;
  for (const auto& other :
       {sourced(annex.machine_expansion, ""), sourced(metadata.axis.scale_expansion, "of the scale"), of_the_correction,
        std::optional(Sourced{expansion_usual, "assumed"})})
    if (!items.alpha) items.alpha = other;
  items.difference = difference_of(annex.machine_temperature_difference, metadata.environment, "machine");
  if (annex.machine_temperature_range) items.temperature_range = annex.machine_temperature_range->in_kelvin();
  if (annex.machine_expansion_range) items.alpha_range = annex.machine_expansion_range->in_um_per_m_K();
  return items;
}

ThermalItems device_items(const Metadata& metadata) {
  const AnnexAInputs& annex = metadata.uncertainty;
  ThermalItems items{"device", "measuring device", {}, {}, {}, {}};
  items.alpha = sourced(annex.device_expansion, "");
  if (!items.alpha) items.alpha = sourced(metadata.nde.equipment_expansion, "of the NDE correction");
  items.difference = difference_of(annex.device_temperature_difference, metadata.environment, "equipment");
  if (annex.device_temperature_range) items.temperature_range = annex.device_temperature_range->in_kelvin();
  if (annex.device_expansion_range) items.alpha_range = annex.device_expansion_range->in_um_per_m_K();
  return items;
}

/// What an artefact is made of expands in any case; what is said of an interferometer often includes it.
bool device_has_temperature(const Metadata& metadata) {
  const AnnexAInputs& annex = metadata.uncertainty;
  if (annex.device_temperature_range || annex.device_temperature_difference || annex.device_expansion_range)
    return true;
  const auto items = device_items(metadata);
  return artefact_takes_place_of_device(metadata) && items.alpha && items.alpha->value != 0.0 && items.difference;
}

/// What stands for the measuring device is an artefact.
std::string_view title_with_artefact(std::string_view key) {
  if (key == "device_expansion") return "Expansion coefficient of the artefact";
  if (key == "device_temperature") return "Temperature of the artefact, less 20 °C";
  if (key == "alignment") return "Misalignment of the artefact";
  return "";
}

/// Whether somebody asked for an uncertainty: sensors and coefficients alone are items of clause 8.1.
bool uncertainty_asked_for(const Metadata& metadata) {
  const AnnexAInputs& annex = metadata.uncertainty;
  const GumInputs& gum = metadata.gum;
  return annex.device_calibration || annex.device_calibration_per_length || annex.device_error_range ||
         annex.misalignment || annex.machine_expansion || annex.machine_temperature_range ||
         annex.machine_temperature_difference || annex.machine_expansion_range || device_has_temperature(metadata) ||
         metadata.artefact.calibration_uncertainty || metadata.artefact.calibration_uncertainty_per_length ||
         metadata.artefact.probing_uncertainty || annex.environmental_variation || gum.axis_resolution ||
         gum.instrument_resolution || gum.environment_sensitivity || gum.alignment_angle || gum.run_drift ||
         station_offset(metadata) || !gum.distributions.empty();
}

/// Adds to the inputs of one test.
class Collector {
 public:
  Collector(const Metadata& metadata, UncertaintyInputs inputs) : metadata_(metadata), result_(std::move(inputs)) {}

  void add(std::string_view key, Distribution distribution, std::string note = {}) {
    result_.inputs.push_back(
        make_input(*find_known_input(key), metadata_.axis.kind, std::move(distribution), std::move(note)));
    if (!artefact_takes_place_of_device(metadata_)) return;
    if (const std::string_view title = title_with_artefact(key); !title.empty()) result_.inputs.back().title = title;
  }
  void note(std::string text) { result_.notes.push_back(std::move(text)); }
  UncertaintyInputs take() && { return std::move(result_); }

  void add_thermal(ThermalItems items) {
    if (!items.temperature_range && !items.difference) {
      if (items.alpha_range)
        note(fmt::format("R(α) of the {} is left out because its temperature was not given", items.whose));
      return;
    }
    if (!items.alpha) {
      if (items.temperature_range)
        note(fmt::format("R(θ) of the {} is left out because its α was not given", items.whose));
      if (!items.difference) return;
      items.temperature_range.reset();
      items.alpha = Sourced{0.0, "not given"};
    }
    const std::string key = fmt::format("{}_temperature", items.key);
    if (!items.difference && !replaced(key))
      note(fmt::format("The temperature of the {} was not given; 20 °C ± R(θ)/2 is assumed, and α counts as known",
                       items.whose));
    if (!items.temperature_range && !replaced(key))
      note(fmt::format("R(θ) of the {} was not given; its temperature counts as known", items.whose));
    add_expansion(items, items.difference.has_value());
    const Sourced difference = items.difference.value_or(Sourced{0.0, "assumed"});
    add(key, uniform_about(difference.value, items.temperature_range.value_or(0.0)), difference.note);
  }

  void add_expansion(const ThermalItems& items, bool uncertain) {
    const std::string key = fmt::format("{}_expansion", items.key);
    if (items.alpha->note == "assumed" && !replaced(key))
      note(fmt::format("α of the {} was not given; 12 µm/(m·°C) is assumed (Table A.2)", items.whose));
    if (uncertain && !items.alpha_range && !replaced(key))
      note(fmt::format("R(α) of the {} was not given; 2 µm/(m·°C) is assumed (A.2.4.3)", items.whose));
    const double width = uncertain ? items.alpha_range.value_or(expansion_range_usual) : 0.0;
    add(key, uniform_about(items.alpha->value, width), items.alpha->note);
  }

  /// With the station of a tracking interferometer there is no misalignment.
  void add_station(const StationOffset& offset) {
    add("station", valid(Normal{0.0, offset.larger_mm}));
    if (offset.smaller_mm > 0.0) add("station_smaller", valid(Normal{0.0, offset.smaller_mm}));
    if (metadata_.gum.alignment_angle || metadata_.uncertainty.misalignment) note(std::string(followed_beam_note));
  }

  void add_alignment(double length_m) {
    if (metadata_.gum.alignment_angle) {
      add("alignment", uniform_about(0.0, 2.0 * metadata_.gum.alignment_angle->in_deg()));
    } else if (metadata_.uncertainty.misalignment) {
      const double angle = std::atan(metadata_.uncertainty.misalignment->in_mm() / (1000.0 * length_m));
      add("alignment", uniform_about(0.0, 2.0 * angle * 180.0 / std::numbers::pi), "from the misalignment over L");
    }
  }

  void add_environment() {
    const auto& K = metadata_.gum.environment_sensitivity;
    if (!K) return;
    const Environment& air = metadata_.environment;
    const auto start = air.air_temperature_start ? air.air_temperature_start : air.air_temperature_end;
    std::optional<Sourced> difference;
    if (start) {
      const double end = air.air_temperature_end.value_or(*start).in_celsius();
      difference = Sourced{(start->in_celsius() + end) / 2.0 - reference_temperature, "ΔT_e from the air temperature"};
    }
    if (metadata_.gum.environment_temperature_difference)
      difference = Sourced{metadata_.gum.environment_temperature_difference->in_kelvin(), ""};
    if (difference)
      add("environment", valid(Normal{0.0, std::abs(K->in_um_per_m_K() * difference->value)}), difference->note);
    else
      note("K of the instrument is left out because the air temperature was not given");
  }

  /// U of a certificate is normal with k = 2: a constant part at each place of the artefact for itself, a part in
  /// proportion to the length for all of them together. What probing does in the same way in every run.
  void add_artefact() {
    const Artefact& artefact = metadata_.artefact;
    if (const auto& U = artefact.calibration_uncertainty)
      add("artefact_calibration", valid(Normal{0.0, U->in_native() / 2.0}));
    if (const auto& U = artefact.calibration_uncertainty_per_length)
      add("artefact_calibration_length", valid(Normal{0.0, U->in_um_per_m() / 2.0}));
    if (const auto& U = artefact.probing_uncertainty) add("probing", valid(Normal{0.0, U->in_native() / 2.0}));
    const AnnexAInputs& annex = metadata_.uncertainty;
    if (annex.device_calibration || annex.device_calibration_per_length || annex.device_error_range)
      note("The artefact takes the place of the measuring device, whose calibration and error range are left out");
  }

  void add_device_linear(double length_m) {
    const AnnexAInputs& annex = metadata_.uncertainty;
    if (annex.device_calibration) {
      const double sd = annex.device_calibration->in_native() / 2.0 / length_m;
      if (sd <= absurd_scale)
        add("device", valid(Normal{0.0, sd}), "over L");
      else
        note(fmt::format("The calibration of the device is left out: at L = {} m it has no sensible value", length_m));
    } else if (annex.device_calibration_per_length) {
      add("device", valid(Normal{0.0, annex.device_calibration_per_length->in_um_per_m() / 2.0}));
    } else if (annex.device_error_range) {
      add("device", uniform_about(0.0, annex.device_error_range->in_um_per_m()));
    }
    if (annex.device_calibration.has_value() + annex.device_calibration_per_length.has_value() +
            annex.device_error_range.has_value() >
        1)
      note(fmt::format("Of several statements about the measuring device the calibration uncertainty in {} was taken",
                       annex.device_calibration ? "µm" : "µm/m"));
  }

  void add_device_rotary() {
    const auto& U = metadata_.uncertainty.device_calibration;
    if (!U) return;
    add("device", valid(Normal{0.0, U->in_native() / 2.0}));
    note("On a rotary axis the calibration of the device counts as independent from target to target");
  }

  void add_in_native_unit() {
    const auto width = [&](std::string_view key, const std::optional<Deviation>& range) {
      if (range) add(key, uniform_about(0.0, range->in_native()));
    };
    width("axis_resolution", metadata_.gum.axis_resolution);
    width("instrument_resolution", metadata_.gum.instrument_resolution);
    width("environmental_variation", metadata_.uncertainty.environmental_variation);
    if (metadata_.gum.run_drift) add("run_drift", valid(Normal{0.0, metadata_.gum.run_drift->in_native()}));
  }

  void complete_pair(const ThermalItems& items) {
    const auto has = [&](std::string_view what) {
      const std::string key = fmt::format("{}_{}", items.key, what);
      return std::ranges::find(result_.inputs, key, &UncertaintyInput::key) != result_.inputs.end();
    };
    const bool expansion = has("expansion");
    if (expansion == has("temperature")) return;
    if (!expansion) {
      ThermalItems known = items;
      if (!known.alpha) known.alpha = Sourced{expansion_usual, "assumed"};
      add_expansion(known, true);
    } else {
      add(fmt::format("{}_temperature", items.key), uniform_about(0.0, 0.0), "assumed");
      note(fmt::format("The temperature of the {} was not given; it counts as 20 °C exactly", items.whose));
    }
  }

 private:
  /// Nothing is assumed where a distribution is given.
  bool replaced(std::string_view key) const {
    return std::ranges::find(metadata_.gum.distributions, key, &InputDistribution::input) !=
           metadata_.gum.distributions.end();
  }

  const Metadata& metadata_;
  UncertaintyInputs result_;
};

}  // namespace

std::span<const KnownInput> known_inputs() { return catalogue; }

const KnownInput* find_known_input(std::string_view key) {
  const auto found = std::ranges::find(catalogue, key, &KnownInput::key);
  return found == catalogue.end() ? nullptr : &*found;
}

UncertaintyInput make_input(const KnownInput& known, AxisKind kind, Distribution distribution, std::string note) {
  const bool linear = kind == AxisKind::linear;
  return {std::string(known.key),
          std::string(known.symbol),
          std::string(known.title),
          std::string(known.source),
          !linear && known.effect == Effect::scale ? Effect::target : known.effect,
          std::move(distribution),
          std::string(linear ? known.unit_linear : known.unit_rotary),
          std::move(note)};
}

UncertaintyInputs inputs_of_items(const Metadata& metadata, const Series& series) {
  Collector collector(metadata, {});
  if (!uncertainty_asked_for(metadata)) return std::move(collector).take();
  const auto& length = metadata.uncertainty.length;
  const double length_m = (length ? length->in_mm() : series.travel_native()) / 1000.0;
  if (metadata.axis.kind == AxisKind::linear) {
    collector.add_thermal(machine_items(metadata));
    if (device_has_temperature(metadata)) collector.add_thermal(device_items(metadata));
    if (const auto offset = station_offset(metadata))
      collector.add_station(*offset);
    else
      collector.add_alignment(length_m);
    if (artefact_takes_place_of_device(metadata))
      collector.add_artefact();
    else
      collector.add_device_linear(length_m);
    collector.add_environment();
  } else {
    collector.add_device_rotary();
  }
  if (const std::string problem = station_offset_problem(metadata); !problem.empty())
    collector.note(fmt::format("The station of the tracking interferometer is left out: {}", problem));
  collector.add_in_native_unit();
  return std::move(collector).take();
}

UncertaintyInputs complete_pairs(UncertaintyInputs inputs, const Metadata& metadata) {
  Collector collector(metadata, std::move(inputs));
  collector.complete_pair(machine_items(metadata));
  collector.complete_pair(device_items(metadata));
  return std::move(collector).take();
}

}  // namespace axiometry::iso230_2
