// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/model/axis.h"
#include "axiometry/model/surroundings.h"
#include "axiometry/model/uncertainty_choices.h"

namespace axiometry {

/// Everything about a test but its readings: the list of clause 8.1 and the inputs of Annex A.
/// An empty text or an absent optional means "not given"; model/fields.h names every member once.

struct Machine {
  std::string name;
  std::string type;  ///< "vertical spindle machining centre"
  std::string serial_number;
  std::string axes_travel;  ///< "X 1800, Y 700, Z 650 mm"
  std::string location;
};

/// One component of the test equipment: laser head, optics, temperature sensor, …
struct Equipment {
  std::string role;
  std::string manufacturer;
  std::string type;
  std::string serial_number;
  std::string certificate{};      ///< number of its calibration certificate
  std::string calibrated_on{};    ///< date
  std::string calibration_due{};  ///< date until which the calibration holds
};

/// One temperature sensor: role "machine" (representative of the machine), "equipment" or "air".
struct TemperatureSensor {
  std::string role;
  std::string location;
  std::optional<Temperature> start;
  std::optional<Temperature> end;
};

/// Correction for nominal differential expansion (4.1), as applied by the instrument (or since by this program, see
/// Provenance).
struct NdeCorrection {
  std::optional<bool> applied;
  std::optional<ExpansionCoefficient> machine_expansion;
  std::optional<ExpansionCoefficient> equipment_expansion;
  std::string routine;              ///< "updated every 20 s"
  std::optional<Position> datum{};  ///< position where the instrument was set to zero; the first target when absent
};

struct Environment {
  std::optional<Temperature> air_temperature_start;
  std::optional<Temperature> air_temperature_end;
  std::optional<Pressure> air_pressure_start;
  std::optional<Pressure> air_pressure_end;
  std::optional<RelativeHumidity> air_humidity_start;
  std::optional<RelativeHumidity> air_humidity_end;
  std::vector<TemperatureSensor> sensors;
};

/// What the correction of raw readings takes (standards/readings/reading_correction.h): how the instrument got from
/// what it counts to what it shows.
struct InstrumentSettings {
  std::optional<Length> vacuum_wavelength;
  std::optional<double> refractive_index;  ///< index of air that the instrument assumed; 1 for lengths in vacuum
  std::optional<Length> dead_path;         ///< way between the fixed and the moving optics at the datum, uncompensated
  std::optional<double> air_co2_ppm;       ///< carbon dioxide in the air, by volume
  std::optional<double> gain;              ///< true change of length per change shown, of the sensor
  std::optional<bool> sign_reversed;       ///< whether it counts up when the axis moves down
};

/// The artefact of Annex D, when one takes the place of the instrument.
struct Artefact {
  std::string type;  ///< "ball array", "step gauge"
  std::string serial_number;
  std::string certificate;
  std::vector<double> calibrated_positions;                          ///< mm, one per target, in their order
  std::optional<Deviation> calibration_uncertainty;                  ///< U, k = 2, of each position
  std::optional<RelativeLength> calibration_uncertainty_per_length;  ///< U, k = 2, proportional to the length
  std::optional<CalibrationSum> calibration_sum;                     ///< linear when absent
  std::optional<Deviation> probing_uncertainty;                      ///< U, k = 2, of one probing
};

enum class TestCycle { standard, step, pilgrim, unidirectional, user_defined };

struct TestConditions {
  std::string date;
  std::string inspector;
  std::string laboratory;  ///< laboratory or company that vouches for the report
  std::string customer;
  std::string report_number;
  std::string purpose;  ///< "acceptance", "reverification", …
  std::string comment;
  std::optional<TestCycle> cycle;
  /// What an order of the readings rests on where nobody says in which they were taken: the cycle of Figure 1 (5.3.2).
  TestCycle cycle_or_standard() const { return cycle.value_or(TestCycle::standard); }
  std::optional<double> feed;  ///< mm/min or °/min, after the kind of the axis
  std::optional<Duration> dwell;
  std::string warm_up;
  std::string axes_not_under_test;
  std::vector<double> tool_offset_mm;       ///< X/Y/Z
  std::vector<double> workpiece_offset_mm;  ///< X/Y/Z
  std::string air_or_oil_shower;
  std::optional<bool> smaller_repeatability;  ///< whether min(R↑, R↓) is told too; no parameter of the standard
};

/// Inputs of Annex A, with its symbols. Ranges are full widths: 1 °C stands for ±0.5 °C (A.2.4.2).
struct AnnexAInputs {
  std::optional<Length> length;                                         ///< L; the measured travel when absent
  std::optional<Deviation> device_calibration;                          ///< U_CALIBRATION, k = 2 (A.1)
  std::optional<RelativeLength> device_calibration_per_length;          ///< U_CALIBRATION, k = 2 (A.2)
  std::optional<CalibrationSum> device_calibration_sum;                 ///< sum of both (A.1, A.2); linear when absent
  std::optional<RelativeLength> device_error_range;                     ///< R_DEVICE (A.3)
  std::optional<Length> misalignment;                                   ///< R_MISALIGNMENT (A.4)
  std::optional<ExpansionCoefficient> machine_expansion;                ///< α (A.5)
  std::optional<TemperatureDifference> machine_temperature_range;       ///< R(θ) (A.5)
  std::optional<TemperatureDifference> machine_temperature_difference;  ///< ΔT, largest (A.7)
  std::optional<ExpansionCoefficient> machine_expansion_range;          ///< R(α) (A.7)
  std::optional<ExpansionCoefficient> device_expansion;                 ///< α of the device (A.6)
  std::optional<TemperatureDifference> device_temperature_range;        ///< R(θ) (A.6)
  std::optional<TemperatureDifference> device_temperature_difference;   ///< ΔT (A.8)
  std::optional<ExpansionCoefficient> device_expansion_range;           ///< R(α) (A.8)
  std::optional<Deviation> environmental_variation;                     ///< E_VE (A.9)
};

/// A distribution given in words for one input quantity.
struct InputDistribution {
  std::string input;         ///< "machine_temperature", "scale:optics"
  std::string distribution;  ///< as uncertainty::Distribution::parse() reads it
};

/// What the GUM and Monte Carlo methods take beyond Annex A, whose items they use too. Equations of Lira &
/// Cargill, Precision Engineering 28 (2004) 232.
struct GumInputs {
  std::optional<Deviation> axis_resolution;                                 ///< r (22)
  std::optional<Deviation> instrument_resolution;                           ///< r_s (23)
  std::optional<ExpansionCoefficient> environment_sensitivity;              ///< K (24), per metre and °C
  std::optional<TemperatureDifference> environment_temperature_difference;  ///< ΔT_e (24)
  std::optional<Angle> alignment_angle;                                     ///< θ_max (20, 21)
  std::optional<double> up_down_correlation;        ///< correlation of x_i↑ and x_i↓ (10); 1
  std::optional<Deviation> run_drift;               ///< standard uncertainty of a shift common to a run
  std::optional<Measurand> measurand;               ///< this_test when absent
  std::optional<UncertaintyMethod> method;          ///< method of record: it decides and stands with every result
  std::optional<EnvironmentKind> environment_kind;  ///< what kind of effect E_VE is (A.9); unknown when absent
  std::vector<double> drift_recording;     ///< readings at standstill (A.2.5), µm or ″, equally far apart in time
  std::optional<Duration> drift_interval;  ///< time between two of these readings
  std::vector<InputDistribution> distributions;
};

/// Limits of the parameters (8.2) that the test itself brings along, and how to decide on them: what is given
/// here takes the place of a tolerance table's, and a flag the place of this.
struct StatedTolerances {
  std::optional<Deviation> A;
  std::optional<Deviation> A_up;
  std::optional<Deviation> A_down;
  std::optional<Deviation> E;
  std::optional<Deviation> E_up;
  std::optional<Deviation> E_down;
  std::optional<Deviation> M;
  std::optional<Deviation> R;
  std::optional<Deviation> R_up;
  std::optional<Deviation> R_down;
  std::optional<Deviation> B;
  std::optional<Deviation> B_mean;  ///< limit of the magnitude of B̄
  std::string table;                ///< name in a file of tolerance tables
  std::string rule;                 ///< "simple", "iso14253-1" or "guard-band"
  std::optional<Deviation> guard_band;
};

/// A tracking interferometer beside the line under test, whose place is known within an uncertainty: what it then shows
/// differs from the way along the line (Lee et al., Sensors 16 (2016) 482, eqs 17 to 23;
/// tracking/station/length_difference.h).
struct TrackingInputs {
  std::optional<Position> station_position;  ///< position on the line that is next to the station
  /// Standard uncertainties of the station across the line, mm: along the two principal directions, the larger first.
  std::vector<double> station_uncertainty_mm;
};

struct Metadata {
  Axis axis;
  Machine machine;
  TestConditions conditions;
  std::vector<Equipment> equipment;
  NdeCorrection nde;
  Environment environment;
  StatedEnvironment surroundings;
  AgreedEnvironment agreed;
  InstrumentSettings instrument;
  Artefact artefact;
  StatedTolerances tolerance;
  AnnexAInputs uncertainty;
  GumInputs gum;
  TrackingInputs tracking;
};

}  // namespace axiometry
