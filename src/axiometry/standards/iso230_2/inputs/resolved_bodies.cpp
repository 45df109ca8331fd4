// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/standards/iso230_2/inputs/resolved_keys.h"
#include "axiometry/standards/iso230_2/inputs/resolved_rows.h"
#include "axiometry/standards/readings/artefact.h"
#include "axiometry/standards/readings/usual_expansion.h"

namespace axiometry::iso230_2 {
namespace {

/// One of two bodies that expand.
struct BodyWords {
  const BodyKeys& keys;
  std::string_view whose;  // what remarks call it
  std::string_view role;   // role of the sensors on it
  std::string_view alpha_symbol;
  std::string_view expansion_input;  // inputs that state its distributions: this and the next
  std::string_view temperature_input;
};

constexpr BodyWords machine_words{machine_keys, "machine", "machine", "α", "machine_expansion", "machine_temperature"};
constexpr BodyWords device_words{device_keys, "measuring device", "equipment",
                                 "α_D",       "device_expansion", "device_temperature"};

class BodyResolver {
 public:
  BodyResolver(StatementList& list, const Metadata& metadata)
      : list_(list),
        metadata_(metadata),
        in_(metadata.uncertainty),
        linear_(metadata.axis.kind == AxisKind::linear),
        artefact_(artefact_takes_place_of_device(metadata)) {}

  double machine_expansion() { return expansion(machine_words)->value; }  // assumed where nothing is stated

  void body(const BodyWords& words, std::optional<ResolvedBody>& body) {
    const bool machine = &words.keys == &machine_keys;
    ResolvedBody found;
    found.expansion = expansion(words);
    found.temperature_range =
        list_.take(words.keys.temperature_range, "R(θ)",
                   stated_number(machine ? in_.machine_temperature_range : in_.device_temperature_range), "°C");
    found.difference =
        difference(words, machine ? in_.machine_temperature_difference : in_.device_temperature_difference);
    const MaybeResolved range =
        list_.take(words.keys.expansion_range, machine ? "R(α)" : "R(α_D)",
                   stated_number(machine ? in_.machine_expansion_range : in_.device_expansion_range), "µm/(m·°C)");
    if (!linear_) return;
    const bool stated = found.temperature_range || list_.find(words.keys.difference) != nullptr || range;
    // What an artefact is made of expands in any case; what is said of an interferometer often includes it.
    const bool expands = artefact_ && found.expansion && found.expansion->value != 0.0 && found.difference;
    const bool by_distribution =
        list_.has_distribution(words.expansion_input) || list_.has_distribution(words.temperature_input);
    if (!machine && !stated && !expands && !by_distribution) {
      list_.cannot_act(words.keys.expansion, fmt::format("without R(θ) of the {} nothing depends on it", words.whose));
      return;
    }
    if (!found.expansion) {
      list_.cannot_act_without(words.expansion_input, words.keys.temperature_range,
                               fmt::format("the expansion coefficient of the {} is not known", words.whose));
      if (!list_.has_distribution(words.expansion_input)) found.temperature_range.reset();
    }
    if (!found.difference)
      list_.cannot_act_without(words.temperature_input, words.keys.expansion_range,
                               fmt::format("the temperature of the {} is not known", words.whose));
    if (!found.temperature_range && !(expands && !machine))
      list_.cannot_act_without(words.temperature_input, words.keys.expansion,
                               fmt::format("without R(θ) of the {} nothing depends on it", words.whose));
    if (!found.temperature_range && !found.difference && !by_distribution) return;
    add_followers(words, found, range);
    body = found;
  }

 private:
  /// The sensors, as far as they speak for a body: their difference to 20 °C and who states the one that shows it.
  MaybeResolved sensors(std::string_view role, StatedBy& by) const {
    const auto& all = metadata_.environment.sensors;
    const auto largest = largest_sensor_difference(metadata_.environment, role);
    if (!largest) return std::nullopt;
    const StatedItem* item = list_.item(sensors_key);
    by = StatedBy::file;
    if (item != nullptr) {
      Environment later;
      const std::size_t count = std::min(item->records, all.size());
      later.sensors.assign(all.end() - static_cast<std::ptrdiff_t>(count), all.end());
      if (largest_sensor_difference(later, role)) by = item->by;
    }
    return ResolvedValue{*largest, InputOrigin::sensors};
  }

