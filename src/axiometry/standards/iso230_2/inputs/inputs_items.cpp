// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the source: α, ΔT, R(θ) and R(α) follow Annex A's defaults where the paper has none; the
// alignment may come from Annex A's misalignment over L; noise of single readings and runs is not in the paper.
#include "axiometry/standards/iso230_2/inputs/inputs_items.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "axiometry/base/contract.h"
#include "axiometry/standards/readings/artefact.h"
#include "axiometry/standards/readings/station_offset.h"
#include "axiometry/standards/readings/usual_expansion.h"

namespace axiometry::iso230_2 {
namespace {

using uncertainty::Distribution;
using uncertainty::Normal;
using uncertainty::Uniform;

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
    KnownInput{"device_constant", "c_c0", "Calibration of the measuring device, constant part", "23, A.1",
               Effect::displacement, "µm", ""},
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

/// Machine or measuring device, with the words for it.
struct ThermalItems {
  std::string_view key;
  std::string_view whose;
  const std::optional<ResolvedBody>& body;
};

ThermalItems machine_items(const ResolvedInputs& resolved) { return {"machine", "machine", resolved.machine}; }
ThermalItems device_items(const ResolvedInputs& resolved) { return {"device", "measuring device", resolved.device}; }

std::string note_of(const ResolvedValue& value) { return std::string(origin_note(value.origin)); }

/// What stands for the measuring device is an artefact.
std::string_view title_with_artefact(std::string_view key) {
  if (key == "device_expansion") return "Expansion coefficient of the artefact";
  if (key == "device_temperature") return "Temperature of the artefact, less 20 °C";
  if (key == "alignment") return "Misalignment of the artefact";
  return "";
}

/// Adds to the inputs of one test.
class Collector {
 public:
  Collector(const Metadata& metadata, const ResolvedInputs& resolved, UncertaintyInputs inputs)
      : metadata_(metadata), resolved_(resolved), result_(std::move(inputs)) {}

  void add(std::string_view key, Distribution distribution, std::string note = {}) {
    result_.inputs.push_back(
        make_input(*find_known_input(key), metadata_.axis.kind, std::move(distribution), std::move(note)));
    if (!artefact_takes_place_of_device(metadata_)) return;
    if (const std::string_view title = title_with_artefact(key); !title.empty()) result_.inputs.back().title = title;
  }
  void note(std::string text) { result_.notes.push_back(std::move(text)); }
  UncertaintyInputs take() && { return std::move(result_); }

  void add_thermal(const ThermalItems& items, const std::optional<ExpansionCoefficient>& stated_range) {
    const bool known = items.body && (items.body->temperature_range || items.body->difference);
    if (!known && stated_range)
      note(fmt::format("R(α) of the {} is left out because its temperature was not given", items.whose));
    if (!known) return;
    ResolvedBody body = *items.body;
    const std::string key = fmt::format("{}_temperature", items.key);
    const bool without_alpha = !body.expansion && !replaced(fmt::format("{}_expansion", items.key));
    if (!body.expansion) body.expansion = ResolvedValue{};
    if (!body.difference && !replaced(key))
      note(fmt::format("The temperature of the {} was not given; 20 °C ± R(θ)/2 is assumed, and α counts as known",
                       items.whose));
    if (!body.temperature_range && !replaced(key))
      note(fmt::format("R(θ) of the {} was not given; its temperature counts as known", items.whose));
    add_expansion(items, body, without_alpha ? "not given" : note_of(*body.expansion), body.difference.has_value());
    const ResolvedValue difference = body.difference.value_or(ResolvedValue{0.0, InputOrigin::assumed});
    add(key, uniform_about(difference.value, body.temperature_range ? body.temperature_range->value : 0.0),
        note_of(difference));
  }

  void add_expansion(const ThermalItems& items, const ResolvedBody& body, std::string origin, bool uncertain) {
    const std::string key = fmt::format("{}_expansion", items.key);
    const bool range_stated = body.expansion_range && body.expansion_range->origin != InputOrigin::assumed;
    if (body.expansion->origin == InputOrigin::assumed && !replaced(key))
      note(fmt::format("α of the {} was not given; 12 µm/(m·°C) is assumed (Table A.2)", items.whose));
    if (uncertain && !range_stated && !replaced(key))
      note(fmt::format("R(α) of the {} was not given; 2 µm/(m·°C) is assumed (A.2.4.3)", items.whose));
    const double width = !uncertain ? 0.0 : body.expansion_range ? body.expansion_range->value : expansion_range_usual;
    add(key, uniform_about(body.expansion->value, width), std::move(origin));
  }

  /// R(θ) of a device whose α nobody knows.
  void note_device_range() {
    const bool stated = metadata_.uncertainty.device_temperature_range.has_value();
    if (stated && !(resolved_.device && resolved_.device->temperature_range))
      note("R(θ) of the measuring device is left out because its α was not given");
  }

  /// With the station of a tracking interferometer there is no misalignment.
  void add_station(const StationOffset& offset) {
    add("station", valid(Normal{0.0, offset.larger_mm}));
    if (offset.smaller_mm > 0.0) add("station_smaller", valid(Normal{0.0, offset.smaller_mm}));
    if (metadata_.gum.alignment_angle || metadata_.uncertainty.misalignment) note(std::string(followed_beam_note));
  }

