// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>

namespace axiometry {

/// A number that knows what it measures. One tag per physical quantity; the stored unit is private
/// to this header, so every entry and exit names its unit: Length::um(1.3).in_mm().
template <typename Tag>
class Quantity {
 public:
  constexpr Quantity() = default;

  friend constexpr Quantity operator+(Quantity a, Quantity b) { return Quantity(a.value_ + b.value_); }
  friend constexpr Quantity operator-(Quantity a, Quantity b) { return Quantity(a.value_ - b.value_); }
  friend constexpr Quantity operator-(Quantity a) { return Quantity(-a.value_); }
  friend constexpr Quantity operator*(double k, Quantity a) { return Quantity(k * a.value_); }
  friend constexpr auto operator<=>(Quantity, Quantity) = default;

 protected:
  constexpr explicit Quantity(double value) : value_(value) {}
  double value_ = 0.0;
};

/// AXIOMETRY_QUANTITY(Length, …): declares the type; AXIOMETRY_UNIT adds a unit with its size in the
/// stored unit. Division, not multiplication by a rounded reciprocal, keeps 0.1 um exactly 0.1 um.
#define AXIOMETRY_QUANTITY_BEGIN(Name)             \
  class Name : public Quantity<struct Name##Tag> { \
   public:                                         \
    constexpr Name() = default;                    \
    constexpr Name(Quantity<Name##Tag> q) : Quantity<Name##Tag>(q) {}
#define AXIOMETRY_UNIT(Name, unit, factor, divisor)                                        \
  static constexpr Name unit(double x) { return Name(Name::Raw{}, x * factor / divisor); } \
  constexpr double in_##unit() const { return value_ * divisor / factor; }
#define AXIOMETRY_QUANTITY_END(Name)                                \
 private:                                                           \
  struct Raw {};                                                    \
  constexpr Name(Raw, double value) : Quantity<Name##Tag>(value) {} \
  }

AXIOMETRY_QUANTITY_BEGIN(Length)
AXIOMETRY_UNIT(Length, um, 1.0, 1.0)
AXIOMETRY_UNIT(Length, mm, 1000.0, 1.0)
AXIOMETRY_UNIT(Length, m, 1.0e6, 1.0)
AXIOMETRY_UNIT(Length, nm, 1.0, 1000.0)
AXIOMETRY_QUANTITY_END(Length);

AXIOMETRY_QUANTITY_BEGIN(Angle)
AXIOMETRY_UNIT(Angle, arcsec, 1.0, 1.0)
AXIOMETRY_UNIT(Angle, deg, 3600.0, 1.0)
AXIOMETRY_QUANTITY_END(Angle);

/// A temperature; differences are TemperatureDifference, so 20 °C and 20 K cannot be mixed up.
AXIOMETRY_QUANTITY_BEGIN(Temperature)
AXIOMETRY_UNIT(Temperature, celsius, 1.0, 1.0)
AXIOMETRY_QUANTITY_END(Temperature);

AXIOMETRY_QUANTITY_BEGIN(TemperatureDifference)
AXIOMETRY_UNIT(TemperatureDifference, kelvin, 1.0, 1.0)
AXIOMETRY_QUANTITY_END(TemperatureDifference);

/// A relative length: expansion per kelvin is ExpansionCoefficient.
AXIOMETRY_QUANTITY_BEGIN(RelativeLength)
AXIOMETRY_UNIT(RelativeLength, um_per_m, 1.0, 1.0)
AXIOMETRY_QUANTITY_END(RelativeLength);

AXIOMETRY_QUANTITY_BEGIN(ExpansionCoefficient)
AXIOMETRY_UNIT(ExpansionCoefficient, um_per_m_K, 1.0, 1.0)
AXIOMETRY_QUANTITY_END(ExpansionCoefficient);

AXIOMETRY_QUANTITY_BEGIN(Duration)
AXIOMETRY_UNIT(Duration, s, 1.0, 1.0)
AXIOMETRY_QUANTITY_END(Duration);

AXIOMETRY_QUANTITY_BEGIN(Pressure)
AXIOMETRY_UNIT(Pressure, kPa, 1.0, 1.0)
AXIOMETRY_QUANTITY_END(Pressure);

AXIOMETRY_QUANTITY_BEGIN(RelativeHumidity)
AXIOMETRY_UNIT(RelativeHumidity, percent, 1.0, 1.0)
AXIOMETRY_QUANTITY_END(RelativeHumidity);

#undef AXIOMETRY_QUANTITY_BEGIN
#undef AXIOMETRY_UNIT
#undef AXIOMETRY_QUANTITY_END

}  // namespace axiometry
