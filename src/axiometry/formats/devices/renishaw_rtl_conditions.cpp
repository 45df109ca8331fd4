// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/devices/renishaw_rtl_conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "axiometry/base/contract.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/model/fields.h"

namespace axiometry::formats {
namespace {

struct TextItem {
  std::string_view tag;
  std::string_view key;
};

constexpr TextItem text_items[] = {
    {"machine", "machine.name"}, {"serial no", "machine.serial_number"},
    {"date", "test.date"},       {"by", "test.inspector"},
    {"axis", "axis.name"},       {"location", "machine.location"},
    {"title", "test.comment"},
};

/// "20,1 °C": the number and the unit behind it.
struct Measure {
  double value = 0.0;
  std::string unit;  ///< lower case, without the degree sign
};

std::optional<Measure> measure_from(std::string_view text) {
  const std::size_t end = std::min(text.find_first_not_of("+-.,0123456789"), text.size());
  std::string number(text.substr(0, end));
  std::ranges::replace(number, ',', '.');
  const auto value = parse_number(number);
  if (!value) return std::nullopt;
  std::string unit = text::to_lower(text::trim(text.substr(end)));
  // The last two are degree signs that went through a wrong code page before.
  for (std::string_view degree : {"\u00C2\u00B0", "\u00B0", "\u2103", "deg", "\u00A1\u00E3"})
    if (unit.starts_with(degree)) unit = degree == "\u2103" ? "c" : text::trim(unit.substr(degree.size()));
  return Measure{*value, unit};
}

struct PressureUnit {
  std::string_view name;
  double kPa;
};

constexpr PressureUnit pressure_units[] = {
    {"mbar", 0.1}, {"hpa", 0.1}, {"kpa", 1.0}, {"pa", 0.001}, {"mmhg", 0.133322}, {"inhg", 3.386389}, {"bar", 100.0},
};

/// Without a unit only one is possible: no place has 50 to 120 mbar.
std::optional<double> pressure_kPa(const Measure& m) {
  for (const PressureUnit& unit : pressure_units)
    if (m.unit == unit.name) return m.value * unit.kPa;
  if (!m.unit.empty()) return std::nullopt;
  if (m.value >= 500.0 && m.value <= 1200.0) return m.value * 0.1;
  if (m.value >= 50.0 && m.value <= 120.0) return m.value;
  return std::nullopt;
}

std::optional<double> temperature_C(const Measure& m) {
  if (m.unit.empty() || m.unit == "c") return m.value;
  if (m.unit == "f") return (m.value - 32.0) / 1.8;
  return std::nullopt;
}

std::optional<double> humidity_percent(const Measure& m) {
  return m.unit.empty() || m.unit == "%" || m.unit == "%rh" || m.unit == "% rh" ? std::optional(m.value) : std::nullopt;
}

/// Coefficients below a thousandth are per kelvin, the others ppm per kelvin: nothing expands by 1000 ppm.
std::optional<double> expansion_ppm(const Measure& m) { return m.value < 1e-3 ? m.value * 1e6 : m.value; }

struct AirItem {
  std::string_view tag;
  std::string_view key;  ///< of the start, with "_start" in it
  std::optional<double> (*value)(const Measure&);
};

constexpr AirItem air_items[] = {
    {"air temp", "environment.air_temperature_start_C", temperature_C},
    {"air press", "environment.air_pressure_start_kPa", pressure_kPa},
    {"air humid", "environment.air_humidity_start_percent", humidity_percent},
    {"exp coeff", "nde.machine_expansion_um_per_m_C", expansion_ppm},
};

std::string key_at(std::string_view key, bool at_end) {
  std::string result(key);
  if (const std::size_t start = result.find("_start"); at_end && start != std::string::npos)
    result.replace(start, 6, "_end");
  return result;
}

std::unexpected<Error> too_many(std::string_view what, const TextLine& line) {
  return fail(fmt::format("found more than {} records of {}, expected fewer", read_budget::records, what),
              {line.number, line.column});
}

/// Values behind "Final Data" are those at the end of the test.
class Environments {
 public:
  Environments(Metadata& metadata, std::vector<SourceRemark>& remarks) : metadata_(metadata), remarks_(remarks) {}

