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
#include "python/native/interpreter.h"
#include "python/native/rooms.h"
#include "python/native/taken.h"

namespace axiometry::python {
namespace {

namespace py = pybind11;
using Numbers = py::array_t<double, py::array::c_style>;

constexpr std::size_t chunk_most = 256;        // tests at once
constexpr std::size_t chunk_readings = 32768;  // of all these tests: they stay in the cache
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
    leading_.assign(up.shape(), up.shape() + up.ndim() - 2);
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
        if (std::isnan(readings[k])) {
          std::vector<std::size_t> at = index_of(test);
          at.insert(at.end(), {k / runs_, k % runs_});
          return fail(fmt::format(
              "found no reading in {}[{}], expected all of them, or missing='omit' for what the others tell", name,
              fmt::join(at, ", ")));
        }
    return {};
  }

  /// Of the targets that have a reading; nothing where fewer than two have. Fails as Series::make_dense() does, naming
  /// the test. Positions do not enter the parameters of an axis: 0, 1, 2, ….
  Result<std::optional<Series>> series(std::size_t test) const {
    std::vector<std::size_t> there;
    const auto has_any = [](std::span<const double> cell) {
      return std::ranges::any_of(cell, [](double x) { return !std::isnan(x); });
    };
    for (std::size_t i = 0; i < targets_; ++i)
      if (has_any(cell(up(test), i)) || (has_down() && has_any(cell(down(test), i)))) there.push_back(i);
    if (there.size() < std::min<std::size_t>(targets_, 2)) return std::nullopt;
    std::vector<double> all;
    for (const std::size_t i : there) all.insert(all.end(), cell(up(test), i).begin(), cell(up(test), i).end());
    if (has_down())
      for (const std::size_t i : there) all.insert(all.end(), cell(down(test), i).begin(), cell(down(test), i).end());
    all.resize(2 * there.size() * runs_, absent);
    auto series = Series::make_dense(counted(there.size()), runs_, std::move(all));
    if (!series && !leading_.empty())
      return fail(fmt::format("test [{}]: {}", fmt::join(index_of(test), ", "), series.error().message));
    if (!series) return std::unexpected(std::move(series).error());
    return *std::move(series);
  }

  /// A complete test of this shape, of which nothing but the shape is read.
  Series shape() const {
    std::vector<double> all(2 * cells_, 0.0);
    if (!has_down()) std::fill(all.begin() + static_cast<std::ptrdiff_t>(cells_), all.end(), absent);
    return taken(Series::make_dense(counted(targets_), runs_, std::move(all)));
  }

  const std::vector<std::size_t>& leading() const { return leading_; }

 private:
  /// As numpy counts: from 0, one number for each axis before targets and runs.
  std::vector<std::size_t> index_of(std::size_t test) const {
    std::vector<std::size_t> index(leading_.size());
    for (std::size_t a = index.size(); a-- > 0; test /= leading_[a]) index[a] = test % leading_[a];
    return index;
  }

  std::span<const double> cell(std::span<const double> readings, std::size_t target) const {
    return readings.subspan(target * runs_, runs_);
  }

  static std::vector<Position> counted(std::size_t count) {
    std::vector<Position> targets;
    for (std::size_t i = 0; i < count; ++i) targets.push_back(Position::native(static_cast<double>(i)));
    return targets;
  }

  std::size_t targets_ = 0, runs_ = 0, cells_ = 0, tests_ = 0;
  std::vector<std::size_t> leading_;  // axes before targets and runs
  bool has_down_ = false;
  std::span<const double> up_, down_;
};

/// Parameters of all tests: a row of each that exists, a column of each test.
class Evaluator {
 public:
  Evaluator(const ManyReadings& readings, const iso230_2::BatchLayout& layout, std::vector<double*> rows, bool omits)
      : readings_(readings), layout_(layout), rows_(std::move(rows)), omits_(omits) {}

  /// With the kernel of the Monte Carlo method where every reading of some tests is there; else test by test.
  void evaluate() {
    for (std::size_t begin = 0; begin < readings_.tests(); begin += chunk_) {
      if (begin % (64 * chunk_) == 0) take_signals();
      const std::size_t count = std::min(chunk_, readings_.tests() - begin);
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
    if (!omits_) taken(readings_.check_complete(test));
    const std::optional<Series> series = taken(readings_.series(test));
    const iso230_2::AxisParameters found = series ? iso230_2::evaluate(*series).parameters : iso230_2::AxisParameters();
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const auto& value = found.*layout_.outputs()[k]->member;
      rows_[k][test] = value ? value->in_native() : absent;
    }
  }

  static constexpr double largest = 1e9;  // of a Series

  const ManyReadings& readings_;
  const iso230_2::BatchLayout& layout_;
  std::vector<double*> rows_;
  bool omits_;
  std::size_t chunk_ = std::clamp<std::size_t>(chunk_readings / layout_.reading_rows() / 8 * 8, 8, chunk_most);
  std::size_t stride_ = chunk_ + 8;  // no power of 2, whose columns would share a few lines of the cache
  numeric::RowBuffer<double> table_{layout_.reading_rows(), stride_};
  numeric::RowBuffer<double> found_{layout_.outputs().size(), stride_};
};

/// Shapes and kinds are what axiometry.parameters() has checked.
py::dict parameters(const Numbers& up, const std::optional<Numbers>& down, bool omits) {
  const ManyReadings readings(up, down);
  py::dict found;
  std::vector<double*> rows;
  const iso230_2::BatchLayout layout(readings.shape());
  for (const iso230_2::ParameterInfo* parameter : layout.outputs()) {
    Numbers row(readings.leading());
    rows.push_back(row.mutable_data());
    found[py::str(std::string(parameter->key))] = std::move(row);
  }
  const OthersRun others_run;
  Evaluator(readings, layout, std::move(rows), omits).evaluate();
  return found;
}

}  // namespace

void add_parameters(py::module_& module) { module.def("parameters", &parameters); }

}  // namespace axiometry::python
