// SPDX-License-Identifier: Apache-2.0
//
// The rows of the metadata vocabulary. A new member of Metadata gets its row here and nothing else.
#include <array>

#include "axiometry/model/fields_records.h"

namespace axiometry {
namespace {

using namespace fields_access;
using Wanted = Field::Wanted;

constexpr std::string_view kind_words[] = {"linear", "rotary"};
constexpr std::string_view rule_words[] = {"simple", "iso14253-1", "guard-band"};
constexpr std::string_view cycle_words[] = {"standard", "step", "pilgrim", "unidirectional", "user-defined"};
constexpr std::string_view measurand_words[] = {"this-test", "this-machine"};
constexpr std::string_view method_words[] = {"annex-a", "gum", "monte-carlo"};
constexpr std::string_view environment_words[] = {"unknown", "white", "drift", "random-walk"};
constexpr std::string_view sum_words[] = {"linear", "quadratic"};

template <auto Group, auto Member>
using TextAt = TextAccess<At<Group, Member>>;
template <auto Group, auto Member, const auto& Unit>
using QuantityAt = QuantityAccess<At<Group, Member>, Unit>;

/// The limit of a parameter. Zero would be a limit that no measurement can keep.
template <auto Member>
constexpr Field tolerance_field(std::string_view key, std::string_view title) {
  constexpr double smallest = 1e-6;
  return number_field<QuantityAt<&Metadata::tolerance, Member, deviation>>(key, title, "µm", "″", "8.2", Wanted::no,
                                                                           smallest, any, "Upper limit.");
}

template <auto Member>
using MachineText = TextAt<&Metadata::machine, Member>;
template <auto Member>
using AxisText = TextAt<&Metadata::axis, Member>;
template <auto Member>
using TestText = TextAt<&Metadata::conditions, Member>;
template <auto Member, const auto& Unit>
using AirQuantity = QuantityAt<&Metadata::environment, Member, Unit>;
template <auto Member, const auto& Unit>
using InstrumentQuantity = QuantityAt<&Metadata::instrument, Member, Unit>;
template <auto Member, typename T>
using InstrumentPlain = PlainAccess<At<&Metadata::instrument, Member>, T>;
template <auto Member>
using ArtefactText = TextAt<&Metadata::artefact, Member>;
template <auto Member, const auto& Unit>
using ArtefactQuantity = QuantityAt<&Metadata::artefact, Member, Unit>;
template <auto Member, const auto& Unit>
using AnnexAQuantity = QuantityAt<&Metadata::uncertainty, Member, Unit>;
template <auto Member, const auto& Unit>
using GumQuantity = QuantityAt<&Metadata::gum, Member, Unit>;

using Conditions = TestConditions;

constexpr std::array fields = {
    text_field<TestText<&Conditions::report_number>>("test.report_number", "Report number", "", Wanted::no,
                                                     "Number of the report or certificate."),
    text_field<TestText<&Conditions::date>>("test.date", "Date of test", "8.1", Wanted::always,
                                            "Date of the test, ISO 8601 preferred."),
    text_field<TestText<&Conditions::inspector>>("test.inspector", "Name of inspector", "8.1", Wanted::always,
                                                 "Who made the test."),
    text_field<TestText<&Conditions::laboratory>>("test.laboratory", "Laboratory", "", Wanted::no,
                                                  "Laboratory or company that vouches for the report."),
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
    number_field<QuantityAt<&Metadata::axis, &Axis::expected_period, position>>(
        "axis.expected_period", "Expected period of a periodic error", "mm", "°", "5.2", Wanted::no, 0, any,
        "Pitch of the screw or of the scale, when known."),
    numbers_field<NumbersAccess<At<&Metadata::axis, &Axis::line_origin_mm>>>(
        "axis.line_origin_mm", "Line in space, origin X/Y/Z", "mm", "mm", "", Wanted::no,
        "Where X, Y and Z stand at position 0 of a line that is driven in space, such as a diagonal."),
    numbers_field<NumbersAccess<At<&Metadata::axis, &Axis::line_direction>>>(
        "axis.line_direction", "Line in space, direction X/Y/Z", "", "", "", Wanted::no,
        "Where position grows along the line, of any length: 1 1 0 is the diagonal of X and Y. Several axes that "
        "move at once make a test after ISO 230-6."),
    choice_field<OptionalChoiceAccess<At<&Metadata::conditions, &Conditions::cycle>, cycle_words>>(
        "test.cycle", "Test cycle", "5.3.2", cycle_words,
        "Standard test cycle (Figure 1), step cycle (Annex B), pilgrim, unidirectional or user-defined."),
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
    Field{"test.smaller_repeatability",
          "Tell the smaller of R↑ and R↓",
          FieldType::boolean,
          "",
          "",
          "",
          Wanted::no,
          0,
          0,
          {},
          {},
          "Whether min(R↑, R↓), as lists of export controls use it, is told for information; not a parameter of the "
          "standard.",
          &PlainAccess<At<&Metadata::conditions, &Conditions::smaller_repeatability>, bool>::get,
          &PlainAccess<At<&Metadata::conditions, &Conditions::smaller_repeatability>, bool>::put},
    text_field<TestText<&Conditions::comment>>("test.comment", "Comment", "", Wanted::no, "Anything else."),
    records_field<EquipmentAccess>("equipment", "Test equipment", "8.1", Wanted::always, equipment_columns,
                                   "Every component of the measuring instrument: laser head, optics, sensors."),
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
    number_field<QuantityAt<&Metadata::nde, &NdeCorrection::datum, position>>(
        "nde.datum", "Datum of the instrument", "mm", "°", "", Wanted::no, -any, any,
        "Position at which the instrument was set to zero, where a correction by this program is none; the first "
        "target when not given."),
    records_field<SensorAccess>(
        "sensors", "Temperature sensors", "8.1", Wanted::with_nde, sensor_columns,
        "Sensors with their readings at the start and the end; role is machine, equipment or air."),
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
    stated_field<&StatedEnvironment::lowest, celsius>("environment.lowest_C", "Lowest temperature of the air", "7",
                                                      coldest_hall_C),
    stated_field<&StatedEnvironment::highest, celsius>("environment.highest_C", "Highest temperature of the air", "7",
                                                       coldest_hall_C),
    stated_rate<&StatedEnvironment::rate>("environment.rate_C_per_h", "Change per hour, during the test"),
    stated_rate<&StatedEnvironment::rate_before>("environment.rate_before_C_per_h",
                                                 "Change per hour, in the twelve hours before"),
    stated_field<&StatedEnvironment::machine_gradient, kelvin>("environment.machine_gradient_C",
                                                               "Gradient over the machine", "4.1", 0),
    soaked_field("environment.soaked_h", "Time of soaking"),
    agreed_field<&AgreedEnvironment::lowest, celsius>("environment.agreed_lowest_C", "Agreed lowest temperature", "7",
                                                      coldest_hall_C),
    agreed_field<&AgreedEnvironment::highest, celsius>("environment.agreed_highest_C", "Agreed highest temperature",
                                                       "7", coldest_hall_C),
    agreed_rate("environment.agreed_rate_C_per_h", "Agreed change per hour"),
    agreed_field<&AgreedEnvironment::machine_gradient, kelvin>("environment.agreed_gradient_C",
                                                               "Agreed gradient over the machine", "4.1", 0),
    number_field<InstrumentQuantity<&InstrumentSettings::vacuum_wavelength, nm>>(
        "instrument.vacuum_wavelength_nm", "Vacuum wavelength", "nm", "nm", "", Wanted::no, 100, 20000,
        "Of the laser, for the correction of readings for the refractive index of air; 632.9909 when not given."),
    number_field<InstrumentPlain<&InstrumentSettings::refractive_index, double>>(
        "instrument.refractive_index", "Refractive index assumed by the instrument", "", "", "", Wanted::no, 1, 1.01,
        "1 when the instrument shows lengths in vacuum wavelengths; wanted for the correction for the air."),
    number_field<InstrumentQuantity<&InstrumentSettings::dead_path, mm>>(
        "instrument.dead_path_mm", "Dead path", "mm", "mm", "", Wanted::no, -any, any,
        "Distance between the fixed and the moving optics at the datum that the instrument does not compensate."),
    number_field<InstrumentPlain<&InstrumentSettings::air_co2_ppm, double>>(
        "instrument.air_co2_ppm", "Carbon dioxide in the air", "ppm", "ppm", "", Wanted::no, 0, 20000,
        "By volume; 450 when not given."),
    number_field<InstrumentPlain<&InstrumentSettings::gain, double>>(
        "instrument.gain", "Gain of the sensor", "", "", "", Wanted::no, -any, any,
        "True change of position per change shown; applied to the readings only on request."),
    Field{"instrument.sign_reversed",
          "Sign reversed",
          FieldType::boolean,
          "",
          "",
          "",
          Wanted::no,
          0,
          0,
          {},
          {},
          "Whether the instrument counts up when the axis moves in the negative direction.",
          &InstrumentPlain<&InstrumentSettings::sign_reversed, bool>::get,
          &InstrumentPlain<&InstrumentSettings::sign_reversed, bool>::put},
    text_field<ArtefactText<&Artefact::type>>("artefact.type", "Artefact", "Annex D", Wanted::no,
                                              "Ball array or step gauge."),
    text_field<ArtefactText<&Artefact::serial_number>>("artefact.serial_number", "Serial number of the artefact",
                                                       "Annex D", Wanted::no, "Serial number of the artefact."),
    text_field<ArtefactText<&Artefact::certificate>>("artefact.certificate", "Calibration certificate", "Annex D",
                                                     Wanted::no, "Number and date of the certificate."),
    numbers_field<NumbersAccess<At<&Metadata::artefact, &Artefact::calibrated_positions>>>(
        "artefact.calibrated_positions", "Calibrated positions", "mm", "mm", "Annex D", Wanted::no,
        "Of the balls or faces at 20 °C, one per target and in their order; the readings are then positions that the "
        "machine indicated at them."),
    number_field<ArtefactQuantity<&Artefact::calibration_uncertainty, deviation>>(
        "artefact.calibration_uncertainty", "Calibration uncertainty of the artefact", "µm", "″", "Annex D", Wanted::no,
        0, any, "U, k = 2, of every calibrated position."),
    number_field<ArtefactQuantity<&Artefact::calibration_uncertainty_per_length, per_m>>(
        "artefact.calibration_uncertainty_um_per_m", "Calibration uncertainty of the artefact, by length", "µm/m",
        "µm/m", "Annex D", Wanted::no, 0, any, "U, k = 2, in proportion to the length."),
    choice_field<OptionalChoiceAccess<At<&Metadata::artefact, &Artefact::calibration_sum>, sum_words>>(
        "artefact.calibration_sum", "Sum of both parts of the artefact's calibration uncertainty", "Annex D", sum_words,
        "How a constant part and one per metre make U: a + b·L (when not given), or the root of their squares."),
    number_field<ArtefactQuantity<&Artefact::probing_uncertainty, deviation>>(
        "artefact.probing_uncertainty", "Probing uncertainty", "µm", "″", "Annex D", Wanted::no, 0, any,
        "U, k = 2, of one probing."),
    tolerance_field<&StatedTolerances::A>("tolerance.A", "Tolerance of A"),
    tolerance_field<&StatedTolerances::A_up>("tolerance.A_up", "Tolerance of A↑"),
    tolerance_field<&StatedTolerances::A_down>("tolerance.A_down", "Tolerance of A↓"),
    tolerance_field<&StatedTolerances::E>("tolerance.E", "Tolerance of E"),
    tolerance_field<&StatedTolerances::E_up>("tolerance.E_up", "Tolerance of E↑"),
    tolerance_field<&StatedTolerances::E_down>("tolerance.E_down", "Tolerance of E↓"),
    tolerance_field<&StatedTolerances::M>("tolerance.M", "Tolerance of M"),
    tolerance_field<&StatedTolerances::R>("tolerance.R", "Tolerance of R"),
    tolerance_field<&StatedTolerances::R_up>("tolerance.R_up", "Tolerance of R↑"),
    tolerance_field<&StatedTolerances::R_down>("tolerance.R_down", "Tolerance of R↓"),
    tolerance_field<&StatedTolerances::B>("tolerance.B", "Tolerance of B"),
    tolerance_field<&StatedTolerances::B_mean>("tolerance.B_mean", "Tolerance of |B̄|"),
    text_field<TextAt<&Metadata::tolerance, &StatedTolerances::table>>(
        "tolerance.table", "Tolerance table", "", Wanted::no, "Which of the names in a file of tolerance tables."),
    choice_field<TextAt<&Metadata::tolerance, &StatedTolerances::rule>>(
        "tolerance.rule", "Decision rule", "", rule_words,
        "How the uncertainty counts in a verdict: simple acceptance, ISO 14253-1, or a guard band of a given width."),
    number_field<QuantityAt<&Metadata::tolerance, &StatedTolerances::guard_band, deviation>>(
        "tolerance.guard_band", "Guard band", "µm", "″", "", Wanted::no, 0, any, "Its width, for the rule guard-band."),
    number_field<AnnexAQuantity<&AnnexAInputs::length, mm>>("uncertainty.length_mm", "Measurement length L", "mm", "",
                                                            "A.2.2", Wanted::no, 1e-3, any,
                                                            "The measured travel when not given."),
    number_field<AnnexAQuantity<&AnnexAInputs::device_calibration, deviation>>(
        "uncertainty.device_calibration", "Calibration uncertainty of the device (k = 2)", "µm", "″", "A.1", Wanted::no,
        0, any, "U of the calibration certificate."),
    number_field<AnnexAQuantity<&AnnexAInputs::device_calibration_per_length, per_m>>(
        "uncertainty.device_calibration_um_per_m", "Calibration uncertainty of the device (k = 2)", "µm/m", "", "A.2",
        Wanted::no, 0, any, "U of the calibration certificate per metre."),
    choice_field<OptionalChoiceAccess<At<&Metadata::uncertainty, &AnnexAInputs::device_calibration_sum>, sum_words>>(
        "uncertainty.device_calibration_sum", "Sum of both parts of the calibration uncertainty", "", sum_words,
        "How a constant part and one per metre make U: a + b·L (when not given), or the root of their squares."),
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
    number_field<GumQuantity<&GumInputs::axis_resolution, deviation>>(
        "uncertainty.axis_resolution", "Resolution of the axis", "µm", "″", "", Wanted::no, 0, any,
        "Smallest step of the axis scale."),
    number_field<GumQuantity<&GumInputs::instrument_resolution, deviation>>(
        "uncertainty.instrument_resolution", "Resolution of the measuring instrument", "µm", "″", "", Wanted::no, 0,
        any, "Smallest step of the readings."),
    number_field<GumQuantity<&GumInputs::environment_sensitivity, per_m_K>>(
        "uncertainty.environment_sensitivity_um_per_m_C", "Sensitivity of the instrument to its environment",
        "µm/(m·°C)", "", "", Wanted::no, 0, 100,
        "Standard uncertainty K of the instrument's own compensation, per metre and per °C away from 20 °C."),
    number_field<GumQuantity<&GumInputs::environment_temperature_difference, kelvin>>(
        "uncertainty.environment_temperature_difference_C", "Difference of the air to 20 °C", "°C", "", "", Wanted::no,
        -100, 100, "From the air temperatures when not given."),
    number_field<GumQuantity<&GumInputs::alignment_angle, degrees>>(
        "uncertainty.alignment_angle_deg", "Largest angle of misalignment", "°", "", "", Wanted::no, 0, 90,
        "Between measuring instrument and axis. From the misalignment over L when not given."),
    number_field<PlainAccess<At<&Metadata::gum, &GumInputs::up_down_correlation>, double>>(
        "uncertainty.up_down_correlation", "Correlation between ↑ and ↓", "", "", "", Wanted::no, -1, 1,
        "Between the errors of both directions at one target; 1 when not given."),
    number_field<GumQuantity<&GumInputs::run_drift, deviation>>(
        "uncertainty.run_drift", "Drift from run to run", "µm",
        "″", "", Wanted::no, 0, any, "Standard uncertainty of a shift that all readings of one run have in common."),
    choice_field<OptionalChoiceAccess<At<&Metadata::gum, &GumInputs::measurand>, measurand_words>>(
        "uncertainty.measurand", "Measurand", "", measurand_words,
        "What is uncertain: what perfect instruments would have found in this test (when not given), or what this "
        "machine does in the long run, of which the approaches are a sample."),
    choice_field<OptionalChoiceAccess<At<&Metadata::gum, &GumInputs::method>, method_words>>(
        "uncertainty.method", "Method of record", "", method_words,
        "Whose uncertainty stands with every result and decides. When not given: Monte Carlo where it was asked for, "
        "else Annex A, else the GUM."),
    choice_field<OptionalChoiceAccess<At<&Metadata::gum, &GumInputs::environment_kind>, environment_words>>(
        "uncertainty.environment_kind", "Kind of environmental variation", "", environment_words,
        "How E_VE moves the readings: from each to the next (white), slowly (drift), in steps that add up "
        "(random-walk). "
        "When not given it is unknown: what any of these would do counts, as far as the readings allow it."),
    numbers_field<NumbersAccess<At<&Metadata::gum, &GumInputs::drift_recording>>>(
        "uncertainty.drift_recording", "Recording of the environmental variation", "µm", "″", "A.2.5", Wanted::no,
        "Readings at standstill, equally far apart in time; they take the place of E_VE."),
    number_field<GumQuantity<&GumInputs::drift_interval, seconds>>(
        "uncertainty.drift_interval_s", "Time between two of its readings", "s", "s", "A.2.5", Wanted::no, 1e-6, any,
        "Of the recording of the environmental variation."),
    records_field<DistributionAccess>(
        "uncertainty.distributions", "Distributions of inputs", "", Wanted::no, distribution_columns,
        "Each replaces that of a named input, as in 'machine_temperature | triangular 1.5 2.5', or adds an own input "
        "to scale, target, run or reading, as in 'scale:optics | normal 0 0.2'."),
    number_field<QuantityAt<&Metadata::tracking, &TrackingInputs::station_position, position>>(
        "tracking.station_position", "Tracking interferometer, position along the line", "mm", "", "", Wanted::no, -any,
        any, "Position of the point of the line that is next to the station."),
    numbers_field<NumbersAccess<At<&Metadata::tracking, &TrackingInputs::station_uncertainty_mm>>>(
        "tracking.station_uncertainty_mm", "Tracking interferometer, uncertainty across the line", "mm", "", "",
        Wanted::no, "Standard uncertainties of the station in the two principal directions across the line."),
};

}  // namespace

std::span<const Field> metadata_fields() { return fields; }

}  // namespace axiometry
