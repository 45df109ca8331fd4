// SPDX-License-Identifier: Apache-2.0
//
// The reference is evaluate(): every trial of a batch is made a series and evaluated by it.
#include "axiometry/standards/iso230_2/batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "axiometry/numeric/random/random.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using numeric::Rows;

using testing_support::none;

struct Shape {
  std::size_t targets = 2;
  std::size_t runs = 1;
  std::string missing;  ///< "nothing", "down" (all of it), "some", "runs" (one run ↓ less), "ends" (from one side only)
};

bool is_missing(const Shape& shape, std::size_t row, double chance) {
  const bool down = row >= shape.targets * shape.runs;
  const std::size_t target = row / shape.runs % shape.targets;
  const std::size_t run = row % shape.runs;
  if (shape.missing == "down") return down;
  if (shape.missing == "some") return chance < 0.4 && (run > 0 || down == (target % 2 == 0));  // one each stays
  if (shape.missing == "runs") return down && run + 1 == shape.runs;
  if (shape.missing == "ends") return (target == 0 && down) || (target + 1 == shape.targets && !down);
  return false;
}

std::vector<Position> positions(std::size_t count) {
  std::vector<Position> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(Position::native(100.0 * static_cast<double>(i)));
  return result;
}

/// Trials of a test of some shape, as rows.
struct Trials {
  Shape shape;
  std::size_t count;
  std::vector<double> readings;  // the rows of missing readings are NaN

  Trials(const Shape& of, std::size_t trials) : shape(of), count(trials) {
    const std::size_t rows = 2 * shape.targets * shape.runs;
    readings.resize(rows * count);
    numeric::fill_normal({1, rows, count}, readings);
    std::vector<double> chances(rows);
    numeric::fill_uniform({2, rows, 0}, chances);
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t t = 0; t < count; ++t) {
        double& x = readings[row * count + t];
        x = is_missing(shape, row, chances[row]) ? none : 3.0 * x + 0.1 * static_cast<double>(row % 17);
      }
  }

  Series series(std::size_t trial) const {
    std::vector<double> deviations;
    for (std::size_t row = 0; row * count < readings.size(); ++row) deviations.push_back(readings[row * count + trial]);
    return *Series::make_dense(positions(shape.targets), shape.runs, std::move(deviations));
  }
};

std::vector<Shape> shapes() {
  std::vector<Shape> result;
  for (std::size_t targets : {2u, 3u, 11u, 22u})
    for (std::size_t runs : {1u, 2u, 3u, 5u, 7u, 10u})
      for (const char* missing : {"nothing", "down", "some", "runs", "ends"})
        if (runs > 1 || std::string(missing) != "runs") result.push_back({targets, runs, missing});
  return result;
}

std::string name(const Shape& shape) {
  return std::to_string(shape.targets) + " x " + std::to_string(shape.runs) + ", missing: " + shape.missing;
}

/// Each parameter of each trial against evaluate(), within `tolerance`.
template <typename Number>
void expect_parameters(const Trials& trials, const BatchLayout& layout, const std::vector<Number>& parameters,
                       double tolerance) {
  for (std::size_t t = 0; t < trials.count; ++t) {
    const AxisParameters expected = evaluate(trials.series(t)).parameters;
    std::size_t row = 0;
    for (const ParameterInfo& parameter : iso230_2::parameters) {
      const auto value = expected.*parameter.member;
      if (!value) continue;
      ASSERT_LT(row, layout.outputs().size());
      ASSERT_EQ(layout.outputs()[row], &parameter);
      ASSERT_NEAR(parameters[row++ * trials.count + t], value->in_native(), tolerance) << parameter.key << ' ' << t;
    }
    ASSERT_EQ(row, layout.outputs().size());
  }
}

template <typename Number>
std::vector<Number> batch(const Trials& trials, const BatchLayout& layout, numeric::VectorTarget target) {
  const std::vector<Number> readings(trials.readings.begin(), trials.readings.end());
  std::vector<Number> parameters(layout.outputs().size() * trials.count, Number(-99));
  evaluate_batch(layout, Rows<const Number>{readings, trials.count}, trials.count,
                 Rows<Number>{parameters, trials.count}, target);
  return parameters;
}

TEST(EvaluateBatch, GivesForEveryTrialWhatEvaluateGives) {
  for (const Shape& shape : shapes())
    for (std::size_t count : {1u, 16u, 19u}) {
      const Trials trials(shape, count);
      const BatchLayout layout(trials.series(0));
      for (numeric::VectorTarget target : numeric::available_vector_targets()) {
        SCOPED_TRACE(name(shape) + ", " + std::string(vector_target_name(target)));
        const auto parameters = batch<double>(trials, layout, target);
        EXPECT_EQ(parameters, batch<double>(trials, layout, numeric::VectorTarget::plain)) << "not the same bits";
        expect_parameters(trials, layout, parameters, 0.0);
      }
    }
}

