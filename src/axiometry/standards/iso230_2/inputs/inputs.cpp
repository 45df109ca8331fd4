// SPDX-License-Identifier: Apache-2.0
//
// The given distributions laid over what the single items say (inputs_items.cpp).
#include "axiometry/standards/iso230_2/inputs/inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "axiometry/base/text/text.h"
#include "axiometry/standards/iso230_2/inputs/inputs_items.h"
#include "axiometry/standards/readings/artefact.h"
#include "axiometry/standards/readings/station_offset.h"

namespace axiometry::iso230_2 {
namespace {

using uncertainty::Distribution;

/// What an input of one's own may act on.
constexpr std::array own_effects = {Effect::scale, Effect::target, Effect::target_direction, Effect::run,
                                    Effect::reading};

std::unexpected<Error> unknown_input(const std::string& name) {
  std::vector<std::string_view> names;
  for (const KnownInput& known : known_inputs()) names.push_back(known.key);
  for (Effect effect : own_effects) names.push_back(effect_key(effect));
  const auto near = text::nearest(name, names);
  return fail(fmt::format(
      "found a distribution of the unknown input {}, expected {}", text::quoted(name),
      near ? fmt::format("perhaps {}", *near)
           : fmt::format("one of {}; the last five may have a name after a colon", fmt::join(names, ", "))));
}

/// Beyond these the model leaves the world of machine tools, and 1 + αΔT could vanish.
Result<void> check_size(std::string_view input, Effect effect, const Distribution& distribution) {
  struct Reach {
    double limit;
    double deviations;  // how many standard deviations count
  };
  Reach reach{1e9, 10.0};
  if (effect == Effect::machine_expansion || effect == Effect::device_expansion) reach = {1000.0, 10.0};
  if (effect == Effect::machine_temperature || effect == Effect::device_temperature) reach = {200.0, 10.0};
  // A uniform distribution up to 90° has 52° of standard deviation.
  if (effect == Effect::alignment) reach = {90.0, std::sqrt(3.0)};
  if (effect == Effect::station) reach = {1e6, 10.0};
  const auto sd = distribution.standard_deviation();
  if (!sd && effect <= Effect::station)
    return fail(fmt::format("found a distribution of {} without a standard deviation, expected one that has it",
                            text::quoted(input)));
  if (effect == Effect::station && !square_moments(distribution).standard_deviation)
    return fail(fmt::format("found a distribution of {} whose square has no standard deviation, expected t with ν > 4",
                            text::quoted(input)));
  const double far = std::abs(distribution.mean()) + reach.deviations * sd.value_or(0.0);
  if (far <= reach.limit * (1.0 + 1e-12)) return {};
  return fail(fmt::format("found a distribution of {} that reaches to about {:.3g}, expected at most {:g}",
                          text::quoted(input), far, reach.limit));
}

/// α, ΔT, θ and Δ stay as they are; a mean of anything else would be a correction, which the readings do not get.
Distribution about_zero(const InputDistribution& given, Effect effect, Distribution distribution,
                        std::vector<std::string>& notes) {
  if (effect <= Effect::station || distribution.mean() == 0.0) return distribution;
  notes.push_back(fmt::format("The distribution of {} is used about its mean: the readings are not corrected by {:.4g}",
                              text::quoted(given.input), distribution.mean()));
  return distribution.centred();
}

Result<Distribution> parse(const InputDistribution& given) {
  auto distribution = Distribution::parse(given.distribution);
  if (!distribution)
    distribution.error().message =
        fmt::format("distribution of the input {}: {}", text::quoted(given.input), distribution.error().message);
  return distribution;
}

Result<UncertaintyInput> known_input(const InputDistribution& given, const KnownInput& known, AxisKind kind,
                                     std::vector<std::string>& notes) {
  if (kind == AxisKind::rotary && known.unit_rotary.empty())
    return fail(fmt::format("found a distribution of {} on a rotary axis, expected it on linear ones only", known.key));
  AXIOMETRY_TRY(Distribution distribution, parse(given));
  AXIOMETRY_TRY_VOID(check_size(given.input, known.effect, distribution));
  return make_input(known, kind, about_zero(given, known.effect, std::move(distribution), notes), "as given");
}

/// "scale:optics": what it acts on, and a name.
Result<UncertaintyInput> own_input(const InputDistribution& given, AxisKind kind, std::vector<std::string>& notes) {
  const std::size_t colon = given.input.find(':');
  const auto* effect =
      std::ranges::find(own_effects, text::trim(std::string_view(given.input).substr(0, colon)), effect_key);
  if (effect == own_effects.end()) return unknown_input(given.input);
  if (kind == AxisKind::rotary && *effect == Effect::scale)
    return fail("found an input that acts on the scale of a rotary axis, expected target, run or reading");
  AXIOMETRY_TRY(Distribution distribution, parse(given));
  AXIOMETRY_TRY_VOID(check_size(given.input, *effect, distribution));
  std::string title(colon == std::string::npos ? "" : text::trim(std::string_view(given.input).substr(colon + 1)));
  if (title.empty()) title = given.input;
  const std::string_view unit = *effect == Effect::scale ? "µm/m" : deviation_unit(kind);
  return UncertaintyInput{
      given.input,       given.input, title, "", *effect, about_zero(given, *effect, std::move(distribution), notes),
      std::string(unit), "as given"};
}

Result<void> lay_over(UncertaintyInputs& result, const Metadata& metadata, const ResolvedInputs& resolved) {
  std::vector<std::string_view> seen;
  for (const InputDistribution& given : resolved.distributions) {
    if (given.input.empty() && given.distribution.empty()) continue;
    if (std::ranges::find(seen, given.input) != seen.end())
      return fail(fmt::format("found two distributions of the input {}, expected one", text::quoted(given.input)));
    seen.push_back(given.input);
    const KnownInput* known = find_known_input(given.input);
    AXIOMETRY_TRY(UncertaintyInput input, known ? known_input(given, *known, metadata.axis.kind, result.notes)
                                                : own_input(given, metadata.axis.kind, result.notes));
    // The calibration of the device may have two inputs, or that of its constant part.
    std::erase_if(result.inputs, [&](const UncertaintyInput& before) {
      return before.key == input.key || (input.key == "device" && before.key == "device_constant" &&
                                         std::ranges::find(seen, before.key) == seen.end());
    });
    result.inputs.push_back(std::move(input));
  }
  return {};
}

/// From where a station acts, if there is one.
Result<void> place_station(UncertaintyInputs& result, const Metadata& metadata) {
  const auto found = std::ranges::find(result.inputs, Effect::station, &UncertaintyInput::effect);
  if (found == result.inputs.end()) return {};
  result.station = metadata.tracking.station_position;
  if (result.station) return {};
  return fail(
      fmt::format("found a distribution of {} without tracking.station_position, expected the position of the "
                  "point of the line that is next to the station",
                  found->key));
}

/// Where the readings hold an expansion that is known and was not corrected.
void note_expansion(UncertaintyInputs& result, const Metadata& metadata, const Series& series) {
  const auto mean_of = [&](std::string_view key) {
    const auto found = std::ranges::find(result.inputs, key, &UncertaintyInput::key);
    return found == result.inputs.end() ? 0.0 : found->distribution.mean();
  };
  const double relative = mean_of("machine_expansion") * mean_of("machine_temperature") -
                          mean_of("device_expansion") * mean_of("device_temperature");
  const double expansion_um = relative * series.travel_native() / 1000.0;
  if (metadata.nde.applied != false || std::abs(expansion_um) < 0.005) return;
  result.notes.push_back(
      fmt::format("The readings are not corrected for thermal expansion: over the travel they hold about {:.2f} µm of "
                  "it, which the uncertainty does not include",
                  expansion_um));
}

}  // namespace

std::string_view effect_key(Effect effect) {
  constexpr std::string_view keys[] = {"machine_expansion",
                                       "machine_temperature",
                                       "device_expansion",
                                       "device_temperature",
                                       "alignment",
                                       "station",
                                       "scale",
                                       "displacement",
                                       "target",
                                       "target_direction",
                                       "run",
                                       "reading"};
  return keys[static_cast<std::size_t>(effect)];
}

Result<UncertaintyInputs> uncertainty_inputs(const Metadata& metadata, const Series& series,
                                             const StatedItems& stated) {
  const double correlation = metadata.gum.up_down_correlation.value_or(1.0);
  if (!(correlation >= -1.0 && correlation <= 1.0))
    return fail(fmt::format("found a correlation of {} between ↑ and ↓, expected a number from −1 to 1", correlation));
  const ResolvedInputs resolved = resolve_inputs(metadata, series, stated);
  UncertaintyInputs result = inputs_of_items(metadata, resolved);
  AXIOMETRY_TRY_VOID(lay_over(result, metadata, resolved));
  AXIOMETRY_TRY_VOID(place_station(result, metadata));
  result = complete_pairs(std::move(result), metadata, resolved);
  note_expansion(result, metadata, series);
  const auto rank = [](const UncertaintyInput& input) { return find_known_input(input.key); };
  std::ranges::stable_sort(result.inputs, [&](const UncertaintyInput& a, const UncertaintyInput& b) {
    return rank(a) != nullptr && (rank(b) == nullptr || rank(a) < rank(b));
  });
  result.up_down_correlation = correlation;
  result.of_artefact = artefact_takes_place_of_device(metadata);
  return result;
}

std::string no_claim_note(std::span<const std::string_view> symbols) {
  return fmt::format("No given input acts on {}: an uncertainty is not stated, rather than 0",
                     fmt::join(symbols, ", "));
}

Measurand measurand_of(const Metadata& metadata) { return metadata.gum.measurand.value_or(Measurand::this_test); }

std::string_view measurand_key(Measurand measurand) {
  return measurand == Measurand::this_test ? "this-test" : "this-machine";
}

std::string_view measurand_title(Measurand measurand) {
  return measurand == Measurand::this_test
             ? "this test: what the same approaches would have given with perfect instruments at 20 °C"
             : "this machine: what the axis does in the long run, of which the approaches are a sample";
}

}  // namespace axiometry::iso230_2
