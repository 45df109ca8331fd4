// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/periodic/air_answer.h"

namespace axiometry::app {

using json::Value;

Result<std::vector<AirAnswer>> answer_air(const Air& air, Length vacuum_wavelength,
                                          const std::vector<AirEquation>& equations) {
  std::vector<AirAnswer> answers;
  for (const AirEquation equation : equations) {
    AirAnswer answer;
    answer.equation = equation;
    AXIOMETRY_TRY(answer.refractivity, air_refractivity(equation, air, vacuum_wavelength));
    AXIOMETRY_TRY(answer.sensitivities, air_sensitivities(equation, air, vacuum_wavelength));
    answer.wavelength_in_air = Length::nm(vacuum_wavelength.in_nm() / (1.0 + answer.refractivity));
    answer.water_vapour = water_vapour_pressure(equation, air);
    answers.push_back(answer);
  }
  return answers;
}

Value air_to_json(const Air& air, Length vacuum_wavelength, const std::vector<AirAnswer>& answers) {
  Value object = Value::object();
  object.add("temperature_C", air.temperature.in_celsius());
  object.add("pressure_kPa", air.pressure.in_kPa());
  object.add("humidity_percent", air.humidity.in_percent());
  object.add("co2_ppm", air.co2_ppm);
  object.add("vacuum_wavelength_nm", vacuum_wavelength.in_nm());
  for (const AirAnswer& answer : answers) {
    Value& row = object.add(air_equation_key(answer.equation), Value::object());
    row.add("equation", air_equation_name(answer.equation));
    row.add("refractive_index", 1.0 + answer.refractivity);
    row.add("refractivity", answer.refractivity);
    row.add("wavelength_nm", answer.wavelength_in_air.in_nm());
    row.add("water_vapour_kPa", answer.water_vapour.in_kPa());
    Value& slopes = row.add("sensitivities", Value::object());
    slopes.add("per_C", answer.sensitivities.per_celsius);
    slopes.add("per_Pa", answer.sensitivities.per_pascal);
    slopes.add("per_percent", answer.sensitivities.per_percent);
    slopes.add("per_ppm_co2", answer.sensitivities.per_ppm_co2);
  }
  return object;
}

}  // namespace axiometry::app
