// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/distributions/normal_and_student_t.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace axiometry::numeric {
namespace {

// Validation: all figures were computed with sixty digits by another program.

void expect_relative(double got, double expected, double tolerance) {
  EXPECT_NEAR(got / expected, 1.0, tolerance) << got << " for " << expected;
}

TEST(NormalAndStudentT, GiveTheNormalTailToItsLastDigits) {
  expect_relative(normal_probability(-1), 0.1586552539314570514147675, 1e-15);
  expect_relative(normal_probability(-5), 0.0000002866515718791939116737523, 1e-14);
  expect_relative(normal_probability(-20), 2.753624118606233695075623e-89, 1e-13);
  expect_relative(normal_probability(-37), 5.725571222524576822683193e-300, 1e-12);
  EXPECT_EQ(normal_probability(40), 1.0);
}

TEST(NormalAndStudentT, InvertTheNormalDistribution) {
  expect_relative(normal_quantile(0.975), 1.959963984540054235524594, 1e-14);
  expect_relative(normal_quantile(0.995), 2.575829303548900760978577, 1e-14);
  expect_relative(normal_quantile(0.6), 0.2533471031357997987981962, 1e-14);
  EXPECT_EQ(normal_quantile(0.5), 0.0);
  for (const double z : {-37.0, -8.0, -1.0, -1e-3, 0.3, 5.0})
    EXPECT_NEAR(normal_quantile(normal_probability(z)), z, 1e-9 * std::max(1.0, std::exp(z * z / 2) * 1e-7)) << z;
}

TEST(NormalAndStudentT, GiveStudentsDistributionOnBothSides) {
  expect_relative(student_t_probability(-2, 4), 0.05805826175840779724947227, 1e-14);
  expect_relative(student_t_probability(-3, 10), 0.006671827511284788603410295, 1e-14);
  expect_relative(student_t_probability(-30, 3), 0.00004067640213581979726959073, 1e-14);
  expect_relative(student_t_probability(-8, 200), 4.939600454665319609635328e-14, 1e-13);
  expect_relative(student_t_probability(0.001, 7) - 0.5, 0.0003849913775005781293304357, 1e-12);
  EXPECT_EQ(student_t_probability(0, 3), 0.5);
  EXPECT_EQ(student_t_probability(std::numeric_limits<double>::infinity(), 3), 1.0);
  EXPECT_EQ(student_t_probability(1.2, std::numeric_limits<double>::infinity()), normal_probability(1.2));
}

TEST(NormalAndStudentT, InvertStudentsDistributionForAnyDegreesOfFreedom) {
  const struct {
    double degrees_of_freedom, tail, t;
  } figures[] = {
      {0.1, 0.25, 168.2360731977094},  // ν = 0.1 as a double
      {0.5, 0.025, 164.5576734804885331157631},
      {1.0, 0.025, 12.70620473617470464602168},
      {2.0, 0.025, 4.302652729749463852320944},
      {16.0, 0.005, 2.920781622425099991967283},
      {16.7, 0.005, 2.904680938429358972763373},
      {59.0, 0.025, 2.000995378088267705980537},
      {61.0, 0.025, 1.999623584994939700413743},
      {1000.0, 0.025, 1.96233908082640848499858},
      {1e7, 0.025, 1.959964221767205490369585},
      {50.0, 1e-12, 9.26013968368414470590318},
      {5.0, 0.49, 0.02634671234227323845288408},
      {3.0, 0.3, 0.5843897274398186691086455},
  };
  for (const auto& f : figures) {
    SCOPED_TRACE(f.degrees_of_freedom);
    expect_relative(student_t_quantile(f.tail, f.degrees_of_freedom), -f.t, f.degrees_of_freedom > 1e4 ? 1e-9 : 2e-13);
  }
}

TEST(NormalAndStudentT, ReachTheFarTailOfFewDegreesOfFreedom) {
  for (const double nu : {0.1, 0.3, 1.0})
    for (const double p : {1e-20, 1e-10, 0.3}) {
      const double t = student_t_quantile(p, nu);
      expect_relative(student_t_probability(t, nu), p, 1e-12);
    }
}

}  // namespace
}  // namespace axiometry::numeric