double largest(const std::vector<double>& readings) {
  double result = 0;
  for (double x : readings)
    if (!std::isnan(x)) result = std::max(result, std::abs(x));
  return result;
}

TEST(EvaluateBatch, KeepsItsErrorBoundInSinglePrecision) {
  for (const Shape& shape : shapes()) {
    Trials trials(shape, 19);
    for (double& x : trials.readings) x = static_cast<float>(x);
    const BatchLayout layout(trials.series(0));
    const auto n = static_cast<double>(shape.runs);
    const auto m = static_cast<double>(shape.targets);
    const double bound = (11 * n + 2 * m + 45) * 0x1p-24 * largest(trials.readings);
    for (numeric::VectorTarget target : numeric::available_vector_targets()) {
      SCOPED_TRACE(name(shape) + ", " + std::string(vector_target_name(target)));
      const auto parameters = batch<float>(trials, layout, target);
      EXPECT_EQ(parameters, batch<float>(trials, layout, numeric::VectorTarget::plain)) << "not the same bits";
      expect_parameters(trials, layout, parameters, bound);
    }
  }
}

TEST(EvaluateBatch, TakesMomentsInsteadOfReadings) {
  for (const Shape& shape : shapes())
    for (std::size_t count : {3u, 21u}) {
      const Trials trials(shape, count);
      const BatchLayout layout(trials.series(0));
      std::vector<double> means(layout.cell_rows() * count, none), estimators = means;
      for (std::size_t t = 0; t < count; ++t) {
        const auto positions = evaluate(trials.series(t)).positions;
        for (std::size_t i = 0; i < positions.size(); ++i) {
          const auto set = [&](std::vector<double>& rows, std::size_t cell, const std::optional<Deviation>& value) {
            if (value) rows[cell * count + t] = value->in_native();
          };
          set(means, i, positions[i].mean_up);
          set(means, positions.size() + i, positions[i].mean_down);
          set(estimators, i, positions[i].s_up);
          set(estimators, positions.size() + i, positions[i].s_down);
        }
      }
      for (numeric::VectorTarget target : numeric::available_vector_targets()) {
        SCOPED_TRACE(name(shape) + ", " + std::string(vector_target_name(target)));
        std::vector<double> parameters(layout.outputs().size() * count);
        const CellMoments<double> moments{{means, count}, {estimators, count}};
        evaluate_batch(layout, moments, count, Rows<double>{parameters, count}, target);
        expect_parameters(trials, layout, parameters, 0.0);
        const std::vector<float> m(means.begin(), means.end()), s(estimators.begin(), estimators.end());
        std::vector<float> single(parameters.size());
        evaluate_batch(layout, CellMoments<float>{{m, count}, {s, count}}, count, Rows<float>{single, count}, target);
        expect_parameters(trials, layout, single, 1e-4);
      }
    }
}

TEST(EvaluateBatch, WritesNothingBeyondItsTrials) {
  const Trials trials({3, 5, "nothing"}, 21);
  const BatchLayout layout(trials.series(0));
  for (std::size_t count : {0u, 1u, 15u, 16u, 20u}) {
    std::vector<double> parameters(layout.outputs().size() * 21, -99.0);
    evaluate_batch(layout, Rows<const double>{trials.readings, 21}, count, Rows<double>{parameters, 21});
    for (std::size_t row = 0; row < layout.outputs().size(); ++row)
      for (std::size_t t = 0; t < 21; ++t)
        EXPECT_EQ(parameters[row * 21 + t] == -99.0, t >= count) << count << ' ' << t;
  }
}

TEST(BatchLayout, TellsWhichParametersExist) {
  const auto keys = [](const Shape& shape) {
    std::string result;
    const BatchLayout layout(Trials(shape, 1).series(0));
    for (const ParameterInfo* parameter : layout.outputs())
      result += (result.empty() ? "" : " ") + std::string(parameter->key);
    return result;
  };
  EXPECT_EQ(keys({3, 5, "nothing"}), "A A_up A_down E E_up E_down M R R_up R_down B B_mean");
  EXPECT_EQ(keys({3, 1, "nothing"}), "E E_up E_down M B B_mean");
  EXPECT_EQ(keys({3, 5, "down"}), "A_up E_up R_up");
}

}  // namespace
}  // namespace axiometry::iso230_2
