// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/workbench.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <type_traits>
#include <utility>

#include "axiometry/app/evaluate/recognised.h"
#include "axiometry/app/files/given_text.h"
#include "axiometry/app/workbench/from_archive/axis_limits.h"
#include "axiometry/app/workbench/from_archive/machine_remarks.h"
#include "axiometry/app/workbench/same_answer.h"
#include "axiometry/app/workbench/test_of_file.h"
#include "axiometry/app/workbench/test_state.h"
#include "axiometry/app/workbench/workbench_state.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/formats/motions/motion_csv.h"
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/formats/temperatures/temperature_log.h"
#include "axiometry/formats/text/json_members.h"

namespace axiometry::app {
namespace {

using State = Workbench::State;

constexpr std::size_t evaluated_in_preview = 8;
constexpr std::int64_t same_content_max = 100;
constexpr int attempts_beside_others = 3;

/// The first evaluation of a test and how it was made.
struct First {
  Found found;
  Draft draft;
};

/// With all that costs nothing. Inputs from which the GUM cannot be worked out are no reason to refuse a measurement:
/// then Annex A has to do, and who asks for the GUM hears why not.
Result<First> evaluate_first(State& state, const MeasuredTest& measured, const std::string& file_name,
                             const Answers& answers, const std::stop_token& stop) {
  AXIOMETRY_TRY_VOID(go_on_unless(stop));
  Draft draft;
  Test test = measured.test;
  test.provenance.file = file_name;
  auto found = state.evaluate(test, draft, {}, answers);
  if (!found) {
    draft.options.gum = false;
    found = state.evaluate(std::move(test), draft, {}, answers);
  }
  if (!found) {
    Error error = found.error();
    error.file = file_name;
    if (!measured.name.empty()) error.message = fmt::format("test {}: {}", measured.name, error.message);
    return std::unexpected(std::move(error));
  }
  found->evaluated.name = measured.name;
  return First{*std::move(found), std::move(draft)};
}

Result<std::vector<store::Id>> ids_with(const store::Transaction& archive, const std::string& sha256) {
  store::TestFilter filter;
  filter.sha256 = sha256;
  filter.withdrawn = true;
  filter.limit = same_content_max;
  AXIOMETRY_TRY(const store::TestPage page, archive.tests(filter));
  std::vector<store::Id> ids;
  for (const store::TestRow& row : page.rows) ids.push_back(row.id);
  std::ranges::sort(ids);
  return ids;
}

/// What an evaluation took from the archive. What it found is kept only while that has not changed.
struct Taken {
  ArchiveQuestion asked;
  FromArchive answer;
};

Result<bool> is_as_it_was(const store::Transaction& archive, const std::vector<Taken>& all) {
  for (const Taken& taken : all) {
    AXIOMETRY_TRY(const FromArchive now, find_in_archive(archive, taken.asked));
    if (!same(now, taken.answer)) return false;
  }
  return true;
}

/// A file that was read and evaluated, ready to be kept.
struct Incoming {
  store::Content content;
  std::vector<store::NewTest> tests;
  std::vector<std::string> perhaps_kept_as;
};

/// All files that come together.
struct Evaluation {
  std::vector<Incoming> files;
  std::vector<Taken> taken;
  std::optional<Outcome> first;  ///< outcome of the first test
};

Result<Evaluation> evaluate_all(State& state, std::span<const Upload> uploads, const Answers& answers,
                                const std::stop_token& stop = {}) {
  Evaluation all;
  for (const Upload& upload : uploads) {
    AXIOMETRY_TRY(const auto file, state.read(HashedBytes::of(upload.bytes), upload.name, upload.profile));
    AXIOMETRY_TRY(const std::string name, given_file_name(upload.name));
    Incoming& incoming = all.files.emplace_back();
    incoming.content = {file->sha256, name, file->format, std::string(upload.bytes)};
    incoming.perhaps_kept_as = upload.perhaps_kept_as;
    for (const MeasuredTest& measured : file->tests) {
      AXIOMETRY_TRY(First evaluated, evaluate_first(state, measured, name, answers, stop));
      Found& found = evaluated.found;
      store::NewTest test{.name_in_file = measured.name,
                          .state = state_of(found.evaluated, evaluated.draft.changes,
                                            {evaluated.draft.options, found.from_archive, upload.profile})};
      test.state.title = first_title(found.evaluated);
      test.state.plan = upload.plan;
      incoming.tests.push_back(std::move(test));
      all.taken.push_back({std::move(found.asked), found.from_archive});
      if (!all.first) all.first = outcome_of(std::move(found));
    }
  }
  return all;
}

Result<Received> keep_all(store::Transaction& archive, Evaluation all, const store::By& by) {
  Received received{.tests = {}, .same_content = {}, .first = *std::move(all.first)};
  std::set<store::Id> before, own;
  for (const Incoming& file : all.files) {
    AXIOMETRY_TRY(const auto there, test_of_file(archive, {file.content.file_name, file.perhaps_kept_as}));
    if (there) {
      received.tests.push_back({*there, file.tests.front().state.title, {}, {}});
      continue;
    }
    AXIOMETRY_TRY(const auto same, ids_with(archive, file.content.sha256));
    AXIOMETRY_TRY(const auto remarks, machine_remarks(archive, file.tests));
    AXIOMETRY_TRY(const auto ids, archive.receive(file.content, file.tests, by));
    for (std::size_t k = 0; k < ids.size(); ++k)
      received.tests.push_back({ids[k], file.tests[k].state.title, same, remarks[k]});
    before.insert(same.begin(), same.end());
    own.insert(ids.begin(), ids.end());
  }
  std::ranges::set_difference(before, own, std::back_inserter(received.same_content));
  return received;
}

/// What a revision makes of a test.
struct Revised {
  store::TestState state;
  std::vector<Taken> taken;
};

Answers answers_of(const store::Transaction& archive) {
  return [&archive](const ArchiveQuestion& question) { return find_in_archive(archive, question); };
}

/// Evaluates while others may write, and keeps what was found if the archive is still as it was then. If not, it
/// evaluates again; at last while nobody else may write, so that it comes to an end.
template <typename Evaluate, typename Keep>
auto keep_as_evaluated(State& state, Evaluate evaluate, Keep keep) {
  using Kept = std::remove_cvref_t<decltype(keep(std::declval<store::Transaction&>(), *evaluate(state.answers())))>;
  for (int attempt = 0; attempt < attempts_beside_others; ++attempt) {
    auto evaluated = evaluate(state.answers());
    if (!evaluated) return Kept(std::unexpect, std::move(evaluated).error());
    bool as_it_was = true;
    auto kept = state.store.write([&](store::Transaction& archive) -> Kept {
      AXIOMETRY_TRY(as_it_was, is_as_it_was(archive, evaluated->taken));
      if (!as_it_was) return fail(ErrorKind::conflict, "found the archive changed during the evaluation");
      return keep(archive, *std::move(evaluated));
    });
    if (as_it_was) return kept;
  }
  return state.store.write([&](store::Transaction& archive) -> Kept {
    AXIOMETRY_TRY(auto evaluated, evaluate(answers_of(archive)));
    return keep(archive, std::move(evaluated));
  });
}

/// All that the archive says of a version; of its machine, axis and instruments as they are now.
struct LookedUp {
  store::TestRecord record;
  std::vector<store::Change> versions;
  std::vector<store::DocumentRecord> documents;
  std::optional<store::MachineRecord> machine;
  std::optional<store::AxisRecord> axis;
  std::vector<store::Versioned<store::InstrumentRecord>> instruments;
};

Result<LookedUp> look_up(const store::Transaction& archive, store::Id id, std::optional<int> version) {
  LookedUp found;
  AXIOMETRY_TRY(found.record, archive.test(id, version));
  AXIOMETRY_TRY(found.versions, archive.test_versions(id));
  AXIOMETRY_TRY(found.documents, archive.documents(id));
  if (found.record.machine) {
    AXIOMETRY_TRY(auto machine, archive.get<store::MachineRecord>(*found.record.machine));
    found.machine = std::move(machine.value);
  }
  if (found.record.axis) {
    AXIOMETRY_TRY(auto axis, archive.get<store::AxisRecord>(*found.record.axis));
    found.axis = std::move(axis.value);
  }
  for (const store::Id one : found.record.instruments) {
    AXIOMETRY_TRY(auto instrument, archive.get<store::InstrumentRecord>(one));
    found.instruments.push_back(std::move(instrument));
  }
  return found;
}

/// The outcome that a version keeps: its own result, and the readings from the raw bytes with its corrections.
Result<Outcome> kept_outcome(State& state, const store::TestRecord& record, const Draft& draft, FromArchive taken) {
  AXIOMETRY_TRY(json::Value result, kept_result(record));
  AXIOMETRY_TRY(EvaluateOptions options, evaluate_options(draft.options));
  AXIOMETRY_TRY(Test test, state.measured(record));
  AXIOMETRY_TRY(test, prepare_test(std::move(test), with_archive(std::move(options), draft.changes, taken)));
  return Outcome{.result = std::move(result),
                 .readings = std::move(test.series),
                 .as_measured = std::move(test.as_measured),
                 .from_archive = std::move(taken),
                 .milliseconds = 0.0};
}

std::optional<OtherFile> other_file(std::string_view bytes, const Recognised& found) {
  // Columns over time are both; whose sensors tell by their names that they are of the air are no positions.
  if (found.recording != nullptr)
    return formats::read_temperature_log(bytes) ? OtherFile::temperatures : OtherFile::recording;
  if (!formats::check_no_other_error(bytes.substr(0, read_budget::head_bytes))) return OtherFile::error_motion;
  if (formats::stated_format(bytes) == formats::plan_format_name) return OtherFile::plan;
  return {};
}

/// `file`: nullptr where it is refused.
std::optional<AskedTable> asked_table(const Upload& upload, const MeasuredFile* file) {
  constexpr std::size_t columns_max = 200;  // more nobody goes through one by one
  auto found = file != nullptr && file->guess ? file->guess : guess_measured(upload.bytes);
  if (!found || found->profile.columns.size() > columns_max) return {};
  return AskedTable{upload.profile.value_or(std::move(found->profile)), std::move(found->questions),
                    std::move(found->names), std::move(found->preview)};
}

/// Of a change that is in the archive: who cannot be shown it must not take it for lost.
Result<KeptTest> kept_for_certain(Result<KeptTest> read) {
  if (!read) read.error().message = fmt::format("the change was kept, but cannot be shown: {}", read.error().message);
  return read;
}

}  // namespace

Workbench::Workbench(store::Store& store) : state_(std::make_unique<State>(store)) {}
Workbench::~Workbench() = default;

store::Store& Workbench::archive() const { return state_->store; }

Result<Preview> Workbench::preview(const Upload& upload, const std::stop_token& stop) const {
  Preview preview;
  AXIOMETRY_TRY(preview.file_name, given_file_name(upload.name));
  preview.size = upload.bytes.size();
  HashedBytes sent = HashedBytes::of(upload.bytes);
  sent.recognised = recognised(upload.bytes);
  preview.sha256 = sent.sha256;
  AXIOMETRY_TRY(preview.same_content, state_->store.read([&](const store::Transaction& archive) {
    return ids_with(archive, preview.sha256);
  }));
  const auto file = state_->read(sent, upload.name, upload.profile);
  if (!file || (*file)->format == formats::any_table_format)
    preview.table = asked_table(upload, file ? file->get() : nullptr);
  if (!file) {
    preview.refused = file.error();
    preview.instead = other_file(upload.bytes, *sent.recognised);
    if (const auto& format = sent.recognised->format) preview.format = (*format)->id;
    return preview;
  }
  preview.format = (*file)->format;
  for (const MeasuredTest& measured : (*file)->tests) {
    preview.tests.push_back({measured.name, measured.test.metadata, measured.test.series, {}});
    if (preview.tests.size() > evaluated_in_preview) continue;
    auto first = evaluate_first(*state_, measured, preview.file_name, state_->answers(), stop);
    if (!first) {
      preview.refused = first.error();
      preview.tests.clear();
      return preview;
    }
    preview.tests.back().outcome = outcome_of(std::move(first->found));
  }
  return preview;
}

Result<Received> Workbench::receive(std::span<const Upload> uploads, const store::By& by, const std::stop_token& stop) {
  if (uploads.empty()) return fail("found no file, expected at least one");
  return keep_as_evaluated(
      *state_, [&](const Answers& answers) { return evaluate_all(*state_, uploads, answers, stop); },
      [&](store::Transaction& archive, Evaluation all) -> Result<Received> {
        AXIOMETRY_TRY_VOID(go_on_unless(stop));
        return keep_all(archive, std::move(all), by);
      });
}

Result<Received> Workbench::receive(store::Transaction& archive, std::span<const Upload> uploads, const store::By& by) {
  if (uploads.empty()) return fail("found no file, expected at least one");
  AXIOMETRY_TRY(Evaluation all, evaluate_all(*state_, uploads, answers_of(archive)));
  return keep_all(archive, std::move(all), by);
}

Result<Outcome> Workbench::evaluate(const Upload& upload, const Draft& draft, const std::string& test_name,
                                    const std::stop_token& stop) const {
  AXIOMETRY_TRY(const auto file, state_->read(HashedBytes::of(upload.bytes), upload.name, upload.profile));
  AXIOMETRY_TRY(const std::string file_name, given_file_name(upload.name));
  const Test* test = test_name.empty() && file->tests.size() == 1 ? &file->tests.front().test : file->find(test_name);
  if (test == nullptr)
    return fail(fmt::format("found a file of {} tests, expected one test or the name of one of them: {}{}",
                            file->tests.size(), file->tests.front().name, file->tests.size() > 1 ? ", …" : ""));
  Test named = *test;
  named.provenance.file = file_name;
  AXIOMETRY_TRY(Found found, state_->evaluate(std::move(named), draft, {}, state_->answers(), stop));
  return outcome_of(std::move(found));
}

Result<Outcome> Workbench::evaluate(const Test& test, const Draft& draft) const {
  AXIOMETRY_TRY(Found found, state_->evaluate(test, draft, {}, state_->answers()));
  return outcome_of(std::move(found));
}

Result<Outcome> Workbench::draft(store::Id id, const Draft& draft, const std::stop_token& stop) const {
  AXIOMETRY_TRY(const store::TestRecord record, state_->store.test(id));
  AXIOMETRY_TRY(Test test, state_->measured(record));
  AXIOMETRY_TRY(Found found, state_->evaluate(std::move(test), draft, links_of(record), state_->answers(), stop));
  found.evaluated.name = record.name_in_file;
  return outcome_of(std::move(found));
}

Result<KeptTest> Workbench::revise(store::Id id, const Revision& revision, const store::By& by,
                                   const std::stop_token& stop) {
  AXIOMETRY_TRY(const store::TestRecord record, state_->store.test(id));
  AXIOMETRY_TRY(const std::string title, given_line("title", revision.title));
  AXIOMETRY_TRY(const Test test, state_->measured(record));
  AXIOMETRY_TRY(const KeptOptions before, kept_options(record.state.evaluation));
  const auto evaluate = [&](const Answers& answers) -> Result<Revised> {
    AXIOMETRY_TRY(Found found, state_->evaluate(test, revision.draft, links_of(record), answers, stop));
    found.evaluated.name = record.name_in_file;
    store::TestState state =
        state_of(found.evaluated, revision.draft.changes, {revision.draft.options, found.from_archive, before.profile});
    state.title = title.empty() ? record.state.title : title;
    state.plan = revision.plan ? revision.plan : record.state.plan;
    return Revised{std::move(state), {{std::move(found.asked), std::move(found.from_archive)}}};
  };
  const auto keep = [&](store::Transaction& archive, const Revised& revised) -> Result<int> {
    AXIOMETRY_TRY_VOID(go_on_unless(stop));
    return archive.revise(id, revision.base_version, revised.state, by);
  };
  AXIOMETRY_TRY(const int version, keep_as_evaluated(*state_, evaluate, keep));
  return kept_for_certain(this->test(id, version));
}

Result<KeptTest> Workbench::withdraw(store::Id id, bool withdrawn, const store::By& by) {
  AXIOMETRY_TRY_VOID(state_->store.withdraw(id, withdrawn, by));
  return kept_for_certain(test(id));
}

Result<KeptTest> Workbench::test(store::Id id, std::optional<int> version) const {
  AXIOMETRY_TRY(LookedUp found,
                state_->store.read([&](const store::Transaction& archive) { return look_up(archive, id, version); }));
  AXIOMETRY_TRY(KeptOptions options, kept_options(found.record.state.evaluation));
  AXIOMETRY_TRY(Changes changes, kept_changes(found.record.state));
  Draft draft{std::move(changes), std::move(options.options)};
  AXIOMETRY_TRY(Outcome outcome, kept_outcome(*state_, found.record, draft, std::move(options.from_archive)));
  outcome.result = with_finding(std::move(outcome.result), changed_limits(outcome.from_archive, found.axis));
  AXIOMETRY_TRY(const auto file, state_->file_of(found.record));
  return KeptTest{.record = std::move(found.record),
                  .size = file->size,
                  .versions = std::move(found.versions),
                  .machine = std::move(found.machine),
                  .axis = std::move(found.axis),
                  .instruments = std::move(found.instruments),
                  .documents = std::move(found.documents),
                  .draft = std::move(draft),
                  .profile = std::move(options.profile),
                  .outcome = std::move(outcome)};
}

Result<PreparedTest> Workbench::prepared(store::Id id, std::optional<int> version) const {
  AXIOMETRY_TRY(store::TestRecord record, state_->store.test(id, version));
  AXIOMETRY_TRY(const KeptOptions kept, kept_options(record.state.evaluation));
  AXIOMETRY_TRY(const Changes changes, kept_changes(record.state));
  AXIOMETRY_TRY(EvaluateOptions options, evaluate_options(kept.options));
  AXIOMETRY_TRY(Test measured, state_->measured(record));
  AXIOMETRY_TRY(Test test,
                prepare_test(std::move(measured), with_archive(std::move(options), changes, kept.from_archive)));
  return PreparedTest{std::move(record), std::move(test)};
}

Result<Rendered> Workbench::raw(store::Id id) const {
  AXIOMETRY_TRY(const store::TestRecord record, state_->store.test(id));
  AXIOMETRY_TRY(store::Content content, state_->store.content(record.sha256));
  return Rendered{std::move(content.bytes), "application/octet-stream", record.file_name};
}

}  // namespace axiometry::app
