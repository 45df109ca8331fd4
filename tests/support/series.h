// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

#include "axiometry/model/test.h"

/// Series and tests to test with. Native units: mm and µm, ° and ″.
namespace axiometry::testing_support {

inline constexpr double none = std::numeric_limits<double>::quiet_NaN();  ///< a reading that is missing

using RunDeviations = std::vector<double>;  ///< one deviation per target, `none` where missing

/// A series from whole runs over the targets, ↑ and ↓.
inline Series make_series(const std::vector<double>& targets, const std::vector<RunDeviations>& up,
                          const std::vector<RunDeviations>& down) {
  std::vector<Position> positions;
  for (double t : targets) positions.push_back(Position::native(t));
  std::vector<Reading> readings;
  const auto add = [&](const std::vector<RunDeviations>& runs, Direction direction) {
    for (std::size_t j = 0; j < runs.size(); ++j) {
      if (runs[j].size() != targets.size()) throw std::logic_error("a run needs one deviation per target");
      for (std::size_t i = 0; i < targets.size(); ++i)
        if (runs[j][i] == runs[j][i]) readings.push_back({i, direction, j, Deviation::native(runs[j][i])});
    }
  };
  add(up, Direction::up);
  add(down, Direction::down);
  auto series = Series::make(std::move(positions), readings);
  if (!series) throw std::logic_error(series.error().message);
  return *std::move(series);
}

inline constexpr double exact_um = 1e-9;  ///< to which deviations of some micrometres agree but for rounding

/// The deviation that was read, which must be there.
inline double x(const Series& series, std::size_t i, Direction direction, std::size_t run) {
  return series.reading(i, direction, run)->in_native();
}

/// ISO 230-2:2014, Table 2: linear axis, 11 targets, 5 approaches from either direction.
namespace table2 {

inline const std::vector<double> targets = {6.711,   175.077,  353.834,  525.668,  704.175, 881.868,
                                            1055.89, 1234.304, 1408.462, 1580.269, 1750.92};
inline const std::vector<RunDeviations> up = {
    {-1.2, -0.5, 0.2, -0.6, -1.9, -3.0, -3.7, -3.7, -3.5, -3.2, -3.6},
    {-1.7, -0.9, -0.6, -1.2, -2.3, -3.5, -4.3, -4.4, -4.3, -3.8, -4.0},
    {-1.9, -1.1, -0.7, -1.3, -2.9, -3.7, -4.6, -5.1, -5.0, -4.7, -4.5},
    {-1.3, -0.2, 0.1, -0.3, -1.4, -2.8, -3.6, -3.6, -3.2, -2.8, -3.2},
    {-1.9, -0.8, -0.7, -1.3, -2.3, -3.7, -4.5, -4.6, -4.5, -4.1, -4.5},
};
inline const std::vector<RunDeviations> down = {
    {2.3, 3.6, 3.5, 3.0, 1.7, 0.4, -0.4, -0.2, 0.2, 0.3, -0.1},
    {2.1, 3.5, 3.3, 2.7, 1.5, 0.2, -0.7, -0.6, -0.2, -0.1, -0.6},
    {1.9, 3.1, 3.0, 2.4, 1.0, -0.2, -1.0, -1.0, -1.0, -0.9, -1.2},
    {2.8, 3.7, 3.8, 3.2, 1.9, 0.9, 0.0, -0.2, 0.5, 0.5, 0.4},
    {2.2, 3.2, 3.5, 2.6, 1.1, -0.1, -0.9, -1.1, -0.5, -0.4, -0.9},
};

inline Series series() { return make_series(targets, up, down); }

/// The series with every item of clause 8.1 and a complete budget (inputs of Table A.5).
inline Test complete_test() {
  Metadata m;
  m.axis = {"X",
            AxisKind::linear,
            Position::native(-20),
            Position::native(1800),
            "through the middle of the work zone",
            "ball screw and rotary encoder",
            ExpansionCoefficient::um_per_m_K(11),
            "reversal and leadscrew",
            {},
            {},
            {},
            {}};
  m.axis.compensation_points = {0, 300, 600, 900, 1200, 1500, 1800};
  m.machine = {"Mill 5", "vertical spindle machining centre", "1234", "X 1800, Y 700, Z 650 mm", "hall 2"};
  m.conditions.date = "2024-05-06";
  m.conditions.inspector = "A. Nonym";
  m.conditions.purpose = "acceptance";
  m.conditions.cycle = TestCycle::standard;
  m.conditions.feed = 1000;
  m.conditions.dwell = Duration::s(5);
  m.conditions.warm_up = "five cycles at 1000 mm/min";
  m.conditions.axes_not_under_test = "Y = 300 mm; Z = 350 mm; C = 0°";
  m.conditions.tool_offset_mm = {0, 0, 120};
  m.conditions.workpiece_offset_mm = {0, 0, 30};
  m.equipment = {{"laser head", "Maker", "L1", "99"}};
  m.nde = {true, ExpansionCoefficient::um_per_m_K(11), {}, "updated every 20 s"};
  m.environment = {Temperature::celsius(20.6),
                   Temperature::celsius(20.9),
                   Pressure::kPa(102.4),
                   Pressure::kPa(102.4),
                   RelativeHumidity::percent(60),
                   RelativeHumidity::percent(60),
                   {{"machine", "table, centre", Temperature::celsius(20.4), Temperature::celsius(20.9)}}};
  m.uncertainty.length = Length::mm(1751);
  m.uncertainty.device_calibration_per_length = RelativeLength::um_per_m(1);
  m.uncertainty.misalignment = Length::mm(1);
  m.uncertainty.machine_expansion = ExpansionCoefficient::um_per_m_K(12);
  m.uncertainty.machine_temperature_range = TemperatureDifference::kelvin(0.2);
  m.uncertainty.machine_temperature_difference = TemperatureDifference::kelvin(1);
  m.uncertainty.machine_expansion_range = ExpansionCoefficient::um_per_m_K(2);
  m.uncertainty.environmental_variation = Deviation::native(1.7);
  return {m, series(), {"table2.csv", "", "csv-long"}};
}

}  // namespace table2
}  // namespace axiometry::testing_support
