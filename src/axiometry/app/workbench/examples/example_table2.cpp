// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/examples/example_table2.h"

namespace axiometry::app {

const std::string_view example_table2 = R"json({
  "format": "axiometry-test/1",
  "test": {
    "date": "2014-05-15",
    "inspector": "A. N. Inspector",
    "cycle": "standard",
    "feed": 1000,
    "dwell_s": 5,
    "warm_up": "Three runs over the whole travel at 1000 mm/min",
    "axes_not_under_test": "Y = 300 mm; Z = 350 mm",
    "tool_offset_mm": [0, 0, 120],
    "workpiece_offset_mm": [0, 0, 30]
  },
  "machine": {
    "name": "Table 2 of ISO 230-2 (worked example)",
    "type": "Vertical spindle machining centre",
    "axes_travel": "X 1800 mm, Y 700 mm, Z 650 mm"
  },
  "axis": {
    "name": "X",
    "kind": "linear",
    "measurement_line": "Parallel to X, 300 mm above the table",
    "scale_type": "Ball screw and rotary encoder",
    "scale_expansion_um_per_m_C": 12,
    "compensation": "none"
  },
  "equipment": [
    {
      "role": "Laser interferometer",
      "manufacturer": "Example Instruments",
      "type": "LI-1",
      "serial_number": "1234"
    },
    {
      "role": "Air sensor unit",
      "manufacturer": "Example Instruments",
      "type": "AS-1",
      "serial_number": "5678"
    }
  ],
  "nde": {
    "applied": true,
    "machine_expansion_um_per_m_C": 12,
    "routine": "Updated every 20 s"
  },
  "sensors": [
    {
      "role": "machine",
      "location": "X scale, centre of the travel",
      "start_C": 20.4,
      "end_C": 21
    },
    {
      "role": "air",
      "location": "beside the laser beam",
      "start_C": 20.6,
      "end_C": 20.9
    }
  ],
  "environment": {
    "air_temperature_start_C": 20.6,
    "air_temperature_end_C": 20.9,
    "air_pressure_start_kPa": 102.4,
    "air_pressure_end_kPa": 102.4,
    "air_humidity_start_percent": 60,
    "air_humidity_end_percent": 60
  },
  "uncertainty": {
    "length_mm": 1751,
    "device_calibration_um_per_m": 1,
    "misalignment_mm": 1,
    "machine_expansion_um_per_m_C": 12,
    "machine_temperature_range_C": 0.2,
    "machine_temperature_difference_C": 1,
    "machine_expansion_range_um_per_m_C": 2,
    "environmental_variation": 1.7
  },
  "series": {
    "quantity": "deviation",
    "unit": "um",
    "target_unit": "mm",
    "targets": [6.711, 175.077, 353.834, 525.668, 704.175, 881.868, 1055.89, 1234.304, 1408.462, 1580.269, 1750.92],
    "up": [
      [-1.2, -0.5, 0.2, -0.6, -1.9, -3, -3.7, -3.7, -3.5, -3.2, -3.6],
      [-1.7, -0.9, -0.6, -1.2, -2.3, -3.5, -4.3, -4.4, -4.3, -3.8, -4],
      [-1.9, -1.1, -0.7, -1.3, -2.9, -3.7, -4.6, -5.1, -5, -4.7, -4.5],
      [-1.3, -0.2, 0.1, -0.3, -1.4, -2.8, -3.6, -3.6, -3.2, -2.8, -3.2],
      [-1.9, -0.8, -0.7, -1.3, -2.3, -3.7, -4.5, -4.6, -4.5, -4.1, -4.5]
    ],
    "down": [
      [2.3, 3.6, 3.5, 3, 1.7, 0.4, -0.4, -0.2, 0.2, 0.3, -0.1],
      [2.1, 3.5, 3.3, 2.7, 1.5, 0.2, -0.7, -0.6, -0.2, -0.1, -0.6],
      [1.9, 3.1, 3, 2.4, 1, -0.2, -1, -1, -1, -0.9, -1.2],
      [2.8, 3.7, 3.8, 3.2, 1.9, 0.9, 0, -0.2, 0.5, 0.5, 0.4],
      [2.2, 3.2, 3.5, 2.6, 1.1, -0.1, -0.9, -1.1, -0.5, -0.4, -0.9]
    ]
  }
}
)json";

}  // namespace axiometry::app
