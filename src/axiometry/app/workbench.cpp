// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "axiometry/app/given_text.h"
#include "axiometry/app/test_state.h"
#include "axiometry/app/workbench_state.h"

namespace axiometry::app {
namespace {

using State = Workbench::State;

constexpr std::size_t evaluated_in_preview = 8;
constexpr std::int64_t same_content_max = 100;

/// The first evaluation of a test and how it was made.
struct First {
  Found found;
  Draft draft;
};

/// With all that costs nothing. Inputs from which the GUM cannot be worked out are no reason to refuse a measurement:
/// then Annex A has to do, and who asks for the GUM hears why not.
Result<First> evaluate_first(State& state, const MeasuredTest& measured, const std::string& file_name) {
  Draft draft;
  Test test = measured.test;
  test.provenance.file = file_name;
  auto found = state.evaluate(test, draft);
  if (!found) {
    draft.options.gum = false;
    found = state.evaluate(std::move(test), draft);
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

Result<std::vector<store::Id>> ids_with(const store::Store& store, const std::string& sha256) {
  store::TestFilter filter;
  filter.sha256 = sha256;
  filter.withdrawn = true;
  filter.limit = same_content_max;
  AXIOMETRY_TRY(const store::TestPage page, store.tests(filter));
  std::vector<store::Id> ids;
  for (const store::TestRow& row : page.rows) ids.push_back(row.id);
  std::ranges::sort(ids);
  return ids;
}

using IdsByContent = std::map<std::string, std::vector<store::Id>>;

Result<IdsByContent> ids_by_content(const store::Store& store, std::span<const store::NewFile> files) {
  IdsByContent known;
  for (const store::NewFile& file : files) {
    AXIOMETRY_TRY(known[file.content.sha256], ids_with(store, file.content.sha256));
  }
  return known;
}

/// A file that was read and evaluated, ready to be kept.
Result<store::NewFile> incoming(State& state, const Upload& upload, std::optional<Outcome>& first) {
  AXIOMETRY_TRY(const auto file, state.read(upload.bytes, upload.name, upload.profile));
  AXIOMETRY_TRY(const std::string name, given_file_name(upload.name));
  store::NewFile all{.content = {file->sha256, name, file->format, std::string(upload.bytes)}, .tests = {}};
  for (const MeasuredTest& measured : file->tests) {
    AXIOMETRY_TRY(First evaluated, evaluate_first(state, measured, name));
    const Evaluated& e = evaluated.found.evaluated;
    store::NewTest test{.name_in_file = measured.name,
                        .state = state_of(e, evaluated.draft.changes,
                                          {evaluated.draft.options, evaluated.found.from_archive, upload.profile})};
    test.state.title = first_title(e);
    test.state.plan = upload.plan;
    all.tests.push_back(std::move(test));
    if (!first) first = outcome_of(std::move(evaluated.found));
  }
  return all;
}

/// What is known of the machine, axis and instruments of a record, as they are now.
Result<void> look_up_equipment(const store::Store& store, KeptTest& kept) {
  if (kept.record.machine) {
    AXIOMETRY_TRY(auto machine, store.get<store::Machine>(*kept.record.machine));
    kept.machine = std::move(machine.value);
  }
  if (kept.record.axis) {
    AXIOMETRY_TRY(auto axis, store.get<store::Axis>(*kept.record.axis));
    kept.axis = std::move(axis.value);
  }
  for (const store::Id id : kept.record.instruments) {
    AXIOMETRY_TRY(auto instrument, store.get<store::Instrument>(id));
    kept.instruments.push_back(std::move(instrument));
  }
  return {};
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

std::optional<AskedTable> asked_table(const Upload& upload) {
  constexpr std::size_t columns_max = 200;  // more nobody goes through one by one
  auto found = guess_measured(upload.bytes);
  if (!found || found->profile.columns.size() > columns_max) return {};
  return AskedTable{upload.profile.value_or(std::move(found->profile)), std::move(found->questions),
                    std::move(found->names), std::move(found->preview)};
}

}  // namespace

Workbench::Workbench(store::Store& store) : state_(std::make_unique<State>(store)) {}
Workbench::~Workbench() = default;

store::Store& Workbench::archive() const { return state_->store; }

Result<Preview> Workbench::preview(const Upload& upload) const {
  Preview preview;
  AXIOMETRY_TRY(preview.file_name, given_file_name(upload.name));
  preview.size = upload.bytes.size();
  preview.sha256 = sha256(upload.bytes);
  AXIOMETRY_TRY(preview.same_content, ids_with(state_->store, preview.sha256));
  const auto file = state_->read(upload.bytes, upload.name, upload.profile);
  if (!file || (*file)->format == "generic") preview.table = asked_table(upload);
  if (!file) {
    preview.refused = file.error();
    return preview;
  }
  preview.format = (*file)->format;
  for (const MeasuredTest& measured : (*file)->tests) {
    preview.tests.push_back({measured.name, measured.test.metadata, measured.test.series, {}});
    if (preview.tests.size() > evaluated_in_preview) continue;
    auto first = evaluate_first(*state_, measured, preview.file_name);
    if (!first) {
      preview.refused = first.error();
      preview.tests.clear();
      return preview;
    }
    preview.tests.back().outcome = outcome_of(std::move(first->found));
  }
  return preview;
}

Result<Received> Workbench::receive(std::span<const Upload> uploads, const store::By& by) {
  if (uploads.empty()) return fail("found no file, expected at least one");
  std::optional<Outcome> first;
  std::vector<store::NewFile> files;
  for (const Upload& upload : uploads) {
    AXIOMETRY_TRY(store::NewFile file, incoming(*state_, upload, first));
    files.push_back(std::move(file));
  }
  AXIOMETRY_TRY(IdsByContent known, ids_by_content(state_->store, files));
  AXIOMETRY_TRY(const auto ids, state_->store.receive(files, by));
  Received received{.tests = {}, .same_content = {}, .first = *std::move(first)};
  for (const auto& [sha256, same] : known)
    received.same_content.insert(received.same_content.end(), same.begin(), same.end());
  std::ranges::sort(received.same_content);
  std::span<const store::Id> left = ids;
  for (const store::NewFile& file : files) {
    std::vector<store::Id>& same = known[file.content.sha256];
    const auto own = left.first(file.tests.size());
    for (std::size_t k = 0; k < own.size(); ++k) received.tests.push_back({own[k], file.tests[k].state.title, same});
    same.insert(same.end(), own.begin(), own.end());
    left = left.subspan(own.size());
  }
  return received;
}

Result<Outcome> Workbench::evaluate(const Upload& upload, const Draft& draft, const std::string& test_name) const {
  AXIOMETRY_TRY(const auto file, state_->read(upload.bytes, upload.name, upload.profile));
  const Test* test = test_name.empty() && file->tests.size() == 1 ? &file->tests.front().test : file->find(test_name);
  if (test == nullptr)
    return fail(fmt::format("found a file of {} tests, expected one test or the name of one of them: {}{}",
                            file->tests.size(), file->tests.front().name, file->tests.size() > 1 ? ", …" : ""));
  return evaluate(*test, draft);
}

Result<Outcome> Workbench::evaluate(const Test& test, const Draft& draft) const {
  AXIOMETRY_TRY(Found found, state_->evaluate(test, draft));
  return outcome_of(std::move(found));
}

Result<Outcome> Workbench::draft(store::Id id, const Draft& draft) const {
  AXIOMETRY_TRY(const store::TestRecord record, state_->store.test(id));
  AXIOMETRY_TRY(Test test, state_->measured(record));
  AXIOMETRY_TRY(Found found, state_->evaluate(std::move(test), draft, links_of(record)));
  found.evaluated.name = record.name_in_file;
  return outcome_of(std::move(found));
}

Result<KeptTest> Workbench::revise(store::Id id, const Revision& revision, const store::By& by) {
  AXIOMETRY_TRY(const store::TestRecord record, state_->store.test(id));
  AXIOMETRY_TRY(const std::string title, given_line("title", revision.title));
  AXIOMETRY_TRY(Test test, state_->measured(record));
  AXIOMETRY_TRY(Found found, state_->evaluate(std::move(test), revision.draft, links_of(record)));
  found.evaluated.name = record.name_in_file;
  AXIOMETRY_TRY(KeptOptions before, kept_options(record.state.evaluation));
  store::TestState state = state_of(found.evaluated, revision.draft.changes,
                                    {revision.draft.options, found.from_archive, std::move(before.profile)});
  state.title = title.empty() ? record.state.title : title;
  state.plan = revision.plan ? revision.plan : record.state.plan;
  AXIOMETRY_TRY(const int version, state_->store.revise(id, revision.base_version, state, by));
  return this->test(id, version);
}

Result<KeptTest> Workbench::withdraw(store::Id id, bool withdrawn, const store::By& by) {
  AXIOMETRY_TRY_VOID(state_->store.withdraw(id, withdrawn, by));
  return test(id);
}

Result<KeptTest> Workbench::test(store::Id id, std::optional<int> version) const {
  const store::Store& store = state_->store;
  AXIOMETRY_TRY(store::TestRecord record, store.test(id, version));
  AXIOMETRY_TRY(KeptOptions options, kept_options(record.state.evaluation));
  AXIOMETRY_TRY(Changes changes, kept_changes(record.state));
  Draft draft{std::move(changes), std::move(options.options)};
  AXIOMETRY_TRY(Outcome outcome, kept_outcome(*state_, record, draft, std::move(options.from_archive)));
  KeptTest kept{.record = std::move(record),
                .size = 0,
                .versions = {},
                .machine = {},
                .axis = {},
                .instruments = {},
                .documents = {},
                .draft = std::move(draft),
                .profile = std::move(options.profile),
                .outcome = std::move(outcome)};
  AXIOMETRY_TRY(const auto file, state_->file_of(kept.record));
  kept.size = file->size;
  AXIOMETRY_TRY(kept.versions, store.test_versions(id));
  AXIOMETRY_TRY(kept.documents, store.documents(id));
  AXIOMETRY_TRY_VOID(look_up_equipment(store, kept));
  return kept;
}

Result<Rendered> Workbench::raw(store::Id id) const {
  AXIOMETRY_TRY(const store::TestRecord record, state_->store.test(id));
  AXIOMETRY_TRY(store::Content content, state_->store.content(record.sha256));
  return Rendered{std::move(content.bytes), "application/octet-stream", record.file_name};
}

}  // namespace axiometry::app
