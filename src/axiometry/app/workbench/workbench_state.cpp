// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/workbench_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/workbench/from_archive/axis_limits.h"
#include "axiometry/app/workbench/from_archive/kept_temperatures.h"
#include "axiometry/app/workbench/test_state.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/time/iso_date.h"
#include "axiometry/base/version.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/formats/temperatures/temperature_log.h"
#include "axiometry/model/fields.h"

namespace axiometry::app {
namespace {

/// Far below the last digit that anybody shows, far above what another library of mathematics changes.
bool same_number(double a, double b) { return std::abs(a - b) <= 1e-6 * std::max(std::abs(a), std::abs(b)) + 1e-9; }

bool same_figure(const store::FigureRecord& a, const store::FigureRecord& b) {
  if (a.parameter != b.parameter || !same_number(a.value, b.value) || a.U.has_value() != b.U.has_value()) return false;
  return !a.U || same_number(*a.U, *b.U);
}

std::string figure_text(const store::FigureRecord& figure) {
  std::string text = fmt::format("{} = {}", figure.parameter, format_fixed(figure.value, 4));
  if (figure.U) text += fmt::format(", U = {}", format_fixed(*figure.U, 4));
  return text;
}

/// So that no report says other numbers than the archive.
Result<void> check_same(const store::TestRecord& record, const Evaluated& evaluated) {
  const auto& kept = record.state.evaluation.figures;
  const auto now = figures_of(evaluated);
  for (std::size_t k = 0; k < std::max(kept.size(), now.size()); ++k) {
    if (k < kept.size() && k < now.size() && same_figure(kept[k], now[k])) continue;
    return fail(
        ErrorKind::conflict,
        fmt::format("found {} where version {} keeps {}, computed by {}; expected the same from this program, "
                    "axiometry {}: save a new version to evaluate the test with it",
                    k < now.size() ? figure_text(now[k]) : "nothing", record.version,
                    k < kept.size() ? figure_text(kept[k]) : "nothing", record.state.evaluation.program, version));
  }
  return {};
}

Result<void> check_length(const Field& field, std::string_view text) {
  if (text.size() <= 4 * text_length_max) return {};  // bytes of so many characters
  return fail(
      fmt::format("{}: found a text of {} bytes, expected at most {}", field.key, text.size(), 4 * text_length_max));
}

/// Reports of longer texts would be books.
Result<void> check_lengths(const Metadata& metadata) {
  for (const Field& field : metadata_fields()) {
    const FieldValue value = field.get(metadata);
    if (const auto* text = std::get_if<std::string>(&value)) AXIOMETRY_TRY_VOID(check_length(field, *text));
    const auto* records = std::get_if<Records>(&value);
    if (records == nullptr) continue;
    for (const auto& record : *records)
      for (const Cell& cell : record)
        if (const auto* text = std::get_if<std::string>(&cell)) AXIOMETRY_TRY_VOID(check_length(field, *text));
  }
  return {};
}

constexpr std::size_t trial_targets_max = 500;
constexpr double trial_work_max = 2e10;
constexpr double adaptive_trials = 1e5;

/// A trial of m targets and N readings takes a time that grows with m² + N, its preparation one with m³ and memory with
/// m²: without bounds a file of two megabytes would take the memory of the whole machine.
Result<void> check_trials(const Series& series, const TestOptions& options) {
  if (!options.monte_carlo) return {};
  const std::size_t targets = series.target_count();
  if (targets > trial_targets_max)
    return fail(
        fmt::format("found a test of {} targets, expected at most {} for Monte Carlo in the workbench: "
                    "'axiometry uncertainty FILE' takes more",
                    targets, trial_targets_max));
  const double each = static_cast<double>(targets * targets + series.reading_count());
  const double most = std::floor(trial_work_max / each);
  const double trials = options.trials ? static_cast<double>(*options.trials) : adaptive_trials;
  if (trials <= most) return {};
  return fail(
      fmt::format("found {:.0f} trials of {} targets and {} readings, expected at most {:.0f} for Monte Carlo in "
                  "the workbench: 'axiometry uncertainty FILE' takes more",
                  trials, targets, series.reading_count(), most));
}

constexpr std::size_t least_weight = 16'384;  // of a file that is remembered: what is around its tests

std::string version_key(const store::TestRecord& record) { return fmt::format("{}/{}", record.id, record.version); }

/// Of 64: as much as a version without a log, and more with a long one.
std::size_t weight_of(const Evaluated& evaluated) {
  constexpr std::size_t readings_of_one = 100'000;
  std::size_t readings = 0;
  if (evaluated.temperatures)
    for (const TemperatureCourse& course : evaluated.temperatures->log.sensors) readings += course.celsius.size();
  return 1 + readings / readings_of_one;
}

/// The same bytes hold other tests by another profile.
std::string file_key(const std::string& hash, const std::optional<formats::ImportProfile>& profile) {
  return profile ? hash + sha256(formats::write_profile(*profile)) : hash;
}

}  // namespace

Result<std::shared_ptr<const MeasuredFile>> Workbench::State::read(
    const HashedBytes& sent, const std::string& name, const std::optional<formats::ImportProfile>& profile) {
  AXIOMETRY_TRY(const std::string file_name, given_file_name(name));
  const std::string key = file_key(sent.sha256, profile);
  if (auto known = files.find(key)) return known;
  AXIOMETRY_TRY(MeasuredFile file, read_measured(sent, file_name, profile));
  auto shared = std::make_shared<const MeasuredFile>(std::move(file));
  files.remember(key, shared, shared->size + shared->memory + least_weight);
  return shared;
}

Result<std::shared_ptr<const std::string>> Workbench::State::log_bytes(const std::string& hash) {
  if (auto known = logs.find(hash)) return known;
  const auto size = store.content_size(hash);
  if (!size && size.error().kind == ErrorKind::not_found)
    return fail(ErrorKind::not_found,
                fmt::format("found no file {} in the archive, expected the temperature log among the documents of the "
                            "test: attach it first",
                            hash));
  if (!size) return std::unexpected(size.error());
  // Any content may be named here, a recording of hundreds of megabytes too.
  AXIOMETRY_TRY_VOID(formats::check_log_size(static_cast<std::size_t>(*size)));
  AXIOMETRY_TRY(store::Content content, store.content(hash));
  auto shared = std::make_shared<const std::string>(std::move(content.bytes));
  logs.remember(hash, shared, shared->size() + least_weight);
  return shared;
}

Result<std::shared_ptr<const MeasuredFile>> Workbench::State::file_of(const store::TestRecord& record) {
  AXIOMETRY_TRY(const KeptOptions kept, kept_options(record.state.evaluation));
  if (auto known = files.find(file_key(record.sha256, kept.profile))) return known;
  AXIOMETRY_TRY(const store::Content content, store.content(record.sha256));
  return read({content.bytes, record.sha256}, record.file_name, kept.profile);
}

Result<Test> Workbench::State::measured(const store::TestRecord& record) {
  AXIOMETRY_TRY(const auto file, file_of(record));
  const Test* found = file->find(record.name_in_file);
  if (found == nullptr)
    return fail(ErrorKind::damaged, fmt::format("found no test \"{}\" in the file {} that was kept, expected it as on "
                                                "the day it was received",
                                                record.name_in_file, record.file_name));
  Test test = *found;
  test.provenance.file = record.file_name;
  return test;
}

Answers Workbench::State::answers() const {
  return [this](const ArchiveQuestion& question) {
    return store.read([&](const store::Transaction& archive) { return find_in_archive(archive, question); });
  };
}

Result<Found> Workbench::State::evaluate(Test test, const Draft& draft, const std::optional<ArchiveLinks>& links,
                                         const Answers& answers, const std::stop_token& stop) {
  AXIOMETRY_TRY_VOID(check_trials(test.series, draft.options));
  ArchiveQuestion question{test.metadata, draft.changes, links};
  AXIOMETRY_TRY_VOID(set_metadata(question.metadata, metadata_items(draft.changes)));
  AXIOMETRY_TRY_VOID(check_lengths(question.metadata));
  AXIOMETRY_TRY(FromArchive taken, answers(question));
  AXIOMETRY_TRY(Found found, evaluate_with(std::move(test), draft, std::move(taken), stop));
  found.asked = std::move(question);
  return found;
}

Result<Found> Workbench::State::evaluate_with(Test test, const Draft& draft, FromArchive taken,
                                              const std::stop_token& stop) {
  AXIOMETRY_TRY(EvaluateOptions options, evaluate_options(draft.options));
  options = with_archive(std::move(options), draft.changes, taken);
  if (const auto& log = draft.options.temperatures) {
    AXIOMETRY_TRY(const auto bytes, log_bytes(log->sha256));
    options.temperatures = log_with_test(*log, *bytes);
  }
  std::unique_lock<std::mutex> alone(monte_carlo, std::defer_lock);
  if (draft.options.monte_carlo) alone.lock();
  AXIOMETRY_TRY_VOID(go_on_unless(stop));
  options.uncertainty.trials.propagation.on_progress = [stop](const uncertainty::Progress&) {
    return !stop.stop_requested();
  };
  const auto begin = std::chrono::steady_clock::now();
  auto evaluated_test = evaluate_test(std::move(test), options);
  AXIOMETRY_TRY_VOID(go_on_unless(stop));
  AXIOMETRY_TRY(Evaluated evaluated, std::move(evaluated_test));
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
  return Found{std::move(evaluated), {}, std::move(taken), time.count()};
}

std::shared_ptr<const Evaluated> Workbench::State::remembered(const store::TestRecord& record) {
  return evaluations.find(version_key(record));
}

Result<std::shared_ptr<const Evaluated>> Workbench::State::evaluated(const store::TestRecord& record,
                                                                     const std::stop_token& stop) {
  if (auto known = remembered(record)) return known;
  AXIOMETRY_TRY(KeptOptions kept, kept_options(record.state.evaluation));
  AXIOMETRY_TRY(Changes changes, kept_changes(record.state));
  AXIOMETRY_TRY(Test test, measured(record));
  if (auto& axis = kept.from_archive.axis; axis && axis->set_on.empty()) {
    AXIOMETRY_TRY(const auto then, store.get<store::AxisRecord>(axis->axis, axis->version));
    axis->set_on = iso_date(then.change.at);
  }
  AXIOMETRY_TRY(Found found,
                evaluate_with(std::move(test), {std::move(changes), kept.options}, kept.from_archive, stop));
  found.evaluated.name = record.name_in_file;
  AXIOMETRY_TRY_VOID(check_same(record, found.evaluated));
  auto shared = std::make_shared<const Evaluated>(std::move(found.evaluated));
  evaluations.remember(version_key(record), shared, weight_of(*shared));
  return shared;
}

Result<std::optional<iso230_2::Finding>> Workbench::State::changed_limits_of(const store::TestRecord& record) {
  AXIOMETRY_TRY(const KeptOptions kept, kept_options(record.state.evaluation));
  if (!kept.from_archive.axis) return std::nullopt;
  AXIOMETRY_TRY(auto now, store.get<store::AxisRecord>(kept.from_archive.axis->axis));
  return changed_limits(kept.from_archive, std::move(now.value));
}

ArchiveLinks links_of(const store::TestRecord& record) { return {record.machine, record.axis, record.instruments}; }

Outcome outcome_of(Found found) {
  return {.result = to_json(found.evaluated),
          .readings = std::move(found.evaluated.test.series),
          .as_measured = std::move(found.evaluated.test.as_measured),
          .from_archive = std::move(found.from_archive),
          .milliseconds = found.milliseconds};
}

Result<json::Value> kept_result(const store::TestRecord& record) {
  auto result = json::parse(record.state.evaluation.result);
  if (!result)
    return fail(ErrorKind::damaged,
                fmt::format("found a result of test {} that cannot be read: {}", record.id, result.error().message));
  return result;
}

}  // namespace axiometry::app
