// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "axiometry/model/fields_access.h"
#include "axiometry/model/surroundings.h"

/// The lists of records among the metadata: their columns, and how a list is read and written as a FieldValue.
namespace axiometry::fields_access {

inline constexpr RecordColumn equipment_columns[] = {
    {"role", "Component", FieldType::text, ""},
    {"manufacturer", "Manufacturer", FieldType::text, ""},
    {"type", "Type", FieldType::text, ""},
    {"serial_number", "Serial number", FieldType::text, ""},
    {"certificate", "Certificate", FieldType::text, "", false},
    {"calibrated_on", "Calibrated on", FieldType::text, "", false},
    {"calibration_due", "Calibration due", FieldType::text, "", false},
};
inline constexpr RecordColumn distribution_columns[] = {
    {"input", "Input", FieldType::text, ""},
    {"distribution", "Distribution", FieldType::text, ""},
};
inline constexpr RecordColumn sensor_columns[] = {
    {"role", "Sensor", FieldType::text, ""},
    {"location", "Location", FieldType::text, ""},
    {"start_C", "Start", FieldType::number, "°C"},
    {"end_C", "End", FieldType::number, "°C"},
};

struct EquipmentAccess {
  static FieldValue get(const Metadata& m) {
    Records records;
    for (const Equipment& e : m.equipment)
      records.push_back({text_cell(e.role), text_cell(e.manufacturer), text_cell(e.type), text_cell(e.serial_number),
                         text_cell(e.certificate), text_cell(e.calibrated_on), text_cell(e.calibration_due)});
    return records.empty() ? FieldValue{} : FieldValue(std::move(records));
  }
  static void put(Metadata& m, const FieldValue& value) {
    m.equipment.clear();
    if (const auto* records = std::get_if<Records>(&value))
      for (const auto& r : *records)
        m.equipment.push_back(
            {text_of(r[0]), text_of(r[1]), text_of(r[2]), text_of(r[3]), text_of(r[4]), text_of(r[5]), text_of(r[6])});
  }
};

struct SensorAccess {
  static FieldValue get(const Metadata& m) {
    Records records;
    for (const TemperatureSensor& s : m.environment.sensors)
      records.push_back({text_cell(s.role), text_cell(s.location), temperature_cell(s.start), temperature_cell(s.end)});
    return records.empty() ? FieldValue{} : FieldValue(std::move(records));
  }
  static void put(Metadata& m, const FieldValue& value) {
    m.environment.sensors.clear();
    if (const auto* records = std::get_if<Records>(&value))
      for (const auto& r : *records)
        m.environment.sensors.push_back({text_of(r[0]), text_of(r[1]), temperature_of(r[2]), temperature_of(r[3])});
  }
};

struct DistributionAccess {
  static FieldValue get(const Metadata& m) {
    Records records;
    for (const InputDistribution& d : m.gum.distributions)
      records.push_back({text_cell(d.input), text_cell(d.distribution)});
    return records.empty() ? FieldValue{} : FieldValue(std::move(records));
  }
  static void put(Metadata& m, const FieldValue& value) {
    m.gum.distributions.clear();
    if (const auto* records = std::get_if<Records>(&value))
      for (const auto& r : *records) m.gum.distributions.push_back({text_of(r[0]), text_of(r[1])});
  }
};

// What is stated of the surroundings over the test (4.1), and what was agreed on them (7).

template <auto Member, const auto& Unit>
constexpr Field stated_field(std::string_view key, std::string_view title, std::string_view clause, double minimum) {
  return number_field<QuantityAccess<At<&Metadata::surroundings, Member>, Unit>>(
      key, title, "°C", "°C", clause, Field::Wanted::no, minimum, hottest_hall_C,
      "During the whole test; what a log of temperatures tells takes its place.");
}

template <auto Member>
constexpr Field stated_rate(std::string_view key, std::string_view title) {
  return number_field<PlainAccess<At<&Metadata::surroundings, Member>, double>>(
      key, title, "°C/h", "°C/h", "4.1", Field::Wanted::no, 0, hottest_hall_C,
      "The largest, of the air; what a log of temperatures tells takes its place.");
}

constexpr Field soaked_field(std::string_view key, std::string_view title) {
  constexpr double weeks_h = 1000;
  return number_field<PlainAccess<At<&Metadata::surroundings, &StatedEnvironment::soaked_h>, double>>(
      key, title, "h", "h", "4.1", Field::Wanted::no, 0, weeks_h,
      "How long machine and measuring equipment stood in the surroundings before the test.");
}

template <auto Member, const auto& Unit>
constexpr Field agreed_field(std::string_view key, std::string_view title, std::string_view clause, double minimum) {
  return number_field<QuantityAccess<At<&Metadata::agreed, Member>, Unit>>(
      key, title, "°C", "°C", clause, Field::Wanted::no, minimum, hottest_hall_C, "Limit between the parties.");
}

constexpr Field agreed_rate(std::string_view key, std::string_view title) {
  return number_field<PlainAccess<At<&Metadata::agreed, &AgreedEnvironment::rate>, double>>(
      key, title, "°C/h", "°C/h", "4.1", Field::Wanted::no, 0, hottest_hall_C,
      "Limit between the parties, in the twelve hours before the test and during it.");
}

}  // namespace axiometry::fields_access
