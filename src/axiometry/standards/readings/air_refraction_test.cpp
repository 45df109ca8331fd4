// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/readings/air_refraction.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace axiometry {
namespace {

using testing::HasSubstr;

constexpr Length red = Length::nm(633);

Air air(double celsius, double kPa, double percent, double co2_ppm = 450) {
  return {Temperature::celsius(celsius), Pressure::kPa(kPa), RelativeHumidity::percent(percent), co2_ppm};
}

/// (n − 1) · 10⁸
double scaled(AirEquation equation, const Air& state, Length wavelength = red) {
  return 1e8 * air_refractivity(equation, state, wavelength).value();
}

std::string refusal_of(const Air& state, Length wavelength = red) {
  const auto index = air_refractivity(AirEquation::ciddor, state, wavelength);
  return index ? "nothing" : index.error().message;
}

struct Published {
  double celsius;
  double percent;
  double kPa;
  double nm;
  double ciddor;
  double edlen;
};

// Golden: sample values of the NIST Engineering Metrology Toolbox (J. Stone, J. Zimmerman) for 450 ppm of carbon
// dioxide, both equations, to 9 decimals. It takes the vapour pressure of IAPWS with Ciddor too, hence 1e-9 there.
constexpr Published published[] = {
    {20, 0, 101.325, 633, 1.000271800, 1.000271799},  {20, 0, 60, 633, 1.000160924, 1.000160920},
    {20, 0, 120, 633, 1.000321916, 1.000321918},      {50, 0, 100, 633, 1.000243285, 1.000243270},
    {5, 0, 100, 633, 1.000282756, 1.000282750},       {-40, 0, 100, 633, 1.000337580, 1.000337471},
    {50, 100, 120, 633, 1.000287924, 1.000287864},    {40, 75, 120, 633, 1.000299418, 1.000299406},
    {20, 100, 100, 633, 1.000267394, 1.000267394},    {40, 100, 110, 1700, 1.000270247, 1.000270237},
    {20, 0, 101.325, 1700, 1.000268479, 1.000268483}, {40, 100, 110, 300, 1.000289000, 1.000288922},
    {20, 0, 101.325, 300, 1.000286581, 1.000286579},  {-40, 0, 120, 300, 1.000427233, 1.000427072},
};

TEST(AirRefraction, AgreesWithTheSampleValuesOfNist) {
  for (const Published& row : published) {
    const Air state = air(row.celsius, row.kPa, row.percent);
    EXPECT_NEAR(1.0 + air_refractivity(AirEquation::ciddor, state, Length::nm(row.nm)).value(), row.ciddor, 1e-9)
        << row.celsius << " °C, " << row.kPa << " kPa, " << row.nm << " nm";
    EXPECT_NEAR(1.0 + air_refractivity(AirEquation::edlen, state, Length::nm(row.nm)).value(), row.edlen, 5.1e-10)
        << row.celsius << " °C, " << row.kPa << " kPa, " << row.nm << " nm";
  }
}

TEST(AirRefraction, AgreesWithTheTableOfDryAirOfCiddor) {  // Table 1, to its last digit
  EXPECT_NEAR(scaled(AirEquation::ciddor, air(20, 80, 0)), 21458.0, 0.051);
  EXPECT_NEAR(scaled(AirEquation::ciddor, air(20, 100, 0)), 26824.4, 0.051);
  EXPECT_NEAR(scaled(AirEquation::ciddor, air(20, 120, 0)), 32191.6, 0.051);
  EXPECT_NEAR(scaled(AirEquation::ciddor, air(10, 100, 0)), 27774.7, 0.051);
  EXPECT_NEAR(scaled(AirEquation::ciddor, air(30, 100, 0)), 25937.2, 0.051);
}

TEST(AirRefraction, AgreesWithTheTableOfMoistAirOfCiddor) {  // Table 3; 40 °C, 80 kPa is misprinted there by 100
  EXPECT_NEAR(scaled(AirEquation::ciddor, air(20, 80, 75)), 21394.0, 0.051);
  EXPECT_NEAR(scaled(AirEquation::ciddor, air(20, 120, 75)), 32127.8, 0.051);
  EXPECT_NEAR(scaled(AirEquation::ciddor, air(40, 80, 75)), 19896.5, 0.051);
  EXPECT_NEAR(scaled(AirEquation::ciddor, air(40, 120, 75)), 29941.8, 0.051);
  EXPECT_NEAR(scaled(AirEquation::ciddor, air(50, 80, 100)), 19058.4, 0.051);
  EXPECT_NEAR(scaled(AirEquation::ciddor, air(50, 120, 100)), 28792.4, 0.051);
}

struct MeasuredAir {
  double celsius;
  double pascal;
  double vapour_pascal;
  double co2_ppm;
  double index;  ///< (n − 1) · 10⁸
};

// Validation: what Birch and Downs measured with their refractometer (Table 2 of Ciddor), which both equations meet
// within 1.2e-8.
constexpr MeasuredAir measured_air[] = {
    {19.526, 102094.8, 1065, 510, 27392.3}, {19.517, 102096.8, 1065, 510, 27394.0},
    {19.173, 102993.0, 641, 450, 27683.4},  {19.173, 103006.0, 642, 440, 27686.9},
    {19.188, 102918.8, 706, 450, 27659.1},  {19.189, 102927.8, 708, 440, 27661.4},
    {19.532, 103603.2, 986, 600, 27802.1},  {19.534, 103596.2, 962, 600, 27800.3},
    {19.534, 103599.2, 951, 610, 27801.8},
};

TEST(AirRefraction, AgreesWithMeasuredAirThatHoldsWaterAndCarbonDioxide) {
  for (const MeasuredAir& row : measured_air) {
    Air state = air(row.celsius, row.pascal / 1000.0, 0, row.co2_ppm);
    state.water_vapour = Pressure::kPa(row.vapour_pascal / 1000.0);
    EXPECT_NEAR(scaled(AirEquation::ciddor, state), row.index, 1.2) << row.pascal;
    EXPECT_NEAR(scaled(AirEquation::edlen, state), row.index, 1.2) << row.pascal;
  }
}

TEST(AirRefraction, HasTwoEquationsThatAgreeInALaboratory) {
  for (double celsius = 15; celsius <= 30; celsius += 2.5)
    for (double kPa = 80; kPa <= 110; kPa += 5)
      for (double percent = 0; percent <= 80; percent += 20)
        EXPECT_NEAR(scaled(AirEquation::ciddor, air(celsius, kPa, percent)),
                    scaled(AirEquation::edlen, air(celsius, kPa, percent)), 1.0)
            << celsius << " °C, " << kPa << " kPa, " << percent << " %";
}

TEST(AirRefraction, KnowsTheSaturationPressureOfWater) {
  // IAPWS-IF97, Table 35: 3.53658941 kPa at 300 K; triple point 611.657 Pa; the form of Ciddor agrees within 0.1 %.
  EXPECT_NEAR(water_vapour_pressure(AirEquation::edlen, air(26.85, 100, 100)).in_kPa(), 3.53658941, 5e-9);
  EXPECT_NEAR(water_vapour_pressure(AirEquation::edlen, air(0.01, 100, 100)).in_kPa(), 0.611657, 1e-6);
  EXPECT_NEAR(water_vapour_pressure(AirEquation::edlen, air(-1e-9, 100, 100)).in_kPa(), 0.61115, 2e-5) << "over ice";
  for (double celsius : {0.0, 20.0, 40.0, 60.0}) {
    const double iapws = water_vapour_pressure(AirEquation::edlen, air(celsius, 100, 40)).in_kPa();
    EXPECT_NEAR(water_vapour_pressure(AirEquation::ciddor, air(celsius, 100, 40)).in_kPa(), iapws, 1e-3 * iapws)
        << celsius;
  }
}

TEST(AirRefraction, HasTheSensitivitiesThatEveryoneKnows) {
  for (const AirEquation equation : {AirEquation::ciddor, AirEquation::edlen}) {
    const auto moist = air_sensitivities(equation, air(20, 101.325, 50), red).value();
    EXPECT_NEAR(moist.per_celsius, -0.95e-6, 0.01e-6);
    EXPECT_NEAR(moist.per_pascal, 2.68e-9, 0.01e-9);
    EXPECT_NEAR(moist.per_percent, -0.85e-8, 0.01e-8);
    EXPECT_NEAR(moist.per_ppm_co2, 1.45e-10, 0.02e-10);
    EXPECT_NEAR(air_sensitivities(equation, air(20, 101.325, 0), red)->per_celsius, -0.93e-6, 0.005e-6);
  }
}

TEST(AirRefraction, HasSensitivitiesThatAddUpToAChange) {
  for (const AirEquation equation : {AirEquation::ciddor, AirEquation::edlen}) {
    const auto s = air_sensitivities(equation, air(22.5, 99.5, 45, 475), red).value();
    const double change = 1e8 * (s.per_celsius * 0.1 + s.per_pascal * 100 + s.per_percent * 1 + s.per_ppm_co2 * 10);
    const double before = scaled(equation, air(22.45, 99.45, 44.5, 470));
    EXPECT_NEAR(scaled(equation, air(22.55, 99.55, 45.5, 480)) - before, change, 1e-3);
  }
}

TEST(AirRefraction, RefusesWhatNoEquationHoldsFor) {
  EXPECT_EQ(refusal_of(air(400, 101, 50)), "found an air temperature of 400 °C, expected -40 to 100 °C");
  EXPECT_EQ(refusal_of(air(20, 101, 101)), "found a relative humidity of 101 %, expected 0 to 100 %");
  EXPECT_EQ(refusal_of(air(20, 101, 50, 5000)), "found carbon dioxide of 5000 ppm, expected 0 to 2000 ppm");
  EXPECT_EQ(refusal_of(air(20, 101, 50), Length::nm(10600)),
            "found a vacuum wavelength of 10600 nm, expected 300 to 1700 nm");
  EXPECT_THAT(refusal_of(air(20, 101, 50), Length::nm(0.633)), HasSubstr("is it µm?"));
  EXPECT_THAT(refusal_of(air(std::numeric_limits<double>::quiet_NaN(), 101, 50)), HasSubstr("temperature of nan"));
  EXPECT_THAT(refusal_of(air(90, 20, 90)), HasSubstr("expected less than the pressure"));
}

TEST(AirRefraction, SeesThatAPressureIsInAnotherUnit) {
  EXPECT_EQ(refusal_of(air(20, 1013, 50)), "found an air pressure of 1013 kPa, expected 10 to 140 kPa: is it hPa?");
  EXPECT_THAT(refusal_of(air(20, 760, 50)), HasSubstr(": is it hPa or mmHg?"));
  EXPECT_THAT(refusal_of(air(20, 101325, 50)), HasSubstr(": is it Pa?"));
  EXPECT_EQ(refusal_of(air(20, 1.013, 50)), "found an air pressure of 1.013 kPa, expected 10 to 140 kPa");
}

}  // namespace
}  // namespace axiometry
