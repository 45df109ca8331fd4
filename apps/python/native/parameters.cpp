// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/parameters.h"

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "axiometry/standards/iso230_2/batch.h"
#include "python/native/rooms.h"
#include "python/native/taken.h"

namespace axiometry::python {
namespace {

namespace py = pybind11;
using Numbers = py::array_t<double, py::array::c_style>;

constexpr std::size_t chunk = 256;         // tests at once: their readings stay in the cache
constexpr std::size_t stride = chunk + 8;  // no power of 2, whose columns would share a few lines of the cache
constexpr double absent = std::numeric_limits<double>::quiet_NaN();

/// Readings of many tests of one shape: (…, targets, runs) of each direction, run fastest.
class ManyReadings {
 public:
  ManyReadings(const Numbers& up, const std::optional<Numbers>& down) {
    const auto axes = static_cast<std::size_t>(up.ndim());
    targets_ = static_cast<std::size_t>(up.shape(static_cast<py::ssize_t>(axes) - 2));
    runs_ = static_cast<std::size_t>(up.shape(static_cast<py::ssize_t>(axes) - 1));
    cells_ = targets_ * runs_;
    tests_ = cells_ == 0 ? 0 : static_cast<std::size_t>(up.size()) / cells_;
    up_ = {up.data(), static_cast<std::size_t>(up.size())};
    has_down_ = down.has_value();
    if (down) down_ = {down->data(), static_cast<std::size_t>(down->size())};
  }

  std::size_t tests() const { return tests_; }
  bool has_down() const { return has_down_; }
  std::span<const double> up(std::size_t test) const { return up_.subspan(test * cells_, cells_); }
  std::span<const double> down(std::size_t test) const { return down_.subspan(test * cells_, cells_); }

  /// Names the first reading that is not there.
  Result<void> check_complete(std::size_t test) const {
    for (const auto& [name, readings] :
         {std::pair{"up", up(test)}, std::pair{"down", has_down() ? down(test) : up(test)}})
      for (std::size_t k = 0; k < cells_; ++k)
        if (std::isnan(readings[k]))
          return fail(
              fmt::format("found no reading of target {}, run {} in {}{}, expected all of them, or "
                          "missing='lower-bound' for what the others tell",
                          k / runs_ + 1, k % runs_ + 1, name, tests_ > 1 ? fmt::format(" of test {}", test) : ""));
    return {};
  }

  /// Fails as Series::make_dense() does, naming the test. Targets do not enter the parameters of an axis: 0, 1, 2, ….
  Result<Series> series(std::size_t test) const {
    std::vector<double> all(up(test).begin(), up(test).end());
    if (has_down())
      all.insert(all.end(), down(test).begin(), down(test).end());
    else
      all.resize(2 * cells_, absent);
    auto series = Series::make_dense(counted_targets(), runs_, std::move(all));
    if (!series && tests_ > 1) return fail(fmt::format("test {}: {}", test, series.error().message));
    return series;
  }

  /// A complete test of this shape, of which nothing but the shape is read.
  Series shape() const {
    std::vector<double> all(2 * cells_, 0.0);
    if (!has_down()) std::fill(all.begin() + static_cast<std::ptrdiff_t>(cells_), all.end(), absent);
    return taken(Series::make_dense(counted_targets(), runs_, std::move(all)));
  }

 private:
  std::vector<Position> counted_targets() const {
    std::vector<Position> targets;
    for (std::size_t i = 0; i < targets_; ++i) targets.push_back(Position::native(static_cast<double>(i)));
    return targets;
  }

  std::size_t targets_ = 0, runs_ = 0, cells_ = 0, tests_ = 0;
  bool has_down_ = false;
  std::span<const double> up_, down_;
};

/// Parameters of all tests: a row of each that exists, a column of each test.
class Evaluator {
 public:
  Evaluator(const ManyReadings& readings, const iso230_2::BatchLayout& layout, std::vector<double*> rows,
            bool lower_bounds)
      : readings_(readings), layout_(layout), rows_(std::move(rows)), lower_bounds_(lower_bounds) {}

  /// With the kernel of the Monte Carlo method where every reading of some tests is there; else test by test.
  void evaluate() {
    for (std::size_t begin = 0; begin < readings_.tests(); begin += chunk) {
      const std::size_t count = std::min(chunk, readings_.tests() - begin);
      if (place_all(begin, count))
        evaluate_complete(begin, count);
      else
        for (std::size_t t = begin; t < begin + count; ++t) evaluate_one(t);
    }
  }

 private:
  void evaluate_complete(std::size_t begin, std::size_t count) {
    numeric::Rows<double> found = found_.rows();
    iso230_2::evaluate_batch(layout_, table_.rows(), count, found);
    for (std::size_t k = 0; k < rows_.size(); ++k) std::ranges::copy(found.row(k, count), rows_[k] + begin);
  }

  /// False where some reading is missing, or none that a series may have.
  bool place_all(std::size_t begin, std::size_t count) {
    const numeric::Rows<double> table = table_.rows();
    bool sound = true;
    for (std::size_t t = 0; t < count && sound; ++t) {
      sound = place(readings_.up(begin + t), 0, t, table);
      if (readings_.has_down()) sound &= place(readings_.down(begin + t), layout_.reading_rows() / 2, t, table);
    }
    return sound;
  }

  static bool place(std::span<const double> values, std::size_t first_row, std::size_t column,
                    numeric::Rows<double> table) {
    bool sound = true;
    for (std::size_t r = 0; r < values.size(); ++r) {
      sound &= std::abs(values[r]) <= largest;
      table.values[(first_row + r) * table.stride + column] = values[r];
    }
    return sound;
  }

  void evaluate_one(std::size_t test) {
    if (!lower_bounds_) taken(readings_.check_complete(test));
    const iso230_2::Evaluation one = iso230_2::evaluate(taken(readings_.series(test)));
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const auto& value = one.parameters.*layout_.outputs()[k]->member;
      rows_[k][test] = value ? value->in_native() : absent;
    }
  }

  static constexpr double largest = 1e9;  // of a Series

  const ManyReadings& readings_;
  const iso230_2::BatchLayout& layout_;
  std::vector<double*> rows_;
  bool lower_bounds_;
  numeric::RowBuffer<double> table_{layout_.reading_rows(), stride};
  numeric::RowBuffer<double> found_{layout_.outputs().size(), stride};
};

/// Shapes and kinds are what axiometry.parameters() has checked.
py::dict parameters(const Numbers& up, const std::optional<Numbers>& down, bool lower_bounds) {
  const ManyReadings readings(up, down);
  py::dict found;
  std::vector<double*> rows;
  const std::vector<py::ssize_t> shape(up.shape(), up.shape() + up.ndim() - 2);
  const iso230_2::BatchLayout layout(readings.shape());
  for (const iso230_2::ParameterInfo* parameter : layout.outputs()) {
    Numbers row(shape);
    rows.push_back(row.mutable_data());
    found[py::str(std::string(parameter->key))] = std::move(row);
  }
  const py::gil_scoped_release others_run;
  Evaluator(readings, layout, std::move(rows), lower_bounds).evaluate();
  return found;
}

}  // namespace

void add_parameters(py::module_& module) { module.def("parameters", &parameters); }

}  // namespace axiometry::python
