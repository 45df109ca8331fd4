// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/from_archive/from_archive.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "axiometry/base/text/says_nothing.h"
#include "axiometry/base/time/iso_date.h"
#include "axiometry/model/fields.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/standards/iso230_2/inputs/resolved_keys.h"

namespace axiometry::app {
namespace {

bool concerns(const Changes& changes, std::string_view group) {
  return std::ranges::any_of(changes, [&](const auto& change) { return change.first.starts_with(group); });
}

/// The keys that say one thing together with this one: what a certificate states is taken as a whole or not at all.
std::span<const std::string_view> said_together(const std::string& key) {
  const std::span<const std::string_view> of_device = iso230_2::device_statement_keys;
  const std::span<const std::string_view> of_artefact = iso230_2::artefact_calibration_all;
  if (std::ranges::find(of_device, key) != of_device.end()) return of_device;
  if (std::ranges::find(of_artefact, key) != of_artefact.end()) return of_artefact;
  return {};
}

/// Those inputs that nobody else states, and of them those that belong to another's statement.
InstrumentInputs inputs_taken(const store::InstrumentRecord& instrument, const Metadata& metadata,
                              const Changes& changes) {
  const auto stated = [&](std::string_view key) {
    const Field* field = find_field(key);
    const bool named = std::ranges::find(changes, key, &Changes::value_type::first) != changes.end();
    return named || field == nullptr || is_given(*field, metadata);
  };
  InstrumentInputs found;
  for (const auto& [key, text] : instrument.inputs) {
    if (stated(key)) continue;
    const bool whole = std::ranges::none_of(said_together(key), stated);
    (whole ? found.inputs : found.left_out).emplace_back(key, text);
  }
  return found;
}

using KnownInstruments = std::vector<store::Versioned<store::InstrumentRecord>>;

std::vector<InstrumentInputs> inputs_of(const KnownInstruments& known, const Metadata& metadata,
                                        const Changes& changes) {
  std::vector<InstrumentInputs> found;
  Changes taken_so_far = changes;  // the first instrument that states an input wins
  for (const auto& instrument : known) {
    InstrumentInputs taken = inputs_taken(instrument.value, metadata, taken_so_far);
    if (taken.inputs.empty() && taken.left_out.empty()) continue;
    taken_so_far.insert(taken_so_far.end(), taken.inputs.begin(), taken.inputs.end());
    taken.instrument = instrument.id;
    taken.version = instrument.version;
    taken.name = instrument_name(instrument.value);
    found.push_back(std::move(taken));
  }
  return found;
}

/// By what a machine or an instrument is known again: "-" and "unknown" would be one for all that state them.
std::string named(std::string_view stated) { return text::says_nothing(stated) ? "" : report::printable(stated); }

/// A component of the test equipment as an instrument; nothing of a line that identifies none.
std::optional<store::InstrumentRecord> instrument_of(const Equipment& component) {
  store::InstrumentRecord instrument;
  instrument.role = report::printable(component.role);
  instrument.manufacturer = named(component.manufacturer);
  instrument.type = named(component.type);
  instrument.serial_number = named(component.serial_number);
  if (instrument.serial_number.empty() && instrument.manufacturer.empty() && instrument.type.empty()) return {};
  return instrument;
}

bool has_calibration(const store::InstrumentRecord& instrument) {
  return !instrument.certificate.empty() || !instrument.calibrated_on.empty() || !instrument.calibration_due.empty();
}

/// Whether two versions tell of one calibration: the later one then mends what the earlier one said of it.
bool same_calibration(const store::InstrumentRecord& a, const store::InstrumentRecord& b) {
  if (!a.certificate.empty() && a.certificate == b.certificate) return true;
  if (!a.calibrated_on.empty()) return a.calibrated_on == b.calibrated_on;
  return b.calibrated_on.empty() && a.certificate.empty() && b.certificate.empty();
}

/// The calibrations that an instrument has had, each as it was told last.
KnownInstruments calibrations_in(const KnownInstruments& versions) {
  KnownInstruments all;
  for (const auto& version : versions) {
    if (!has_calibration(version.value)) continue;
    const auto mended =
        std::ranges::find_if(all, [&](const auto& before) { return same_calibration(before.value, version.value); });
    if (mended != all.end()) all.erase(mended);
    all.push_back(version);
  }
  return all;
}

/// The newest calibration that is not later than this day, "2014-05-15". Where it did not hold any more, or where there
/// is none, one of an unknown day. Where the day of the test is not known, the only one there is: of several nobody can
/// tell which held.
const store::Versioned<store::InstrumentRecord>* calibration_on(const std::string& day,
                                                                const KnownInstruments& calibrations) {
  const store::Versioned<store::InstrumentRecord>* newest = nullptr;
  const store::Versioned<store::InstrumentRecord>* undated = nullptr;
  for (const auto& one : calibrations) {
    const std::string since = named_days(one.value.calibrated_on).first;
    if (since.empty()) undated = &one;
    if (since.empty() || since > day) continue;
    if (newest == nullptr || named_days(newest->value.calibrated_on).first <= since) newest = &one;
  }
  if (day.empty()) return calibrations.size() == 1 ? &calibrations.front() : nullptr;
  const std::string due = newest == nullptr ? "" : named_days(newest->value.calibration_due).last;
  const bool holds = newest != nullptr && (due.empty() || due >= day);
  return holds || undated == nullptr ? newest : undated;
}

/// The instruments that a test was linked with, else those that the archive would link it with.
struct Instruments {
  KnownInstruments all;
  std::vector<std::optional<store::Id>> by_component;
};

Result<Instruments> known_instruments(const store::Transaction& archive, const Metadata& metadata) {
  Instruments known;
  for (const Equipment& component : metadata.equipment) {
    auto& id = known.by_component.emplace_back();
    const auto stated = instrument_of(component);
    if (!stated) continue;
    AXIOMETRY_TRY(auto found, archive.known(*stated));
    if (!found) continue;
    id = found->id;
    known.all.push_back(*std::move(found));
  }
  return known;
}

Result<Instruments> linked_instruments(const store::Transaction& archive, const Metadata& metadata,
                                       const std::vector<store::Id>& linked) {
  Instruments instruments;
  if (instruments_of(metadata).size() == linked.size()) {
    std::size_t identified = 0;
    for (const Equipment& component : metadata.equipment)
      instruments.by_component.push_back(instrument_of(component) ? std::optional(linked[identified++]) : std::nullopt);
  } else {
    AXIOMETRY_TRY(instruments, known_instruments(archive, metadata));
    instruments.all.clear();
  }
  for (const store::Id id : linked) {
    AXIOMETRY_TRY(auto instrument, archive.get<store::InstrumentRecord>(id));
    instruments.all.push_back(std::move(instrument));
  }
  return instruments;
}

Result<std::vector<KnownCalibration>> calibrations_of(const store::Transaction& archive, const Metadata& metadata,
                                                      const std::vector<std::optional<store::Id>>& instruments) {
  const std::string day = iso_date(metadata.conditions.date);
  std::vector<KnownCalibration> known;
  for (std::size_t k = 0; k < instruments.size(); ++k) {
    if (!instruments[k] || states_calibration(metadata.equipment[k])) continue;
    AXIOMETRY_TRY(const KnownInstruments versions, archive.versions<store::InstrumentRecord>(*instruments[k]));
    const KnownInstruments calibrations = calibrations_in(versions);
    const auto* held = calibration_on(day, calibrations);
    if (held == nullptr) continue;
    const store::InstrumentRecord& told = held->value;
    known.push_back({held->id, held->version, {k, told.certificate, told.calibrated_on, told.calibration_due}});
  }
  return known;
}

using KnownAxis = std::optional<store::Versioned<store::AxisRecord>>;

std::optional<AxisLimits> limits_of(const KnownAxis& axis) {
  if (!axis || axis->value.limits.empty()) return {};
  return AxisLimits{axis->id, axis->version, axis->value.limits, iso_date(axis->change.at)};
}

}  // namespace

std::string instrument_name(const store::InstrumentRecord& instrument) {
  std::string name;
  for (const std::string* part : {&instrument.manufacturer, &instrument.type, &instrument.serial_number})
    if (!part->empty()) name += (name.empty() ? "" : " ") + *part;
  return name.empty() ? instrument.role : name;
}

std::vector<store::InstrumentRecord> instruments_of(const Metadata& metadata) {
  std::vector<store::InstrumentRecord> instruments;
  for (const Equipment& component : metadata.equipment)
    if (auto instrument = instrument_of(component)) instruments.push_back(*std::move(instrument));
  return instruments;
}

store::MachineRecord machine_of(const Metadata& metadata) {
  store::MachineRecord machine;
  machine.name = named(metadata.machine.name);
  machine.type = report::printable(metadata.machine.type);
  machine.serial_number = named(metadata.machine.serial_number);
  machine.location = report::printable(metadata.machine.location);
  return machine;
}

store::AxisRecord axis_of(const Metadata& metadata) {
  store::AxisRecord axis;
  axis.name = report::printable(metadata.axis.name);
  axis.kind = axis_kind_name(metadata.axis.kind);
  return axis;
}

Result<FromArchive> find_in_archive(const store::Transaction& archive, const ArchiveQuestion& question) {
  const auto& [metadata, changes, links] = question;
  const bool linked_equipment = links && !concerns(changes, "equipment");
  AXIOMETRY_TRY(const Instruments instruments, linked_equipment
                                                   ? linked_instruments(archive, metadata, links->instruments)
                                                   : known_instruments(archive, metadata));
  FromArchive taken{.instruments = inputs_of(instruments.all, metadata, changes), .calibrations = {}, .axis = {}};
  AXIOMETRY_TRY(taken.calibrations, calibrations_of(archive, metadata, instruments.by_component));
  const bool linked_axis = links && links->axis && !concerns(changes, "machine.") && !concerns(changes, "axis.");
  if (linked_axis) {
    AXIOMETRY_TRY(auto axis, archive.get<store::AxisRecord>(*links->axis));
    taken.axis = limits_of(std::move(axis));
    return taken;
  }
  const auto machine = links ? links->machine : std::nullopt;
  AXIOMETRY_TRY(const KnownAxis axis, archive.known(machine_of(metadata), axis_of(metadata), machine));
  taken.axis = limits_of(axis);
  return taken;
}

EvaluateOptions with_archive(EvaluateOptions options, const Changes& changes, const FromArchive& taken) {
  for (const InstrumentInputs& inputs : taken.instruments) {
    const auto items = metadata_items(inputs.inputs);
    options.metadata.insert(options.metadata.end(), items.begin(), items.end());
    for (const auto& [key, text] : inputs.inputs)
      options.stated.items.push_back({key, StatedBy::instrument, inputs.name, 0});
    for (const auto& [key, text] : inputs.left_out)
      options.remarks.push_back(fmt::format(
          "the archive states {} = {} of {}, which is left out: part of what is said of its errors is stated "
          "elsewhere, and a certificate is taken as a whole",
          key, text, inputs.name));
  }
  for (const auto& [key, text] : changes) {
    std::erase_if(options.stated.items, [&](const StatedItem& item) { return item.key == key; });
    options.stated.items.push_back({key, StatedBy::entered, {}, 0});
  }
  const auto items = metadata_items(changes);
  options.metadata.insert(options.metadata.end(), items.begin(), items.end());
  for (const KnownCalibration& known : taken.calibrations) options.calibrations.push_back(known.calibration);
  if (!taken.axis) return options;
  for (const store::Limit& limit : taken.axis->limits)
    if (const auto* parameter = iso230_2::find_parameter(limit.parameter))
      options.tolerance.of_axis.push_back(
          {parameter, Deviation::native(limit.value), iso230_2::ToleranceSource::axis, taken.axis->set_on});
  return options;
}

}  // namespace axiometry::app
