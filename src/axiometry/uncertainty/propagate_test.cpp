// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/propagate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace axiometry::uncertainty {
namespace {

LawResult propagated(const ModelFunction& model, std::size_t outputs, const std::vector<InputQuantity>& inputs,
                     const Correlation& correlation, const LawOptions& options = {}) {
  auto result = law_of_propagation(model, outputs, inputs, correlation, options);
  EXPECT_TRUE(result) << result.error().to_string();
  return result ? std::move(*result) : LawResult{};
}

std::string error_of(const ModelFunction& model, const std::vector<InputQuantity>& inputs,
                     const LawOptions& options = {}) {
  const auto result = law_of_propagation(model, 1, inputs, Correlation::none(inputs.size()), options);
  return result ? "no error" : result.error().message;
}

TEST(LawOfPropagation, HoldsTheErrorItStatesForItsDerivatives) {
  struct Function {
    double (*f)(double);
    double (*derivative)(double);
    double x, u;
  };
  const Function functions[] = {
      {[](double x) { return std::exp(x); }, [](double x) { return std::exp(x); }, 1.0, 0.5},
      {[](double x) { return std::sin(x); }, [](double x) { return std::cos(x); }, 1.5, 0.3},
      {[](double x) { return 1 / x; }, [](double x) { return -1 / (x * x); }, 0.1, 0.05},
      {[](double x) { return std::sqrt(x); }, [](double x) { return 0.5 / std::sqrt(x); }, 1e-4, 1e-4},
      {[](double x) { return std::log(x); }, [](double x) { return 1 / x; }, 1.0, 2.0},  // not finite at first steps
      {[](double x) { return 1e6 + 1e-3 * x; }, [](double) { return 1e-3; }, 5e7, 25.0},
  };
  for (const Function& function : functions) {
    const ModelFunction model = [&](std::span<const double> x, std::span<double> y) { y[0] = function.f(x[0]); };
    const LawResult law = propagated(model, 1, {{"x", function.x, function.u}}, Correlation::none(1));
    const InputContribution& c = law.outputs[0].contributions[0];
    EXPECT_NEAR(c.sensitivity, function.derivative(function.x), c.sensitivity_error + 1e-15 * std::abs(c.sensitivity));
    EXPECT_LE(c.sensitivity_error, 1e-6 * std::abs(c.sensitivity));
  }
}

TEST(LawOfPropagation, TakesDerivativesOfTheCaller) {
  const ModelFunction model = [](std::span<const double> x, std::span<double> y) { y[0] = x[0] * x[1]; };
  const JacobianFunction exact = [](std::span<const double> x, std::span<double> j) {
    j[0] = x[1];
    j[1] = x[0];
  };
  const std::vector<InputQuantity> inputs{{"a", 2, 0.1}, {"b", 3, 0.2}};
  const LawResult given = propagated(model, 1, inputs, Correlation::none(2), {.jacobian = exact});
  const LawResult computed = propagated(model, 1, inputs, Correlation::none(2));
  EXPECT_EQ(given.outputs[0].contributions[1].sensitivity_error, 0.0);
  EXPECT_DOUBLE_EQ(given.outputs[0].standard_uncertainty, std::hypot(0.3, 0.4));
  EXPECT_NEAR(computed.outputs[0].standard_uncertainty, std::hypot(0.3, 0.4), 1e-13);
}

TEST(LawOfPropagation, GivesResistanceReactanceAndImpedanceOfTheGUM) {
  // Validation: GUM H.2, approach 1; published to the digits that are compared.
  const ModelFunction impedance = [](std::span<const double> x, std::span<double> y) {
    const double z = x[0] / x[1];
    y[0] = z * std::cos(x[2]);
    y[1] = z * std::sin(x[2]);
    y[2] = z;
  };
  const std::vector<InputQuantity> inputs{
      {"V", 4.9990, 0.0032, 4}, {"I", 19.6610e-3, 0.0095e-3, 4}, {"phi", 1.04446, 0.00075, 4}};
  const auto r = Correlation::make(3, {1, -0.355, 0.858, -0.355, 1, -0.645, 0.858, -0.645, 1}).value();
  const LawResult law = propagated(impedance, 3, inputs, r);
  EXPECT_NEAR(law.outputs[0].estimate, 127.732, 5e-4);
  EXPECT_NEAR(law.outputs[1].estimate, 219.847, 5e-4);
  EXPECT_NEAR(law.outputs[2].estimate, 254.260, 5e-4);
  EXPECT_NEAR(law.outputs[0].standard_uncertainty, 0.071, 5e-4);
  EXPECT_NEAR(law.outputs[1].standard_uncertainty, 0.295, 5e-4);
  EXPECT_NEAR(law.outputs[2].standard_uncertainty, 0.236, 7e-4);  // 0.2366 from the rounded inputs
  EXPECT_NEAR(law.correlation(0, 1), -0.588, 5e-3);
  EXPECT_NEAR(law.correlation(0, 2), -0.485, 5e-3);
  EXPECT_NEAR(law.correlation(1, 2), 0.993, 5e-4);
  EXPECT_DOUBLE_EQ(law.correlation(1, 1), 1.0);
  for (const Budget& budget : law.outputs) EXPECT_EQ(budget.degrees_of_freedom, std::nullopt);
}

TEST(LawOfPropagation, CombinesDegreesOfFreedomOfIndependentInputs) {
  const ModelFunction sum = [](std::span<const double> x, std::span<double> y) { y[0] = x[0] + x[1] + x[2]; };
  const Budget budget =
      propagated(sum, 1, {{"a", 0, 1, 8}, {"b", 0, 1, 8}, {"c", 0, 1}}, Correlation::none(3)).outputs[0];
  EXPECT_NEAR(*budget.degrees_of_freedom, 36.0, 1e-9);
  EXPECT_NEAR(budget.coverage_factor, 2.0280940009804502, 1e-12);  // t for 36
  const Budget known = propagated(sum, 1, {{"a", 0, 1}, {"b", 0, 1}, {"c", 0, 1}}, Correlation::none(3)).outputs[0];
  EXPECT_TRUE(std::isinf(*known.degrees_of_freedom));
  EXPECT_NEAR(known.coverage_factor, 1.959963984540054, 1e-13);
  EXPECT_NEAR(known.interval.upper, 1.959963984540054 * std::sqrt(3), 1e-12);
}

TEST(LawOfPropagation, SaysNothingAboutDegreesOfFreedomWhereCorrelationForbidsIt) {
  const ModelFunction two_of_three = [](std::span<const double> x, std::span<double> y) { y[0] = x[0] + x[1]; };
  const auto with = [&](double ab, double ac) {
    const auto r = Correlation::make(3, {1, ab, ac, ab, 1, 0, ac, 0, 1}).value();
    return propagated(two_of_three, 1, {{"a", 0, 1, 8}, {"b", 0, 1}, {"c", 0, 1}}, r).outputs[0].degrees_of_freedom;
  };
  EXPECT_EQ(with(0.5, 0.0), std::nullopt);
  EXPECT_NEAR(with(0.0, 0.5).value(), 32.0, 1e-6);  // c does not count
}

TEST(LawOfPropagation, AddsTermsOfSecondOrder) {
  // y = x1² + x2² about 0 with correlated normal inputs: mean 2u², variance 4u⁴(1 + r²). Validation: closed form.
  const ModelFunction squares = [](std::span<const double> x, std::span<double> y) {
    y[0] = x[0] * x[0] + x[1] * x[1];
  };
  const auto r = Correlation::make(2, {1, 0.9, 0.9, 1}).value();
  const Budget at_zero =
      propagated(squares, 1, {{"x1", 0, 0.005}, {"x2", 0, 0.005}}, r, {.second_order = true}).outputs[0];
  EXPECT_NEAR(at_zero.standard_uncertainty, 0.0, 1e-12);
  EXPECT_NEAR(at_zero.second_order->estimate, 50e-6, 1e-15);
  EXPECT_NEAR(at_zero.second_order->standard_uncertainty, 50e-6 * std::sqrt(1.81), 1e-12);
  // y = exp(x): the terms of the second order are u⁴/2 + u⁴ of the variance.
  const ModelFunction exponential = [](std::span<const double> x, std::span<double> y) { y[0] = std::exp(x[0]); };
  const Budget curved =
      propagated(exponential, 1, {{"x", 0, 0.1}}, Correlation::none(1), {.second_order = true}).outputs[0];
  EXPECT_NEAR(curved.second_order->standard_uncertainty, std::sqrt(0.01 + 1.5e-4), 1e-7);
  EXPECT_NEAR(curved.second_order->estimate, 1.005, 1e-7);
}

TEST(LawOfPropagation, TakesTheScaleOfAStudentDistributionForTheStandardUncertainty) {
  const InputQuantity t = InputQuantity::of("t", Distribution::parse("t 4 1 2").value());
  EXPECT_EQ(t.estimate, 1.0);
  EXPECT_EQ(t.standard_uncertainty, 2.0);
  EXPECT_EQ(t.degrees_of_freedom, 4.0);
  EXPECT_DOUBLE_EQ(InputQuantity::of("u", Distribution::parse("uniform 0 6").value()).standard_uncertainty,
                   std::sqrt(3.0));
}

TEST(LawOfPropagation, RefusesWhatHasNoUncertainty) {
  const ModelFunction log = [](std::span<const double> x, std::span<double> y) { y[0] = std::log(x[0]); };
  EXPECT_EQ(error_of(log, {{"x", -1, 0.1}}), "found the value nan of output 1 at the estimates, expected a finite one");
  EXPECT_EQ(error_of(log, {{"x", 1, -0.1}}), "found the standard uncertainty -0.1 of \"x\", expected one not below 0");
  EXPECT_EQ(error_of(log, {{"x", NAN, 0.1}}), "found the estimate nan of \"x\", expected a finite one");
  EXPECT_EQ(error_of(log, {{"x", 1, 0.1, 0}}), "found 0 degrees of freedom of \"x\", expected more than 0");
  EXPECT_EQ(error_of(log, {{"x", 1, 0.1}}, {.coverage = 1.5}),
            "found the coverage probability 1.5, expected one between 0 and 1");
  const ModelFunction edge = [](std::span<const double> x, std::span<double> y) { y[0] = std::asin(x[0]); };
  EXPECT_EQ(
      error_of(edge, {{"x", 1, 0.1}}),
      "found no finite values of output 1 near the estimate of \"x\", expected a model that can be evaluated within "
      "its standard uncertainty");
}

}  // namespace
}  // namespace axiometry::uncertainty