  void add_alignment() {
    if (const auto& angle = resolved_.alignment_deg)
      add("alignment", uniform_about(0.0, 2.0 * angle->value), note_of(*angle));
  }

  void add_environment() {
    const auto& K = resolved_.environment_sensitivity;
    const auto& difference = resolved_.environment_difference;
    if (K && difference)
      add("environment", valid(Normal{0.0, std::abs(K->value * difference->value)}), note_of(*difference));
    else if (metadata_.gum.environment_sensitivity)
      note("K of the instrument is left out because the air temperature was not given");
  }

  /// U of a certificate is normal with k = 2: a constant part at each place of the artefact for itself, a part in
  /// proportion to the length for all of them together, both wider where the certificate adds them up. What probing
  /// does in the same way in every run.
  void add_artefact() {
    const ResolvedCalibration& certificate = resolved_.artefact_calibration;
    const double widening = certificate.widening(resolved_.length_m.value);
    if (const auto& U = certificate.constant)
      add("artefact_calibration", valid(Normal{0.0, widening * U->value / 2.0}), sum_note(certificate));
    if (const auto& U = certificate.per_length)
      add("artefact_calibration_length", valid(Normal{0.0, widening * U->value / 2.0}), sum_note(certificate));
    if (const auto& U = resolved_.probing) add("probing", valid(Normal{0.0, U->value / 2.0}));
    const AnnexAInputs& annex = metadata_.uncertainty;
    if (annex.device_calibration || annex.device_calibration_per_length || annex.device_error_range)
      note("The artefact takes the place of the measuring device, whose calibration and error range are left out");
  }

  static std::string sum_note(const ResolvedCalibration& certificate) {
    if (!certificate.both()) return "";
    return certificate.sum == CalibrationSum::linear ? "of a + b·L" : "of √(a² + (b·L)²)";
  }

  /// A constant U is what any two targets, however near, may differ by, alone as beside a part per metre: a + 0·L says
  /// the same as a. Both are widened as far as U(l) of the certificate asks for at any length.
  void add_device_linear() {
    for (const std::string& text : resolved_.device_notes) note(text);
    const ResolvedCalibration& certificate = resolved_.device_calibration;
    const double length_m = resolved_.length_m.value;
    if (certificate.both()) {
      const double widening = certificate.widening(length_m);
      add("device", valid(Normal{0.0, widening * certificate.per_length->value / 2.0}), sum_note(certificate));
      add("device_constant", valid(Normal{0.0, widening * certificate.constant->value / 2.0}), sum_note(certificate));
    } else if (certificate.constant) {
      add("device_constant", valid(Normal{0.0, certificate.constant->value / 2.0}));
    } else if (certificate.per_length) {
      add("device", valid(Normal{0.0, certificate.per_length->value / 2.0}));
    } else if (resolved_.device_error_range) {
      add("device", uniform_about(0.0, resolved_.device_error_range->value));
    }
  }

  void add_device_rotary() {
    const auto& U = resolved_.device_calibration.constant;
    if (!U) return;
    add("device", valid(Normal{0.0, U->value / 2.0}));
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
      ResolvedBody known = items.body.value_or(ResolvedBody{});
      if (!known.expansion) known.expansion = ResolvedValue{expansion_usual, InputOrigin::assumed};
      add_expansion(items, known, note_of(*known.expansion), true);
    } else {
      add(fmt::format("{}_temperature", items.key), uniform_about(0.0, 0.0), "assumed");
      note(fmt::format("The temperature of the {} was not given; it counts as 20 °C exactly", items.whose));
    }
  }

 private:
  /// Nothing is assumed where a distribution is given.
  bool replaced(std::string_view key) const {
    return std::ranges::find(resolved_.distributions, key, &InputDistribution::input) != resolved_.distributions.end();
  }

  const Metadata& metadata_;
  const ResolvedInputs& resolved_;
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

UncertaintyInputs inputs_of_items(const Metadata& metadata, const ResolvedInputs& resolved) {
  Collector collector(metadata, resolved, {});
  if (!resolved.asked_for) return std::move(collector).take();
  if (metadata.axis.kind == AxisKind::linear) {
    collector.add_thermal(machine_items(resolved), metadata.uncertainty.machine_expansion_range);
    collector.note_device_range();
    collector.add_thermal(device_items(resolved), metadata.uncertainty.device_expansion_range);
    if (const auto offset = station_offset(metadata))
      collector.add_station(*offset);
    else
      collector.add_alignment();
    if (artefact_takes_place_of_device(metadata))
      collector.add_artefact();
    else
      collector.add_device_linear();
    collector.add_environment();
  } else {
    collector.add_device_rotary();
  }
  if (const std::string problem = station_offset_problem(metadata); !problem.empty())
    collector.note(fmt::format("The station of the tracking interferometer is left out: {}", problem));
  collector.add_in_native_unit();
  return std::move(collector).take();
}

UncertaintyInputs complete_pairs(UncertaintyInputs inputs, const Metadata& metadata, const ResolvedInputs& resolved) {
  Collector collector(metadata, resolved, std::move(inputs));
  collector.complete_pair(machine_items(resolved));
  collector.complete_pair(device_items(resolved));
  return std::move(collector).take();
}

}  // namespace axiometry::iso230_2
