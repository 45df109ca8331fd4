// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/test.h"
#include "axiometry/standards/readings/air_refraction.h"

namespace axiometry {

/// Vacuum wavelength of a stabilised red laser, as instruments assume it, nm.
inline constexpr double helium_neon_nm = 632.9909;

/// Keys of the items that say nothing of the air: one of start and end is enough of each.
std::vector<std::string> missing_for_air(const Metadata& metadata);

/// The air along the beam in the course of a test: temperature, pressure and humidity in straight lines from start to
/// end, each constant where only one of both was read. The temperature is that of the environment, else the mean of the
/// sensors with role `air`. Carbon dioxide is 450 ppm and the vacuum wavelength 632.9909 nm when not given.
class TestAir {
 public:
  /// Fails where something is missing and, naming start or end, where air_refractivity() does.
  static Result<TestAir> make(const Metadata& metadata, AirEquation equation);

  /// n − 1 at a share of the course of the test, 0 to 1.
  double refractivity(double share) const;

  /// Inputs and the index at start and end, for the provenance.
  std::vector<AppliedCorrection::Detail> details() const;

 private:
  TestAir(AirEquation equation, Air start, Air end, Length wavelength)
      : equation_(equation), start_(start), end_(end), wavelength_(wavelength) {}

  Air at(double share) const;

  AirEquation equation_;
  Air start_;
  Air end_;
  Length wavelength_;
  std::vector<AppliedCorrection::Detail> details_;
};

}  // namespace axiometry