  Result<void> take(const TextLine& line) {
    const auto item = tagged_value(line.text);
    if (plain_name(line.text).starts_with("final data")) at_end_ = true;
    if (!item || item->value.empty()) return {};
    if (item->tag == "date time" && metadata_.conditions.date.empty()) metadata_.conditions.date = item->value;
    if (item->tag.starts_with("mat temp")) AXIOMETRY_TRY_VOID(take_material(*item, line));
    for (const AirItem& air : air_items)
      if (item->tag.starts_with(air.tag)) take_air(air, *item, line);
    return {};
  }

 private:
  void not_understood(const TextLine& line) {
    remarks_.push_back({false, fmt::format("found {} on line {}, which was not understood and is left out",
                                           text::quoted(line.text), line.number)});
  }

  /// A sensor of zero is none: no test is made in air of 0 °C, 0 mbar or 0 %, and one material temperature of zero
  /// would draw the mean of all far away.
  void not_connected(const TextLine& line) {
    remarks_.push_back({false, fmt::format("found {} on line {}; it was taken as a sensor that is not connected",
                                           text::quoted(line.text), line.number)});
  }

  void take_air(const AirItem& air, const TaggedValue& item, const TextLine& line) {
    const auto measure = measure_from(item.value);
    const double value = measure ? air.value(*measure).value_or(NAN) : NAN;
    if (measure && measure->value == 0.0 && air.tag != "exp coeff") return not_connected(line);
    const Field* field = find_field(key_at(air.key, at_end_));
    if (field == nullptr || !set_field(metadata_, *field, value)) return not_understood(line);
    if (air.tag == "exp coeff" && value != 0.0)
      remarks_.push_back({false, fmt::format("found an expansion coefficient of {} µm/(m·°C); the file does not say "
                                             "whether the instrument corrected the readings with it",
                                             format_exact(value))});
  }

  Result<void> take_material(const TaggedValue& item, const TextLine& line) {
    const auto measure = measure_from(item.value);
    const auto value = measure ? temperature_C(*measure) : std::nullopt;
    if (!value || !(*value >= -60.0 && *value <= 100.0)) {
      not_understood(line);
      return {};
    }
    if (measure->value == 0.0) {
      not_connected(line);
      return {};
    }
    auto& sensors = metadata_.environment.sensors;
    auto sensor = std::ranges::find(sensors, item.tag, &TemperatureSensor::location);
    if (sensor == sensors.end() && sensors.size() == read_budget::records) return too_many("sensors", line);
    if (sensor == sensors.end())
      sensor = sensors.insert(sensors.end(), TemperatureSensor{"machine", item.tag, std::nullopt, std::nullopt});
    (at_end_ ? sensor->end : sensor->start) = Temperature::celsius(*value);
    return {};
  }

  Metadata& metadata_;
  std::vector<SourceRemark>& remarks_;
  bool at_end_ = false;
};

Result<void> add_equipment(Metadata& metadata, std::span<const TextLine> lines) {
  for (const TextLine& line : lines) {
    const auto item = tagged_value(line.text);
    const std::string_view value = item ? item->value : line.text;
    if (value.empty()) continue;
    if (metadata.equipment.size() == read_budget::records) return too_many("equipment", line);
    const bool serial = item && item->tag.contains("serial");
    Equipment part{.role = item ? item->tag : "equipment", .manufacturer = "", .type = "", .serial_number = ""};
    (serial ? part.serial_number : part.type) = value;
    metadata.equipment.push_back(std::move(part));
  }
  return {};
}

}  // namespace

Result<std::vector<SourceRemark>> add_conditions(Metadata& metadata, const RtlConditions& conditions) {
  std::vector<SourceRemark> remarks;
  for (const TextLine& line : conditions.user_text) {
    const auto item = tagged_value(line.text);
    if (!item || item->value.empty()) continue;
    for (const TextItem& text : text_items)
      if (text.tag == item->tag)
        AXIOMETRY_CONTRACT(set_field(metadata, *find_field(text.key), std::string(item->value)).has_value());
  }
  AXIOMETRY_TRY_VOID(add_equipment(metadata, conditions.equipment));
  Environments environments(metadata, remarks);
  for (const TextLine& line : conditions.environment) AXIOMETRY_TRY_VOID(environments.take(line));
  return remarks;
}

}  // namespace axiometry::formats
