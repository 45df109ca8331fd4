// SPDX-License-Identifier: Apache-2.0
//
// The rows of the metadata vocabulary. A new member of Metadata gets its row here and nothing else.
#include <array>

#include "axiometry/model/fields.h"

namespace axiometry {
namespace {

using Wanted = Field::Wanted;

// How a member's type is read and written as a FieldValue. A quantity brings its unit as a pair of
// functions; optionals are absent when not given.

template <typename T>
struct InUnit {
  T (*make)(double);
  double (T::*read)() const;
};

constexpr InUnit<Length> mm{&Length::mm, &Length::in_mm};
constexpr InUnit<Temperature> celsius{&Temperature::celsius, &Temperature::in_celsius};
constexpr InUnit<TemperatureDifference> kelvin{&TemperatureDifference::kelvin, &TemperatureDifference::in_kelvin};
constexpr InUnit<ExpansionCoefficient> per_m_K{&ExpansionCoefficient::um_per_m_K, &ExpansionCoefficient::in_um_per_m_K};
constexpr InUnit<RelativeLength> per_m{&RelativeLength::um_per_m, &RelativeLength::in_um_per_m};
constexpr InUnit<Duration> seconds{&Duration::s, &Duration::in_s};
constexpr InUnit<Pressure> kilopascal{&Pressure::kPa, &Pressure::in_kPa};
constexpr InUnit<RelativeHumidity> percent{&RelativeHumidity::percent, &RelativeHumidity::in_percent};
constexpr InUnit<Position> position{&Position::native, &Position::in_native};
constexpr InUnit<Deviation> deviation{&Deviation::native, &Deviation::in_native};

/// Members as a path of pointers to members: At<&Metadata::machine, &Machine::name>.
template <auto Group, auto Member>
struct At {
  static auto& in(Metadata& m) { return m.*Group.*Member; }
  static const auto& in(const Metadata& m) { return m.*Group.*Member; }
};

template <typename Path>
struct TextAccess {
  static FieldValue get(const Metadata& m) { return Path::in(m).empty() ? FieldValue{} : FieldValue(Path::in(m)); }
  static void put(Metadata& m, const FieldValue& value) {
    const auto* s = std::get_if<std::string>(&value);
    Path::in(m) = s ? *s : std::string();
  }
};

template <typename Path, const auto& Unit>
struct QuantityAccess {
  static FieldValue get(const Metadata& m) {
    const auto& member = Path::in(m);
    return member ? FieldValue(((*member).*(Unit.read))()) : FieldValue{};
  }
  static void put(Metadata& m, const FieldValue& value) {
    const auto* x = std::get_if<double>(&value);
    if (x) {
      Path::in(m) = Unit.make(*x);
    } else {
      Path::in(m).reset();
    }
  }
};

/// Optional plain members: bool and double.
template <typename Path, typename T>
struct PlainAccess {
  static FieldValue get(const Metadata& m) { return Path::in(m) ? FieldValue(*Path::in(m)) : FieldValue{}; }
  static void put(Metadata& m, const FieldValue& value) {
    const auto* x = std::get_if<T>(&value);
    Path::in(m) = x ? std::optional<T>(*x) : std::nullopt;
  }
};

template <typename Path>
struct NumbersAccess {
  static FieldValue get(const Metadata& m) { return Path::in(m).empty() ? FieldValue{} : FieldValue(Path::in(m)); }
  static void put(Metadata& m, const FieldValue& value) {
    const auto* list = std::get_if<std::vector<double>>(&value);
    Path::in(m) = list ? *list : std::vector<double>{};
  }
};

constexpr std::string_view kind_words[] = {"linear", "rotary"};
constexpr std::string_view cycle_words[] = {"standard", "step", "pilgrim", "unidirectional"};

/// An enumeration by its words, the first being the default (and so never "not given").
template <typename Path, const auto& Words>
struct ChoiceAccess {
  static FieldValue get(const Metadata& m) { return std::string(Words[static_cast<std::size_t>(Path::in(m))]); }
  static void put(Metadata& m, const FieldValue& value) {
    auto& member = Path::in(m);
    member = {};
    const auto* word = std::get_if<std::string>(&value);
    for (std::size_t k = 0; word && k < std::size(Words); ++k)
      if (Words[k] == *word) member = static_cast<std::remove_reference_t<decltype(member)>>(k);
  }
};

constexpr RecordColumn equipment_columns[] = {
    {"role", "Component", FieldType::text, ""},
    {"manufacturer", "Manufacturer", FieldType::text, ""},
    {"type", "Type", FieldType::text, ""},
    {"serial_number", "Serial number", FieldType::text, ""},
};
constexpr RecordColumn sensor_columns[] = {
    {"role", "Sensor", FieldType::text, ""},
    {"location", "Location", FieldType::text, ""},
    {"start_C", "Start", FieldType::number, "°C"},
    {"end_C", "End", FieldType::number, "°C"},
};

Cell text_cell(const std::string& s) { return s.empty() ? Cell{} : Cell(s); }
std::string text_of(const Cell& cell) {
  const auto* s = std::get_if<std::string>(&cell);
  return s ? *s : std::string();
}
Cell temperature_cell(const std::optional<Temperature>& t) { return t ? Cell(t->in_celsius()) : Cell{}; }
std::optional<Temperature> temperature_of(const Cell& cell) {
  const auto* x = std::get_if<double>(&cell);
  return x ? std::optional(Temperature::celsius(*x)) : std::nullopt;
}

struct EquipmentAccess {
  static FieldValue get(const Metadata& m) {
    Records records;
    for (const Equipment& e : m.equipment)
      records.push_back({text_cell(e.role), text_cell(e.manufacturer), text_cell(e.type), text_cell(e.serial_number)});
    return records.empty() ? FieldValue{} : FieldValue(std::move(records));
  }
  static void put(Metadata& m, const FieldValue& value) {
    m.equipment.clear();
    if (const auto* records = std::get_if<Records>(&value))
      for (const auto& r : *records)
        m.equipment.push_back({text_of(r[0]), text_of(r[1]), text_of(r[2]), text_of(r[3])});
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

constexpr double any = 1e6;  // far beyond any machine, so that only slips of the pen are refused

template <typename Access>
constexpr Field text_field(std::string_view key, std::string_view title, std::string_view clause, Wanted wanted,
                           std::string_view description) {
  return {key, title, FieldType::text, "", "", clause, wanted, 0, 0, {}, {}, description, &Access::get, &Access::put};
}

template <typename Access>
constexpr Field number_field(std::string_view key, std::string_view title, std::string_view unit_linear,
                             std::string_view unit_rotary, std::string_view clause, Wanted wanted, double minimum,
                             double maximum, std::string_view description) {
  return {key, title, FieldType::number, unit_linear,  unit_rotary, clause, wanted, minimum, maximum,
          {},  {},    description,       &Access::get, &Access::put};
}

template <typename Access>
constexpr Field numbers_field(std::string_view key, std::string_view title, std::string_view unit_linear,
                              std::string_view unit_rotary, std::string_view clause, Wanted wanted,
                              std::string_view description) {
  return {key, title, FieldType::numbers, unit_linear,  unit_rotary, clause, wanted, -any, any,
          {},  {},    description,        &Access::get, &Access::put};
}

template <typename Access>
constexpr Field choice_field(std::string_view key, std::string_view title, std::string_view clause,
                             std::span<const std::string_view> words, std::string_view description) {
  return {key,   title, FieldType::choice, "",           "",          clause, Wanted::no, 0, 0,
          words, {},    description,       &Access::get, &Access::put};
}

template <auto Group, auto Member>
using TextAt = TextAccess<At<Group, Member>>;
template <auto Group, auto Member, const auto& Unit>
using QuantityAt = QuantityAccess<At<Group, Member>, Unit>;

template <auto Member>
using MachineText = TextAt<&Metadata::machine, Member>;
template <auto Member>
using AxisText = TextAt<&Metadata::axis, Member>;
template <auto Member>
using TestText = TextAt<&Metadata::conditions, Member>;
template <auto Member, const auto& Unit>
using AirQuantity = QuantityAt<&Metadata::environment, Member, Unit>;
template <auto Member, const auto& Unit>
using AnnexAQuantity = QuantityAt<&Metadata::uncertainty, Member, Unit>;

using Conditions = TestConditions;

constexpr std::array fields = {
    text_field<TestText<&Conditions::report_number>>("test.report_number", "Report number", "", Wanted::no,
                                                     "Number of the report or certificate."),
    text_field<TestText<&Conditions::date>>("test.date", "Date of test", "8.1", Wanted::always,
                                            "Date of the test, ISO 8601 preferred."),
    text_field<TestText<&Conditions::inspector>>("test.inspector", "Name of inspector", "8.1", Wanted::always,
                                                 "Who made the test."),
    text_field<TestText<&Conditions::customer>>("test.customer", "Customer", "", Wanted::no,
                                                "For whom the test was made."),
    text_field<TestText<&Conditions::purpose>>("test.purpose", "Purpose", "", Wanted::no,
                                               "Acceptance, reverification, compensation, …"),
    text_field<MachineText<&Machine::name>>("machine.name", "Machine name", "8.1", Wanted::always,
                                            "Maker and model of the machine."),
    text_field<MachineText<&Machine::type>>("machine.type", "Machine type", "8.1", Wanted::always,
                                            "Horizontal or vertical spindle and kind of machine."),
    text_field<MachineText<&Machine::serial_number>>("machine.serial_number", "Machine serial number", "", Wanted::no,
                                                     "Serial number of the machine."),
    text_field<MachineText<&Machine::axes_travel>>("machine.axes_travel", "Travels of the coordinate axes", "8.1",
                                                   Wanted::always, "Travels of all coordinate axes, as text."),
    text_field<MachineText<&Machine::location>>("machine.location", "Location", "", Wanted::no,
                                                "Where the machine stands."),
    text_field<AxisText<&Axis::name>>("axis.name", "Axis under test", "8.1", Wanted::always,
                                      "Letter or name of the axis."),
    choice_field<ChoiceAccess<At<&Metadata::axis, &Axis::kind>, kind_words>>(
        "axis.kind", "Kind of axis", "1", kind_words, "Linear (mm, µm) or rotary (degrees, seconds of arc)."),
    number_field<QuantityAt<&Metadata::axis, &Axis::travel_begin, position>>("axis.travel_begin", "Axis travel, from",
                                                                             "mm", "°", "3.1", Wanted::no, -any, any,
                                                                             "Lower end of the axis travel."),
    number_field<QuantityAt<&Metadata::axis, &Axis::travel_end, position>>(
        "axis.travel_end", "Axis travel, to", "mm", "°", "3.1", Wanted::no, -any, any, "Upper end of the axis travel."),
    text_field<AxisText<&Axis::measurement_line>>("axis.measurement_line", "Measurement line or orientation", "8.1",
                                                  Wanted::always,
                                                  "Linear: where the line lies relative to the other axes. Rotary: "
                                                  "where the axis lies and how it points."),
    text_field<AxisText<&Axis::scale_type>>("axis.scale_type", "Type of scale", "8.1", Wanted::always,
                                            "Ball screw and rotary encoder, linear scale, …"),
    number_field<QuantityAt<&Metadata::axis, &Axis::scale_expansion, per_m_K>>(
        "axis.scale_expansion_um_per_m_C", "Expansion coefficient of the scale", "µm/(m·°C)", "µm/(m·°C)", "8.1",
        Wanted::linear, -50, 100, "Coefficient of thermal expansion of the machine scale."),
    text_field<AxisText<&Axis::compensation>>(
        "axis.compensation", "Compensation used", "8.1", Wanted::always,
        "Built-in compensation during the test, such as 'reversal and leadscrew'; 'none' is an answer."),
    numbers_field<NumbersAccess<At<&Metadata::axis, &Axis::compensation_points>>>(
        "axis.compensation_points", "Sampling points of the compensation", "mm", "°", "5.2", Wanted::no,
        "Positions of the compensation table, which the targets must not repeat."),
    choice_field<ChoiceAccess<At<&Metadata::conditions, &Conditions::cycle>, cycle_words>>(
        "test.cycle", "Test cycle", "5.3.2", cycle_words,
        "Standard test cycle (Figure 1), step cycle (Annex B), pilgrim or unidirectional."),
    number_field<PlainAccess<At<&Metadata::conditions, &Conditions::feed>, double>>(
        "test.feed", "Feed speed", "mm/min", "°/min", "8.1", Wanted::always, 0, 1e7, "Feed speed between targets."),
    number_field<QuantityAt<&Metadata::conditions, &Conditions::dwell, seconds>>(
        "test.dwell_s", "Dwell time at each target", "s", "s", "8.1", Wanted::always, 0, any,
        "Dwell time at each target position."),
    text_field<TestText<&Conditions::warm_up>>("test.warm_up", "Warm-up operation", "8.1", Wanted::always,
                                               "How long or how often the axis was moved beforehand, and how fast."),
    text_field<TestText<&Conditions::axes_not_under_test>>("test.axes_not_under_test",
                                                           "Position of axes not under test", "8.1", Wanted::always,
                                                           "Such as 'Y = 300 mm; Z = 350 mm; C = 0°'."),
    numbers_field<NumbersAccess<At<&Metadata::conditions, &Conditions::tool_offset_mm>>>(
        "test.tool_offset_mm", "Offset to tool reference X/Y/Z", "mm", "mm", "8.1", Wanted::always, "Three numbers."),
    numbers_field<NumbersAccess<At<&Metadata::conditions, &Conditions::workpiece_offset_mm>>>(
        "test.workpiece_offset_mm", "Offset to workpiece reference X/Y/Z", "mm", "mm", "8.1", Wanted::always,
        "Three numbers."),
    text_field<TestText<&Conditions::air_or_oil_shower>>("test.air_or_oil_shower", "Air or oil shower", "8.1",
                                                         Wanted::no, "When applied."),
    text_field<TestText<&Conditions::comment>>("test.comment", "Comment", "", Wanted::no, "Anything else."),
    Field{"equipment",
          "Test equipment",
          FieldType::records,
          "",
          "",
          "8.1",
          Wanted::always,
          0,
          0,
          {},
          equipment_columns,
          "Every component of the measuring instrument: laser head, optics, sensors.",
          &EquipmentAccess::get,
          &EquipmentAccess::put},
    Field{"nde.applied",
          "NDE correction applied",
          FieldType::boolean,
          "",
          "",
          "8.1",
          Wanted::linear,
          0,
          0,
          {},
          {},
          "Whether nominal differential expansion was corrected mathematically.",
          &PlainAccess<At<&Metadata::nde, &NdeCorrection::applied>, bool>::get,
          &PlainAccess<At<&Metadata::nde, &NdeCorrection::applied>, bool>::put},
    number_field<QuantityAt<&Metadata::nde, &NdeCorrection::machine_expansion, per_m_K>>(
        "nde.machine_expansion_um_per_m_C", "Expansion coefficient used, machine", "µm/(m·°C)", "µm/(m·°C)", "8.1",
        Wanted::with_nde, -50, 100, "Coefficient used for the machine's expansion."),
    number_field<QuantityAt<&Metadata::nde, &NdeCorrection::equipment_expansion, per_m_K>>(
        "nde.equipment_expansion_um_per_m_C", "Expansion coefficient used, equipment", "µm/(m·°C)", "µm/(m·°C)", "8.1",
        Wanted::no, -50, 100, "Coefficient used for the measuring equipment's expansion."),
    text_field<TextAt<&Metadata::nde, &NdeCorrection::routine>>(
        "nde.routine", "Compensation routine", "8.1", Wanted::with_nde, "How often the correction is updated."),
    Field{"sensors",
          "Temperature sensors",
          FieldType::records,
          "",
          "",
          "8.1",
          Wanted::with_nde,
          0,
          0,
          {},
          sensor_columns,
          "Sensors with their readings at the start and the end; role is machine, equipment or air.",
          &SensorAccess::get,
          &SensorAccess::put},
    number_field<AirQuantity<&Environment::air_temperature_start, celsius>>(
        "environment.air_temperature_start_C", "Air temperature at the start", "°C", "°C", "8.1", Wanted::linear, -60,
        100, "Near the laser beam."),
    number_field<AirQuantity<&Environment::air_temperature_end, celsius>>(
        "environment.air_temperature_end_C", "Air temperature at the end", "°C", "°C", "8.1", Wanted::linear, -60, 100,
        "Near the laser beam."),
    number_field<AirQuantity<&Environment::air_pressure_start, kilopascal>>(
        "environment.air_pressure_start_kPa", "Air pressure at the start", "kPa", "kPa", "8.1", Wanted::linear, 20, 150,
        "Near the laser beam."),
    number_field<AirQuantity<&Environment::air_pressure_end, kilopascal>>(
        "environment.air_pressure_end_kPa", "Air pressure at the end", "kPa", "kPa", "8.1", Wanted::linear, 20, 150,
        "Near the laser beam."),
    number_field<AirQuantity<&Environment::air_humidity_start, percent>>(
        "environment.air_humidity_start_percent", "Air humidity at the start", "%", "%", "8.1", Wanted::linear, 0, 100,
        "Near the laser beam."),
    number_field<AirQuantity<&Environment::air_humidity_end, percent>>("environment.air_humidity_end_percent",
                                                                       "Air humidity at the end", "%", "%", "8.1",
                                                                       Wanted::linear, 0, 100, "Near the laser beam."),
    number_field<AnnexAQuantity<&AnnexAInputs::length, mm>>("uncertainty.length_mm", "Measurement length L", "mm", "",
                                                            "A.2.2", Wanted::no, 1e-3, any,
                                                            "The measured travel when not given."),
    number_field<AnnexAQuantity<&AnnexAInputs::device_calibration, deviation>>(
        "uncertainty.device_calibration", "Calibration uncertainty of the device (k = 2)", "µm", "″", "A.1", Wanted::no,
        0, any, "U of the calibration certificate."),
    number_field<AnnexAQuantity<&AnnexAInputs::device_calibration_per_length, per_m>>(
        "uncertainty.device_calibration_um_per_m", "Calibration uncertainty of the device (k = 2)", "µm/m", "", "A.2",
        Wanted::no, 0, any, "U of the calibration certificate per metre."),
    number_field<AnnexAQuantity<&AnnexAInputs::device_error_range, per_m>>(
        "uncertainty.device_error_range_um_per_m", "Error range of the device", "µm/m", "", "A.3", Wanted::no, 0, any,
        "Full range stated by the manufacturer."),
    number_field<AnnexAQuantity<&AnnexAInputs::misalignment, mm>>("uncertainty.misalignment_mm", "Misalignment", "mm",
                                                                  "", "A.4", Wanted::no, 0, any,
                                                                  "Of the measuring device to the axis."),
    number_field<AnnexAQuantity<&AnnexAInputs::machine_expansion, per_m_K>>(
        "uncertainty.machine_expansion_um_per_m_C", "Expansion coefficient of the machine", "µm/(m·°C)", "", "A.5",
        Wanted::no, 0, 100, "That of the scale when not given, else 12."),
    number_field<AnnexAQuantity<&AnnexAInputs::machine_temperature_range, kelvin>>(
        "uncertainty.machine_temperature_range_C", "Range of the temperature measurement, machine", "°C", "", "A.5",
        Wanted::no, 0, 100, "Full range R(θ): 1 °C is ±0.5 °C."),
    number_field<AnnexAQuantity<&AnnexAInputs::machine_temperature_difference, kelvin>>(
        "uncertainty.machine_temperature_difference_C", "Largest difference to 20 °C, machine", "°C", "", "A.7",
        Wanted::no, -100, 100, "From the machine's temperature sensors when not given."),
    number_field<AnnexAQuantity<&AnnexAInputs::machine_expansion_range, per_m_K>>(
        "uncertainty.machine_expansion_range_um_per_m_C", "Range of the expansion coefficient, machine", "µm/(m·°C)",
        "", "A.7", Wanted::no, 0, 100, "Full range R(α); 2 when not given."),
    number_field<AnnexAQuantity<&AnnexAInputs::device_expansion, per_m_K>>(
        "uncertainty.device_expansion_um_per_m_C", "Expansion coefficient of the device", "µm/(m·°C)", "", "A.6",
        Wanted::no, 0, 100, "Only when the device's statement does not include temperature."),
    number_field<AnnexAQuantity<&AnnexAInputs::device_temperature_range, kelvin>>(
        "uncertainty.device_temperature_range_C", "Range of the temperature measurement, device", "°C", "", "A.6",
        Wanted::no, 0, 100, "Full range R(θ)."),
    number_field<AnnexAQuantity<&AnnexAInputs::device_temperature_difference, kelvin>>(
        "uncertainty.device_temperature_difference_C", "Largest difference to 20 °C, device", "°C", "", "A.8",
        Wanted::no, -100, 100, "Only when the device's statement does not include temperature."),
    number_field<AnnexAQuantity<&AnnexAInputs::device_expansion_range, per_m_K>>(
        "uncertainty.device_expansion_range_um_per_m_C", "Range of the expansion coefficient, device", "µm/(m·°C)", "",
        "A.8", Wanted::no, 0, 100, "Full range R(α)."),
    number_field<AnnexAQuantity<&AnnexAInputs::environmental_variation, deviation>>(
        "uncertainty.environmental_variation", "Environmental variation error", "µm", "″", "A.9", Wanted::no, 0, any,
        "Range E_VE of the drift test."),
};

}  // namespace

std::span<const Field> metadata_fields() { return fields; }

}  // namespace axiometry
