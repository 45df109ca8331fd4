// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/uncertainty/joint_distribution.h"
#include "axiometry/uncertainty/monte_carlo.h"
#include "axiometry/uncertainty/propagate.h"
#include "python/native/interpreter.h"
#include "python/native/rooms.h"
#include "python/native/taken.h"

namespace axiometry::python {
namespace {

namespace py = pybind11;
using namespace uncertainty;
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A model of Python: takes a list of arrays, one per input, and gives a list of arrays of the same length, one per
/// output (axiometry.propagate() makes it so).
class PythonModel {
 public:
  PythonModel(py::function function, std::size_t outputs) : function_(std::move(function)), outputs_(outputs) {}

  /// Contract: the interpreter is held.
  void compute(const BlockOutputs& inputs, std::size_t count, BlockOutputs outputs) const {
    py::list arguments;
    for (std::size_t i = 0; i < count; ++i) {
      const std::span<double> row = inputs.row(i);
      arguments.append(Numbers(static_cast<py::ssize_t>(row.size()), row.data()));
    }
    const auto found = function_(arguments).cast<std::vector<Numbers>>();
    if (found.size() != outputs_) throw Failure(fmt::format("found {} outputs, expected {}", found.size(), outputs_));
    for (std::size_t k = 0; k < outputs_; ++k)
      if (static_cast<std::size_t>(found[k].size()) != outputs.trials)
        throw Failure(fmt::format("found an output of {} trials, expected {}", found[k].size(), outputs.trials));
    for (std::size_t k = 0; k < outputs_; ++k) std::copy_n(found.at(k).data(), outputs.trials, outputs.row(k).data());
  }

  ModelFunction of_one() const {
    return [this](std::span<const double> x, std::span<double> y) {
      std::vector<double> inputs(x.begin(), x.end());
      compute({inputs, 1}, x.size(), {y, 1});
    };
  }

  /// One at a time: the interpreter runs no second one beside it.
  BlockModel of_blocks(const JointDistribution& inputs, std::uint64_t seed) const {
    return [this, &inputs, seed](std::uint64_t block, BlockOutputs outputs) {
      std::vector<double> draws(inputs.size() * outputs.trials);
      const BlockOutputs rows{draws, outputs.trials};
      inputs.sample({.seed = seed, .stream = 0, .block = block}, rows);
      const py::gil_scoped_acquire python;
      compute(rows, inputs.size(), outputs);
    };
  }

 private:
  py::function function_;
  std::size_t outputs_;
};

py::tuple interval_of(const Interval& interval) { return py::make_tuple(interval.lower, interval.upper); }

py::object or_none(const std::optional<double>& x) { return x ? py::cast(*x) : py::none(); }

py::dict by_law(const Budget& budget) {
  py::dict found;
  found["value"] = budget.estimate;
  found["u"] = budget.standard_uncertainty;
  found["k"] = budget.coverage_factor;
  found["U"] = budget.expanded_uncertainty;
  found["nu_eff"] = or_none(budget.degrees_of_freedom);
  found["interval"] = interval_of(budget.interval);
  py::list sensitivities, errors, contributions;
  for (const InputContribution& input : budget.contributions) {
    sensitivities.append(input.sensitivity);
    errors.append(input.sensitivity_error);
    contributions.append(input.contribution);
  }
  found["sensitivities"] = sensitivities;
  found["sensitivity_errors"] = errors;
  found["contributions"] = contributions;
  return found;
}

py::dict by_trials(const OutputSummary& summary) {
  py::dict found;
  found["value"] = summary.mean;
  found["u"] = summary.sd;
  found["symmetric"] = interval_of(summary.symmetric);
  found["shortest"] = interval_of(summary.shortest);
  found["tolerance"] = summary.tolerance;
  found["stable"] = summary.stable;
  return found;
}

struct PropagationCall {
  std::vector<std::string> names;
  std::vector<std::string> distributions;  ///< as Distribution::parse()
  std::vector<double> correlation;         ///< rows one after another
  std::size_t outputs = 1;
  std::optional<std::size_t> trials;
  std::uint64_t seed = 1;
  double coverage = 0.95;
};

Result<std::vector<Distribution>> distributions_of(const std::vector<std::string>& names,
                                                   const std::vector<std::string>& texts) {
  std::vector<Distribution> distributions;
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto distribution = Distribution::parse(texts[i]);
    if (!distribution) return fail(fmt::format("{}: {}", names[i], distribution.error().message));
    distributions.push_back(*std::move(distribution));
  }
  return distributions;
}

Result<JointDistribution> inputs_of(const PropagationCall& call) {
  AXIOMETRY_TRY(std::vector<Distribution> marginals, distributions_of(call.names, call.distributions));
  AXIOMETRY_TRY(Correlation correlation, Correlation::make(marginals.size(), call.correlation));
  return JointDistribution(std::move(marginals), std::move(correlation));
}

py::list law_of(const PythonModel& model, const JointDistribution& inputs, const PropagationCall& call) {
  std::vector<InputQuantity> quantities;
  for (std::size_t i = 0; i < inputs.size(); ++i)
    quantities.push_back(InputQuantity::of(call.names[i], inputs.marginals()[i]));
  const LawResult law = taken(
      law_of_propagation(model.of_one(), call.outputs, quantities, inputs.correlation(), {.coverage = call.coverage}));
  py::list found;
  for (const Budget& budget : law.outputs) found.append(by_law(budget));
  return found;
}

std::pair<py::list, std::size_t> trials_of(const PythonModel& model, const JointDistribution& inputs,
                                           const PropagationCall& call) {
  PropagationOptions options;
  options.trials = call.trials;
  options.coverage = call.coverage;
  options.threads = 1;
  bool stopped = false;
  options.on_progress = [&stopped](const Progress&) {
    const py::gil_scoped_acquire python;
    stopped = stopped || PyErr_CheckSignals() != 0;
    return !stopped;
  };
  const auto run = [&] {
    const OthersRun others_run;
    return propagate(model.of_blocks(inputs, call.seed), call.outputs, options);
  };
  auto result = run();
  if (stopped) throw py::error_already_set();
  const MonteCarloResult done = taken(std::move(result));
  py::list found;
  for (const OutputSummary& summary : done.outputs) found.append(by_trials(summary));
  return {found, done.trials};
}

}  // namespace

void add_propagation(py::module_& module) {
  module.def("estimates", [](const std::vector<std::string>& names, const std::vector<std::string>& texts) {
    std::vector<double> means;
    for (const Distribution& distribution : taken(distributions_of(names, texts))) means.push_back(distribution.mean());
    return means;
  });
  module.def("propagate", [](py::function function, PropagationCall call) {
    const JointDistribution inputs = taken(inputs_of(call));
    const PythonModel model(std::move(function), call.outputs);
    py::list law = law_of(model, inputs, call);  // quick, and refuses most
    const auto [trials, count] = trials_of(model, inputs, call);
    return py::make_tuple(std::move(law), trials, count);
  });
  py::class_<PropagationCall>(module, "PropagationCall")
      .def(py::init<std::vector<std::string>, std::vector<std::string>, std::vector<double>, std::size_t,
                    std::optional<std::size_t>, std::uint64_t, double>());
}

}  // namespace axiometry::python
