// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/evaluate_run.h"
#include "cli/failure.h"

#include <fmt/format.h>

#include <cstdio>
#include <functional>
#include <optional>
#include <utility>

#include "axiometry/app/evaluate/evaluate_many.h"
#include "axiometry/app/results/second_opinion.h"
#include "axiometry/report/shown_number.h"
#include "cli/text/progress.h"
#include "cli/text/summary.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

/// One run of the verb: takes the tests as they come and decides, with the first one, whether there
/// is one test or there are many.
class Run {
 public:
  explicit Run(EvaluateArguments& arguments)
      : arguments_(arguments), terminal_(arguments.colour), bar_(!arguments.quiet) {
    arguments_.evaluate.uncertainty.trials.propagation.on_progress = std::ref(bar_);
    stdout_is_free_ = !arguments.quiet && arguments.outputs.json != "-";
    threads_ = {arguments.evaluate.uncertainty.trials.propagation.threads,
                [this](app::Evaluated& evaluated) { return checked_text(evaluated); }};
  }

  int operator()() {
    if (auto table = open_table(); !table) return gave_up(table.error(), exit_bad_input);
    auto inputs = app::expand_inputs(arguments_.inputs);
    if (!inputs) return gave_up(inputs.error(), exit_bad_input);
    many_ = inputs->size() > 1 || (!inputs->empty() && inputs->front().from_folder);
    if (inputs->empty())
      return gave_up({"found no file in the folder, expected measured tests", arguments_.inputs.front(), {}},
                     exit_bad_input);
    if (inputs->size() > 1 && arguments_.evaluate.temperatures)
      return gave_up({"found several inputs, expected one test with --temperatures", "", {}}, exit_usage);
    arguments_.evaluate.tolerance.many_tests = many_;
    std::vector<app::InputFile> all_read = *inputs;
    if (const auto& table = arguments_.evaluate.tolerance.table) all_read.push_back({table->file, false});
    if (!arguments_.evaluate.profile.empty()) all_read.push_back({arguments_.evaluate.profile, false});
    if (!arguments_.recording.plan.empty()) all_read.push_back({arguments_.recording.plan, false});
    for (const std::string& more : {arguments_.evaluate.drift_recording, arguments_.temperatures.file})
      if (!more.empty()) all_read.push_back({more, false});
    arguments_.outputs.inputs = app::InputFiles(all_read);
    if (auto spared = app::check_inputs_spared(arguments_.outputs); !spared) return gave_up(spared.error(), exit_usage);
    for (const app::InputFile& input : *inputs) {
      if (!evaluate(input) && !go_on()) return exit_code_;
    }
    return finish();
  }

 private:
  int gave_up(const Error& error, int code) {
    failed(error);
    exit_code_ = code;
    return code;
  }

  Result<void> open_table() {
    if (arguments_.tolerance_table.empty()) return {};
    const auto [file, name] = app::parse_table_name(arguments_.tolerance_table);
    AXIOMETRY_TRY(arguments_.evaluate.tolerance.table, app::open_tolerance_table(file));
    arguments_.evaluate.tolerance.table_name = name;
    return {};
  }

  bool go_on() const { return many_ && !output_failed_ && !InterruptGuard::interrupted(); }

  /// False after an error, which has been reported.
  bool evaluate(const app::InputFile& input) {
    const auto result = app::evaluate_input(
        input, arguments_.evaluate, threads_,
        [&](app::Evaluated&& evaluated, std::string&& text) { return take(std::move(evaluated), text); });
    bar_.clear();
    if (result && !*result) tell({"passed over, no known format", input.name, {}});
    if (result) return true;
    if (InterruptGuard::interrupted()) {
      gave_up(result.error(), exit_interrupted);
      return false;
    }
    gave_up(result.error(), output_failed_ == exit_usage ? exit_usage : exit_bad_input);
    if (many_ && !output_failed_) add_to_outputs(input.name, result.error());
    return false;
  }

  /// Also when it is the first of many: with --keep-going every bad input is named.
  void add_to_outputs(const std::string& file, const Error& error) {
    auto ready = prepare_outputs();
    if (ready) ready = outputs_->add_error(file, error);
    if (ready) return;
    if (!output_failed_) output_failed_ = exit_bad_input;
    gave_up(ready.error(), output_failed_);
  }

