// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/evaluate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "axiometry/app/evaluate/drift_recording.h"
#include "axiometry/app/evaluate/evaluate_many.h"
#include "axiometry/app/evaluate/known_file.h"
#include "axiometry/app/evaluate/recognised.h"
#include "axiometry/app/evaluate/stated_surroundings.h"
#include "axiometry/app/evaluate/test_and_log.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/recordings/read_recording.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/motions/motion_csv.h"
#include "axiometry/formats/passed_over.h"
#include "axiometry/formats/table/generic_delimited.h"
#include "axiometry/formats/temperatures/temperature_log.h"
#include "axiometry/model/fields.h"
#include "axiometry/standards/iso230_2/inputs/resolved_keys.h"
#include "axiometry/standards/iso230_2/rules/environment_findings.h"
#include "axiometry/standards/iso230_2/rules/uncertainty_findings.h"
#include "axiometry/standards/iso230_2/severity_order.h"
#include "axiometry/standards/readings/artefact.h"
#include "axiometry/standards/readings/test_course.h"

namespace axiometry::app {
namespace {

constexpr std::size_t single_test_limit = std::size_t{2} << 30;  // logs of controls have gigabytes

/// `forced`: its id; empty where it is to be recognised, or `known` already.
Result<const formats::Format*> format_of_id(std::string_view head, const std::string& forced,
                                            std::optional<Recognised> known = {}) {
  if (forced.empty()) {
    Recognised found = known ? *std::move(known) : recognised(head);
    if (found.recording == nullptr) return std::move(found.format);
    if (formats::sensors_of_log(head))
      return fail(
          fmt::format("found a log of temperatures, or another recording ({}), expected a measured test; a log is "
                      "given beside a test, a recording of positions with its plan",
                      found.recording->title));
    return fail(fmt::format("found a continuous recording ({}), expected the plan the axis moved after with it",
                            found.recording->title));
  }
  AXIOMETRY_TRY_VOID(formats::check_no_other_error(head));
  const formats::Format* format = formats::find_format(forced);
  if (format == nullptr)
    return fail(fmt::format("found the unknown format \"{}\", expected one that 'axiometry formats' lists", forced));
  if (head.empty()) return fail("found an empty file, expected a measured test");
  return format;
}

/// What the user says about the format of a file.
struct Forced {
  const std::string& format;
  const std::string& profile;
};

Result<const formats::Format*> format_of(Source& source, const Forced& forced, std::optional<Recognised> known = {}) {
  AXIOMETRY_TRY(const std::string_view head, source.head());
  const bool by_profile = !forced.profile.empty();
  if (by_profile && !forced.format.empty() && forced.format != formats::any_table_format)
    return fail(fmt::format("found the format \"{}\" beside an import profile, expected \"{}\" or none", forced.format,
                            formats::any_table_format));
  return format_of_id(head, by_profile ? std::string(formats::any_table_format) : forced.format, std::move(known));
}

bool holds_many(const formats::Format& format, std::string_view head) {
  return format.holds_many != nullptr && format.holds_many(head);
}

/// Reads after an import profile and says so.
Result<Test> read_by_profile(std::string_view bytes, const std::string& name) {
  AXIOMETRY_TRY(const std::string text, in_file(file_bytes(name), name));
  AXIOMETRY_TRY(const formats::ImportProfile profile, in_file(formats::read_profile(text), name));
  AXIOMETRY_TRY(Test test, formats::read_with(profile, bytes));
  auto& remarks = test.provenance.remarks;
  remarks.insert(remarks.begin(), {false, fmt::format("columns were read after the import profile {}, SHA-256 {}",
                                                      text::quoted(base_name(name)), sha256(text))});
  return test;
}

/// `hash`: of the bytes, where it is known.
Result<Test> read_single(Source& source, const formats::Format& format, const std::string& profile,
                         const std::string& hash = {}) {
  AXIOMETRY_TRY(const std::string bytes, source.read_all(single_test_limit));
  AXIOMETRY_TRY(Test test, profile.empty() ? format.read(bytes) : read_by_profile(bytes, profile));
  test.provenance.file = source.name();
  test.provenance.sha256 = hash.empty() ? sha256(bytes) : hash;
  test.provenance.format = format.id;
  return test;
}

/// The hash of a file of which nothing was read; empty of what cannot be read twice.
Result<std::string> hash_of(Source& source) {
  AXIOMETRY_TRY(auto digest, source.sha256_ahead());
  return std::move(digest).value_or("");
}

/// Hands over the tests of a file of many as they come; errors of a test get the line where it began.
Result<void> read_many(Source& source, const formats::Format& format, const std::string& hash,
                       const std::function<Result<void>(Test&&, std::string, std::size_t line)>& hand_over) {
  const Provenance provenance{source.name(), hash, std::string(format.id)};
  return format.read_many(source, [&](formats::NamedTest&& named) -> Result<void> {
    Test test{std::move(named.metadata), std::move(named.series), provenance};
    test.provenance.remarks = std::move(named.remarks);
    auto result = hand_over(std::move(test), std::move(named.name), named.line);
    if (!result && result.error().at.line == 0 && result.error().file.empty()) result.error().at.line = named.line;
    return result;
  });
}

/// Tests that are stated in full are evaluated side by side; of a table reading takes most of the time.
Result<void> evaluate_many(Source& source, const formats::Format& format, const EvaluateOptions& options,
                           const ManyThreads& threads, const EvaluatedTextSink& sink) {
  using iso230_2::Depth;
  const bool in_full = options.many_in_full;
  EvaluateOptions for_many = options;
  if (!in_full) for_many.uncertainty.trials.contribution_trials = 0;  // a table has no room for them
  for_many.tolerance.many_tests = true;
  std::string hash;
  if (in_full) {
    AXIOMETRY_TRY(hash, hash_of(source));
  }
  ManyThreads used = threads;
  if (!in_full || options.uncertainty.monte_carlo) used.count = 1;
  if (used.count != 1) {  // a test may state Monte Carlo for its method of record
    for_many.uncertainty.trials.propagation.threads = 1;
    for_many.uncertainty.trials.propagation.on_progress = {};
  }
  TestsSideBySide tests(
      [&](Test&& test) {
        return evaluate_test(std::move(test), for_many, in_full ? Depth::every_finding : Depth::departures_only);
      },
      used, sink);
  const auto read = read_many(source, format, hash, [&](Test&& test, std::string name, std::size_t line) {
    return tests.add(std::move(test), std::move(name), line);
  });
  AXIOMETRY_TRY_VOID(tests.finish());  // those before what could not be read come first
  return read;
}

Result<void> evaluate_source(Source& source, const EvaluateOptions& options, const ManyThreads& threads,
                             const EvaluatedTextSink& sink, std::optional<Recognised> known = {}) {
  if (options.recording) {
    AXIOMETRY_TRY(Test test, read_recording(source, *options.recording));
    AXIOMETRY_TRY(Evaluated evaluated, evaluate_test(std::move(test), options));
    return sink(std::move(evaluated), {});
  }
  AXIOMETRY_TRY(const formats::Format* format, format_of(source, {options.format, options.profile}, std::move(known)));
  AXIOMETRY_TRY(const std::string_view head, source.head());
  if (holds_many(*format, head)) {
    if (options.temperatures) return fail("found a file of many tests, expected one test beside a log of temperatures");
    return evaluate_many(source, *format, options, threads, sink);
  }
  AXIOMETRY_TRY(Test test, read_single(source, *format, options.profile));
  AXIOMETRY_TRY(Evaluated evaluated, evaluate_test(std::move(test), options));
  return sink(std::move(evaluated), {});
}

Result<Test> read_source(Source& source, const Forced& forced) {
  AXIOMETRY_TRY(const formats::Format* format, format_of(source, forced));
  AXIOMETRY_TRY(const std::string_view head, source.head());
  if (holds_many(*format, head)) return fail("found a file of many tests, expected one test");
  return read_single(source, *format, forced.profile);
}

/// What was asked for, and the method of record whether asked for or not.
Result<void> add_uncertainty(iso230_2::Assessment& assessment, const Test& test, const UncertaintyOptions& wanted) {
  const iso230_2::Evaluation& evaluation = assessment.evaluation;
  if (wanted.gum || assessment.method_of_record == UncertaintyMethod::gum) {
    AXIOMETRY_TRY(assessment.gum, iso230_2::gum(test, evaluation));
  }
  if (wanted.monte_carlo || assessment.method_of_record == UncertaintyMethod::monte_carlo) {
    AXIOMETRY_TRY(assessment.monte_carlo, iso230_2::monte_carlo(test, evaluation, wanted.trials));
  }
  return {};
}

/// What the log of the temperatures tells of the test, among its findings.
Result<std::optional<EvaluatedTemperatures>> add_temperatures(iso230_2::Assessment& assessment, const Test& test,
                                                              const EvaluateOptions& options, iso230_2::Depth depth) {
  if (!options.temperatures) return std::nullopt;
  const Metadata& metadata = test.metadata;
  AXIOMETRY_TRY(EvaluatedTemperatures found,
                evaluate_log_with_test(*options.temperatures, course_of(test).duration, metadata.agreed));
  std::vector<iso230_2::Finding>& findings = assessment.findings;
  std::ranges::move(contradicted_by_log(metadata.surroundings, found.environment), std::back_inserter(findings));
  found.environment = iso230_2::with_statement(std::move(found.environment), metadata);
  std::ranges::move(iso230_2::environment_findings(found.environment, depth), std::back_inserter(findings));
  auto day = other_day(test, found);
  const bool of_other_day = day && day->severity != iso230_2::Severity::note;
  assessment.temperatures_recorded = found.environment.ends_recorded && !of_other_day;
  if (of_other_day || (day && depth == iso230_2::Depth::every_finding)) findings.push_back(*std::move(day));
  if (!of_other_day) std::ranges::move(contradicted_temperatures(test, found), std::back_inserter(findings));
  if (depth == iso230_2::Depth::every_finding)
    for (const std::string& remark : found.log.remarks)
      findings.push_back({"temperature-log-remark", iso230_2::source_clause, iso230_2::Severity::note,
                          fmt::format("of the temperature log: {}", remark)});
  return found;
}

/// What is stated of the surroundings, among the findings of a test; where there is a log, it is among what that tells.
Result<std::optional<iso230_2::TestEnvironment>> add_statement(iso230_2::Assessment& assessment, const Metadata& stated,
                                                               bool with_log, iso230_2::Depth depth) {
  if (!states_surroundings(stated)) return std::nullopt;
  AXIOMETRY_TRY_VOID(check_surroundings(stated));
  std::vector<iso230_2::Finding>& findings = assessment.findings;
  std::ranges::move(contradicted_by_test(stated), std::back_inserter(findings));
  if (with_log) return std::nullopt;
  auto environment = iso230_2::stated_environment(stated);
  std::ranges::move(iso230_2::environment_findings(environment, depth), std::back_inserter(findings));
  return environment;
}

/// Whose the items are that the file does not state: of a list the records since it was last emptied.
StatedItems stated_items(const EvaluateOptions& options) {
  StatedItems all;
  for (const auto& [key, text] : options.metadata) {
    auto item = std::ranges::find(all.items, key, &StatedItem::key);
    if (item == all.items.end()) item = all.items.insert(item, {key, StatedBy::flag, {}, 0});
    if (const StatedItem* known = options.stated.find(key)) {
      item->by = known->by;
      item->name = known->name;
    }
    item->records = text.empty() ? 0 : item->records + 1;
  }
  return all;
}

}  // namespace

bool states_calibration(const Equipment& component) {
  return !component.certificate.empty() || !component.calibrated_on.empty() || !component.calibration_due.empty();
}

namespace {

/// prepare_test() of a test where it stands: it is large, and of most tests nothing is changed.
Result<void> prepare(Test& test, const EvaluateOptions& options) {
  AXIOMETRY_TRY_VOID(set_metadata(test.metadata, options.metadata));
  test.provenance.stated = stated_items(options);
  for (const std::string& remark : options.remarks) test.provenance.remarks.push_back({false, remark});
  if (!options.drift_recording.empty()) {
    AXIOMETRY_TRY(DriftRecording recording, read_drift_recording(options.drift_recording, test.metadata.axis.kind));
    test.provenance.remarks.push_back(
        {false,
         fmt::format("Recording at standstill: {} (SHA-256 {}), {} values {:.4g} s apart", options.drift_recording,
                     recording.sha256, recording.values.size(), recording.interval.in_s())});
    test.metadata.gum.drift_recording = std::move(recording.values);
    test.metadata.gum.drift_interval = recording.interval;
    std::erase_if(test.provenance.stated.items,
                  [](const StatedItem& item) { return item.key == iso230_2::recording_key; });
    test.provenance.stated.items.push_back({std::string(iso230_2::recording_key), StatedBy::flag});
  }
  if (!test.metadata.gum.drift_recording.empty()) test = with_recorded_variation(std::move(test));
  for (const EquipmentCalibration& known : options.calibrations) {
    if (known.component >= test.metadata.equipment.size()) continue;
    Equipment& component = test.metadata.equipment[known.component];
    if (states_calibration(component)) continue;
    component.certificate = known.certificate;
    component.calibrated_on = known.calibrated_on;
    component.calibration_due = known.calibration_due;
  }
  if (options.artefact.value_or(!test.metadata.artefact.calibrated_positions.empty())) {
    AXIOMETRY_TRY(test, iso230_2::apply_artefact(std::move(test)));
  }
  if (options.corrections.any()) {
    AXIOMETRY_TRY(test, correct_readings(std::move(test), options.corrections));
  }
  return {};
}

}  // namespace

Result<Test> prepare_test(Test test, const EvaluateOptions& options) {
  AXIOMETRY_TRY_VOID(prepare(test, options));
  return test;
}

Result<Evaluated> evaluate_test(Test measured, const EvaluateOptions& options, iso230_2::Depth depth) {
  Result<Evaluated> result(std::in_place, std::move(measured));
  Test& test = result->test;
  Metadata of_file;
  of_file.axis.kind = test.metadata.axis.kind;
  of_file.tolerance = test.metadata.tolerance;
  AXIOMETRY_TRY_VOID(prepare(test, options));
  iso230_2::Assessment& assessment = result->assessment = iso230_2::assess(test, depth);
  AXIOMETRY_TRY(result->stated_environment,
                add_statement(assessment, test.metadata, options.temperatures.has_value(), depth));
  AXIOMETRY_TRY(result->temperatures, add_temperatures(assessment, test, options, depth));
  const iso230_2::AxisParameters& parameters = assessment.evaluation.parameters;
  AXIOMETRY_TRY(Requirements demanded,
                requirements_for(test, parameters, options.tolerance, options.metadata, &of_file));
  AXIOMETRY_TRY_VOID(add_uncertainty(assessment, test, options.uncertainty));
  if (depth == iso230_2::Depth::every_finding)
    std::ranges::move(iso230_2::uncertainty_findings(test, assessment), std::back_inserter(assessment.findings));
  if (!demanded.tolerances.empty())
    result->judgements = iso230_2::judge(
        parameters, demanded.tolerances, demanded.rule,
        {iso230_2::uncertainties_of_record(assessment), iso230_2::comparison_slack(test.series), assessment.uncorrected,
         iso230_2::refusals_of_record(assessment), iso230_2::lower_bounds(assessment.evaluation)});
  std::ranges::move(demanded.findings, std::back_inserter(assessment.findings));
  iso230_2::sort_by_severity(assessment.findings);
  result->tolerance_band = std::move(demanded.band);
  return result;
}

Result<void> set_metadata(Metadata& metadata, std::span<const std::pair<std::string, std::string>> items) {
  const AxisKind kind = metadata.axis.kind;
  for (const auto& [key, text] : items) AXIOMETRY_TRY_VOID(set_field_text(metadata, key, text));
  if (metadata.axis.kind != kind)
    return fail(fmt::format("found axis.kind given as {} for readings in {}, expected the kind the units say",
                            axis_kind_name(metadata.axis.kind), deviation_unit(kind)));
  return {};
}

Result<Test> read_test(const std::string& file, const std::string& format, const std::string& profile) {
  AXIOMETRY_TRY(Source source, in_file(Source::open(file), file));
  return in_file(read_source(source, {format, profile}), file);
}

Result<Test> read_test(const GivenFile& file) {
  Source source = Source::of_bytes(file.name, file.bytes);
  return in_file(read_source(source, {"", ""}), file.name);
}

Result<void> read_tests(Source& source, const TestSink& sink) {
  AXIOMETRY_TRY(const formats::Format* format, format_of(source, {"", ""}));
  AXIOMETRY_TRY(const std::string_view head, source.head());
  std::string hash;  // of one test while it is read
  if (holds_many(*format, head)) {
    AXIOMETRY_TRY(hash, hash_of(source));
  }
  return read_known(source, {*format, std::move(hash)}, sink);
}

Result<void> read_known(Source& source, const KnownFormat& known, const TestSink& sink) {
  AXIOMETRY_TRY(const std::string_view head, source.head());
  if (holds_many(known.format, head))
    return read_many(source, known.format, known.sha256,
                     [&](Test&& test, std::string name, std::size_t) -> Result<void> {
                       return sink(std::move(test), std::move(name));
                     });
  AXIOMETRY_TRY(Test test, read_single(source, known.format, "", known.sha256));
  return sink(std::move(test), {});
}

Result<void> evaluate_file(const std::string& file, const EvaluateOptions& options, const EvaluatedSink& sink) {
  return evaluate_file(file, options, {.count = 1, .make_text = {}},
                       [&](Evaluated&& evaluated, std::string&&) { return sink(std::move(evaluated)); });
}

Result<void> evaluate_file(const std::string& file, const EvaluateOptions& options, const ManyThreads& threads,
                           const EvaluatedTextSink& sink) {
  AXIOMETRY_TRY_VOID(evaluate_input({file, false}, options, threads, sink));
  return {};
}

Result<bool> evaluate_input(const InputFile& input, const EvaluateOptions& options, const ManyThreads& threads,
                            const EvaluatedTextSink& sink) {
  const auto work = [&]() -> Result<bool> {
    AXIOMETRY_TRY(Source source, Source::open(input.name));
    std::optional<Recognised> known;
    if (input.from_folder && options.profile.empty()) {
      AXIOMETRY_TRY(const std::string_view head, source.head());
      known = recognised(head);
      if (!known->format) {
        if (known->recording == nullptr) AXIOMETRY_TRY_VOID(formats::check_passed_over(head));
        return false;
      }
    }
    AXIOMETRY_TRY_VOID(evaluate_source(source, options, threads, sink, std::move(known)));
    return true;
  };
  return in_file(work(), input.name);
}

}  // namespace axiometry::app
