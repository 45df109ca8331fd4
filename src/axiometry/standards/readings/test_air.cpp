// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/readings/test_air.h"

#include <fmt/format.h>

#include <optional>

#include "axiometry/base/text/number_text.h"
#include "axiometry/standards/readings/sensor_mean.h"

namespace axiometry {
namespace {

constexpr double co2_default_ppm = 450.0;

/// What was read of one quantity, as plain numbers in its unit.
struct Reads {
  std::optional<double> start;
  std::optional<double> end;

  bool any() const { return start || end; }
  double first() const { return start ? *start : *end; }
  double last() const { return end ? *end : *start; }
};

Reads temperature_of(const Environment& environment) {
  const auto& start = environment.air_temperature_start;
  const auto& end = environment.air_temperature_end;
  if (start || end)
    return {start ? std::optional(start->in_celsius()) : std::nullopt,
            end ? std::optional(end->in_celsius()) : std::nullopt};
  const auto mean = mean_of_sensors(environment, "air");
  return mean ? Reads{mean->start.in_celsius(), mean->end.in_celsius()} : Reads{};
}

Reads pressure_of(const Environment& environment) {
  const auto& start = environment.air_pressure_start;
  const auto& end = environment.air_pressure_end;
  return {start ? std::optional(start->in_kPa()) : std::nullopt, end ? std::optional(end->in_kPa()) : std::nullopt};
}

Reads humidity_of(const Environment& environment) {
  const auto& start = environment.air_humidity_start;
  const auto& end = environment.air_humidity_end;
  return {start ? std::optional(start->in_percent()) : std::nullopt,
          end ? std::optional(end->in_percent()) : std::nullopt};
}

/// "20.5 °C at the start, 21 °C at the end"
std::string reads_text(const Reads& reads, std::string_view unit) {
  if (!reads.start || !reads.end)
    return fmt::format("{} {}, read at the {} only and taken as constant", format_exact(reads.first()), unit,
                       reads.start ? "start" : "end");
  return fmt::format("{} {} at the start, {} {} at the end", format_exact(*reads.start), unit, format_exact(*reads.end),
                     unit);
}

Result<double> named(Result<double> index, std::string_view when) {
  if (!index) index.error().message += fmt::format(" (air at the {} of the test)", when);
  return index;
}

}  // namespace

std::vector<std::string> missing_for_air(const Metadata& metadata) {
  std::vector<std::string> missing;
  if (!temperature_of(metadata.environment).any()) missing.emplace_back("environment.air_temperature_start_C");
  if (!pressure_of(metadata.environment).any()) missing.emplace_back("environment.air_pressure_start_kPa");
  if (!humidity_of(metadata.environment).any()) missing.emplace_back("environment.air_humidity_start_percent");
  return missing;
}

Result<TestAir> TestAir::make(const Metadata& metadata, AirEquation equation) {
  if (const auto missing = missing_for_air(metadata); !missing.empty())
    return fail(fmt::format("found no {}, expected the air along the beam", missing.front()));
  const Reads temperature = temperature_of(metadata.environment);
  const Reads pressure = pressure_of(metadata.environment);
  const Reads humidity = humidity_of(metadata.environment);
  const auto& co2 = metadata.instrument.air_co2_ppm;
  const auto& wavelength = metadata.instrument.vacuum_wavelength;
  const auto air_of = [&](double t, double p, double h) {
    return Air{Temperature::celsius(t), Pressure::kPa(p), RelativeHumidity::percent(h), co2.value_or(co2_default_ppm)};
  };
  TestAir air(equation, air_of(temperature.first(), pressure.first(), humidity.first()),
              air_of(temperature.last(), pressure.last(), humidity.last()),
              wavelength.value_or(Length::nm(helium_neon_nm)));
  AXIOMETRY_TRY(const double start, named(air_refractivity(equation, air.start_, air.wavelength_), "start"));
  AXIOMETRY_TRY(const double end, named(air_refractivity(equation, air.end_, air.wavelength_), "end"));
  air.details_ = {
      {"Equation", std::string(air_equation_name(equation))},
      {"Air temperature", reads_text(temperature, "°C")},
      {"Air pressure", reads_text(pressure, "kPa")},
      {"Air humidity", reads_text(humidity, "%")},
      {"Carbon dioxide", fmt::format("{} ppm{}", format_exact(air.start_.co2_ppm), co2 ? "" : ", assumed")},
      {"Vacuum wavelength",
       fmt::format("{} nm{}", format_exact(air.wavelength_.in_nm()), wavelength ? "" : ", assumed")},
      {"Refractive index of air", fmt::format("{:.9f} at the start, {:.9f} at the end", 1.0 + start, 1.0 + end)},
  };
  return air;
}

Air TestAir::at(double share) const {
  return {(1.0 - share) * start_.temperature + share * end_.temperature,
          (1.0 - share) * start_.pressure + share * end_.pressure,
          (1.0 - share) * start_.humidity + share * end_.humidity, start_.co2_ppm};
}

double TestAir::refractivity(double share) const {
  return unchecked_air_refractivity(equation_, at(share), wavelength_);
}

std::vector<AppliedCorrection::Detail> TestAir::details() const { return details_; }

}  // namespace axiometry