  /// Makes the outputs of many tests before the first of them.
  Result<void> prepare_outputs() {
    if (outputs_) return {};
    auto outputs = app::ManyOutputs::create(arguments_.outputs, arguments_.report);
    if (outputs) {
      outputs_ = std::move(*outputs);
      return {};
    }
    output_failed_ = outputs.error().file.empty() ? exit_usage : exit_bad_input;
    return std::unexpected(at_outputs(outputs.error()));
  }

  Result<void> verify(app::Evaluated& evaluated) const {
    if (!arguments_.verify || evaluated.verified) return {};
    AXIOMETRY_TRY(evaluated.verified,
                  app::second_opinion(evaluated, arguments_.evaluate.uncertainty, arguments_.report));
    return {};
  }

  /// What takes longest of a test among many, on the thread that evaluates it: nothing of the run is changed.
  Result<std::string> checked_text(app::Evaluated& evaluated) const {
    AXIOMETRY_TRY_VOID(verify(evaluated));
    return arguments_.outputs.json.empty() ? std::string() : app::json_line(evaluated);
  }

  Result<void> take(app::Evaluated&& evaluated, const std::string& text) {
    bar_.clear();
    AXIOMETRY_TRY_VOID(verify(evaluated));
    using enum uncertainty::Verdict;
    const auto verdict = iso230_2::overall_verdict(evaluated.judgements);
    exceeded_ = exceeded_ || verdict == does_not_conform;
    undecided_ = undecided_ || verdict == undecided || verdict == not_applicable;
    many_ = many_ || !evaluated.name.empty();
    if (!many_) {
      single_ = std::move(evaluated);
      return {};
    }
    AXIOMETRY_TRY_VOID(prepare_outputs());
    if (stdout_is_free_ && count_ == 0) fmt::print("{}", line_header(arguments_.report, terminal_));
    if (stdout_is_free_) fmt::print("{}", line(evaluated, arguments_.report, terminal_));
    ++count_;
    auto added = outputs_->add(evaluated, text);
    for (const std::string& note : outputs_->numbered()) tell(note);
    if (added) return {};
    output_failed_ = exit_bad_input;
    return std::unexpected(at_outputs(added.error()));
  }

  /// So that an error of an output is not taken for one of the input that was being read.
  static Error at_outputs(Error error) {
    if (error.file.empty()) error.file = "output";
    return error;
  }

  /// Of a folder of axes of both kinds each takes the unit that it can; of one axis a unit that it has not is a
  /// mistake.
  void tell_of_unit(AxisKind kind) const {
    if (report::is_unit_of(kind, arguments_.report.unit)) return;
    tell(fmt::format("--unit: found the unit of another kind of axis, the figures of a {} axis are in {}",
                     axis_kind_name(kind), deviation_unit(kind)));
  }

  int finish() {
    if (single_) {
      tell_of_unit(single_->test.metadata.axis.kind);
      if (stdout_is_free_) fmt::print("{}", summary(*single_, arguments_.report, terminal_, arguments_.detail));
      auto written = app::write_outputs(*single_, arguments_.outputs, arguments_.report);
      if (!written) return gave_up(written.error(), exit_bad_input);
    }
    const bool whole = exit_code_ == exit_done || arguments_.keep_going;
    if (outputs_ && whole) {
      auto committed = outputs_->commit();
      if (!committed) return gave_up(committed.error(), exit_bad_input);
    }
    if (outputs_ && !whole && !(arguments_.outputs.json.empty() && arguments_.outputs.reports.empty()))
      tell("the combined outputs were not written; --keep-going writes them with the errors named");
    if (exit_code_ == exit_done && count_ == 0 && !single_)
      return gave_up({"found no measured test, expected at least one", "", {}}, exit_bad_input);
    return exit_code_ != exit_done ? exit_code_ : exceeded_ ? exit_exceeded : undecided_ ? exit_undecided : exit_done;
  }

  EvaluateArguments& arguments_;
  Terminal terminal_;
  ProgressBar bar_;
  app::ManyThreads threads_;
  bool stdout_is_free_ = true;
  bool many_ = false;
  bool exceeded_ = false;
  bool undecided_ = false;
  int output_failed_ = 0;  // the exit code it asks for
  int exit_code_ = exit_done;
  std::size_t count_ = 0;
  std::optional<app::Evaluated> single_;
  std::optional<app::ManyOutputs> outputs_;
};

}  // namespace

int run_evaluation(EvaluateArguments& arguments) {
  if (!arguments.evaluate.uncertainty.monte_carlo) return Run(arguments)();
  const InterruptGuard guard;
  return Run(arguments)();
}

}  // namespace axiometry::cli