  MaybeResolved difference(const BodyWords& words, const std::optional<TemperatureDifference>& stated) {
    const MaybeResolved given = list_.take(words.keys.difference, "ΔT", stated_number(stated), "°C");
    StatedBy by = StatedBy::file;
    const MaybeResolved shown = sensors(words.role, by);
    if (!shown) return given;
    if (given) {
      // The largest difference cannot be smaller than what a sensor shows, unless somebody stronger says so.
      const bool larger = std::abs(shown->value) > std::abs(given->value) + same_temperature;
      const StatedBy by_given = list_.by(words.keys.difference);
      const bool sensors_count = by > by_given || (by == by_given && larger);
      const bool differ = std::abs(std::abs(shown->value) - std::abs(given->value)) > same_temperature;
      if (!sensors_count && std::abs(shown->value) <= std::abs(given->value) + same_temperature) return given;
      if (!differ) return given;
      const ResolvedRow of_sensors{fmt::format("{} ({})", sensors_key, words.role),
                                   "ΔT",
                                   shown->value,
                                   "",
                                   "°C",
                                   static_cast<InputOrigin>(by),
                                   "",
                                   sensors_count ? InputUse::all : InputUse::none,
                                   sensors_count ? "" : fmt::format("{} takes its place", words.keys.difference)};
      list_.rows.push_back(of_sensors);
      if (sensors_count)
        list_.override_by(words.keys.difference, of_sensors.key);
      else
        list_.note(fmt::format("{} does not count: {} takes its place", statement_text(of_sensors),
                               statement_text(*list_.find(words.keys.difference))));
      return sensors_count ? shown : given;
    }
    return shown;
  }

  /// The coefficient that counts: stated for the uncertainty, else what follows.
  MaybeResolved expansion(const BodyWords& words) {
    const bool machine = &words.keys == &machine_keys;
    MaybeResolved alpha =
        list_.take(words.keys.expansion, words.alpha_symbol,
                   stated_number(machine ? in_.machine_expansion : in_.device_expansion), "µm/(m·°C)");
    const auto of_nde = stated_number(machine ? metadata_.nde.machine_expansion : metadata_.nde.equipment_expansion);
    const auto of_scale = machine ? stated_number(metadata_.axis.scale_expansion) : std::nullopt;
    struct Follower {
      std::string_view key;
      std::optional<double> value;
      InputOrigin origin;
    };
    const Follower nde{words.keys.nde_expansion, of_nde, InputOrigin::nde_correction};
    const Follower scale{scale_expansion_key, of_scale, InputOrigin::scale};
    const bool corrected = metadata_.nde.applied == true;
    for (const Follower& follower : {corrected ? nde : scale, corrected ? scale : nde}) {
      if (!follower.value) continue;
      if (!alpha) {
        alpha = ResolvedValue{*follower.value, follower.origin};
        followed_key_ = follower.key;
      } else if (list_.by(follower.key) > StatedBy::file && *follower.value != alpha->value &&
                 alpha->origin <= InputOrigin::flag && follower.key != nde.key) {
        list_.take(follower.key, words.alpha_symbol, follower.value, "µm/(m·°C)");
        list_.override_by(follower.key, words.keys.expansion);
      }
    }
    if (!alpha && machine) {
      alpha = ResolvedValue{expansion_usual, InputOrigin::assumed};
      followed_key_ = words.keys.expansion;
    }
    return alpha;
  }

  /// Rows of what nobody stated of a body, and R(α).
  void add_followers(const BodyWords& words, ResolvedBody& found, const MaybeResolved& range) {
    if (found.expansion && found.expansion->origin > InputOrigin::flag)
      list_.follow(followed_key_, words.alpha_symbol, found.expansion->value, "µm/(m·°C)", found.expansion->origin);
    found.expansion_range = range;
    if (!found.difference) return;
    if (found.difference->origin == InputOrigin::sensors &&
        list_.find(fmt::format("{} ({})", sensors_key, words.role)) == nullptr)
      list_.follow(fmt::format("{} ({})", sensors_key, words.role), "ΔT", found.difference->value, "°C",
                   InputOrigin::sensors);
    const std::string_view symbol = &words.keys == &machine_keys ? "R(α)" : "R(α_D)";
    if (!range)
      found.expansion_range =
          list_.follow(words.keys.expansion_range, symbol, expansion_range_usual, "µm/(m·°C)", InputOrigin::assumed);
  }

  StatementList& list_;
  const Metadata& metadata_;
  const AnnexAInputs& in_;
  bool linear_;
  bool artefact_;                  // an artefact in place of the device (Annex D)
  std::string_view followed_key_;  // key of the coefficient that follows
};

}  // namespace

void resolve_bodies(StatementList& list, const Metadata& metadata, ResolvedInputs& result) {
  BodyResolver resolver(list, metadata);
  resolver.body(machine_words, result.machine);
  resolver.body(device_words, result.device);
}

double machine_expansion(const Metadata& metadata) {
  const StatedItems stated;  // who stated a value decides what is told, not the value
  StatementList list(metadata.gum.distributions, stated);
  return BodyResolver(list, metadata).machine_expansion();
}

}  // namespace axiometry::iso230_2
