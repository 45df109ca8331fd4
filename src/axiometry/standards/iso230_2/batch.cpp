// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/batch.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/kernels/kernel_table.h"

namespace axiometry::iso230_2 {

AXIOMETRY_KERNEL_TABLE(batch_kernel, BatchKernel);

const BatchKernel& batch_kernel_of(numeric::VectorTarget target) { return batch_kernel_table.of(target); }

namespace {

using numeric::Rows;
using numeric::VectorTarget;

static_assert(std::size(parameters) == batch_parameters && parameters[0].key == "A" && parameters[3].key == "E" &&
                  parameters[6].key == "M" && parameters[7].key == "R" && parameters[10].key == "B",
              "the kernel stores in this order");

/// A table too narrow for a register, with its last column repeated.
template <typename Number>
std::vector<Number> widened(Rows<const Number> rows, std::size_t count, std::size_t trials) {
  std::vector<Number> wide(count * batch_trials_min);
  for (std::size_t r = 0; r < count; ++r)
    for (std::size_t t = 0; t < batch_trials_min; ++t)
      wide[r * batch_trials_min + t] = rows.values[r * rows.stride + std::min(t, trials - 1)];
  return wide;
}

template <typename Number>
BatchInput<Number> input_of(Rows<const Number> rows) {
  return {rows.values.data(), rows.stride};
}

/// Calls run(parameters) with a table wide enough for the kernels, and copies when it is not the caller's.
template <typename Number, typename Run>
void into(Rows<Number> parameters, std::size_t count, std::size_t trials, Run run) {
  if (trials >= batch_trials_min) return run(BatchOutput<Number>{parameters.values.data(), parameters.stride});
  std::vector<Number> wide(count * batch_trials_min);
  run(BatchOutput<Number>{wide.data(), batch_trials_min});
  for (std::size_t r = 0; r < count; ++r)
    std::copy_n(wide.data() + r * batch_trials_min, trials, parameters.values.data() + r * parameters.stride);
}

template <typename Number>
void run_readings(BatchFromReadings<Number> kernel, const BatchLayout& layout, Rows<const Number> readings,
                  std::size_t trials, Rows<Number> result) {
  AXIOMETRY_CONTRACT(readings.hold(layout.reading_rows(), trials) && result.hold(layout.outputs().size(), trials));
  if (trials == 0) return;
  std::vector<Number> wide;
  if (trials < batch_trials_min) {
    wide = widened(readings, layout.reading_rows(), trials);
    readings = {wide, batch_trials_min};
  }
  into(result, layout.outputs().size(), trials, [&](BatchOutput<Number> output) {
    kernel(layout.view(), input_of(readings), std::max(trials, batch_trials_min), output);
  });
}

template <typename Number>
void run_moments(BatchFromMoments<Number> kernel, const BatchLayout& layout, CellMoments<Number> moments,
                 std::size_t trials, Rows<Number> result) {
  const std::size_t cells = layout.cell_rows();
  AXIOMETRY_CONTRACT(moments.means.hold(cells, trials) && moments.estimators.hold(cells, trials));
  AXIOMETRY_CONTRACT(result.hold(layout.outputs().size(), trials));
  if (trials == 0) return;
  std::vector<Number> wide_means, wide_estimators;
  if (trials < batch_trials_min) {
    wide_means = widened(moments.means, cells, trials);
    wide_estimators = widened(moments.estimators, cells, trials);
    moments = {{wide_means, batch_trials_min}, {wide_estimators, batch_trials_min}};
  }
  into(result, layout.outputs().size(), trials, [&](BatchOutput<Number> output) {
    kernel(layout.view(), input_of(moments.means), input_of(moments.estimators), std::max(trials, batch_trials_min),
           output);
  });
}

}  // namespace

BatchLayout::BatchLayout(const Series& series)
    : targets_(series.target_count()),
      complete_runs_(series.complete() ? series.run_count() : 0),
      reading_rows_(2 * series.target_count() * series.run_count()),
      begins_{0} {
  for (Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < targets_; ++i) {
      const auto cell = series.cell(i, direction);
      const std::size_t first = (static_cast<std::size_t>(direction) * targets_ + i) * cell.size();
      for (std::size_t j = 0; j < cell.size(); ++j)
        if (!std::isnan(cell[j])) rows_.push_back(static_cast<std::uint32_t>(first + j));
      begins_.push_back(static_cast<std::uint32_t>(rows_.size()));
    }
  const AxisParameters existing = evaluate(series).parameters;
  for (const ParameterInfo& parameter : parameters)
    if (existing.*parameter.member) outputs_.push_back(&parameter);
}

BatchView BatchLayout::view() const {
  BatchView view{targets_, begins_.data(), rows_.data(), complete_runs_, {}};
  std::ranges::fill(view.output_rows, -1);
  for (std::size_t row = 0; row < outputs_.size(); ++row)
    view.output_rows[outputs_[row] - parameters] = static_cast<int>(row);
  return view;
}

void evaluate_batch(const BatchLayout& layout, Rows<const double> readings, std::size_t trials, Rows<double> result,
                    VectorTarget target) {
  run_readings(batch_kernel_of(target).from_readings, layout, readings, trials, result);
}

void evaluate_batch(const BatchLayout& layout, Rows<const float> readings, std::size_t trials, Rows<float> result,
                    VectorTarget target) {
  run_readings(batch_kernel_of(target).from_readings_single, layout, readings, trials, result);
}

void evaluate_batch(const BatchLayout& layout, CellMoments<double> moments, std::size_t trials, Rows<double> result,
                    VectorTarget target) {
  run_moments(batch_kernel_of(target).from_moments, layout, moments, trials, result);
}

void evaluate_batch(const BatchLayout& layout, CellMoments<float> moments, std::size_t trials, Rows<float> result,
                    VectorTarget target) {
  run_moments(batch_kernel_of(target).from_moments_single, layout, moments, trials, result);
}

}  // namespace axiometry::iso230_2
