// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/compensations.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "axiometry/app/compensate/compensate_options.h"
#include "axiometry/app/files/file_name_part.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/base/text.h"
#include "axiometry/base/version.h"
#include "axiometry/digest/sha256.h"

namespace axiometry::app {
namespace {

using json::Value;
using store::Compensation;
using store::Versioned;

constexpr std::string_view compensation_result_format = "compensation-result";
constexpr std::string_view table_role = "table";
constexpr std::string_view existing_role = "existing";

store::Content content_made(std::string name, std::string format, std::string bytes) {
  std::string hash = sha256(bytes);
  return {std::move(hash), std::move(name), std::move(format), std::move(bytes)};
}

/// A version of a test that tables may be made of.
Result<PreparedTest> usable_test(const Workbench& workbench, store::Id id, std::optional<int> version) {
  AXIOMETRY_TRY(PreparedTest prepared, workbench.prepared(id, version));
  if (prepared.record.withdrawn)
    return fail(fmt::format("found test {} withdrawn, expected one that is not: reinstate it first", id));
  return prepared;
}

NamedTest named_test(const PreparedTest& prepared) { return {prepared.record.state.title, prepared.test}; }

/// "X-test-12-linuxcnc.comp".
std::string table_name(const PreparedTest& test, const CompensatedAxis& made) {
  return fmt::format("{}-test-{}-{}{}", file_name_part(made.options.axis), test.record.id, made.control->id,
                     made.control->extension);
}

/// A table with the tests that it is of.
struct Made {
  PreparedTest test;
  CompensatedAxis axis;
};

Result<Made> made_of(const Workbench& workbench, const NewCompensation& wanted) {
  AXIOMETRY_TRY(const CompensateRequest request, compensate_request_from(wanted.options));
  AXIOMETRY_TRY(PreparedTest test, usable_test(workbench, wanted.test, wanted.version));
  MeasuredAxis measured{named_test(test)};
  measured.existing = wanted.existing;
  AXIOMETRY_TRY(CompensatedAxis axis, compensate(std::move(measured), request));
  return Made{std::move(test), std::move(axis)};
}

void add_figures(std::vector<store::KeptFigure>& figures, const iso230_2::AxisParameters& parameters, const char* state,
                 AxisKind kind) {
  for (const iso230_2::ParameterInfo& parameter : iso230_2::parameters)
    if (const auto& value = parameters.*parameter.member)
      figures.push_back(
          {std::string(parameter.key), state, value->in_native(), {}, std::string(deviation_unit_key(kind))});
}

std::vector<store::KeptFigure> figures_of(const CompensatedAxis& made) {
  const AxisKind kind = made.options.kind;
  std::vector<store::KeptFigure> figures;
  add_figures(figures, made.before.parameters, "before", kind);
  add_figures(figures, made.predicted.parameters, "predicted", kind);
  if (made.expected) add_figures(figures, made.expected->percent_95, "percent_95", kind);
  if (made.retest) add_figures(figures, made.retest->evaluation.parameters, "retest", kind);
  return figures;
}

/// What the archive keeps of what was found: program, figures, serious findings, and the result among the contents.
store::Content take_found(Compensation& compensation, const CompensatedAxis& made, const std::string& name) {
  store::Content result =
      content_made(name + ".json", std::string(compensation_result_format), json::dump(present(made, {}).json, 0));
  compensation.program = fmt::format("axiometry {}", version);
  compensation.serious = static_cast<int>(std::ranges::count_if(made.findings, &NamedFinding::serious));
  compensation.figures = figures_of(made);
  compensation.result = result.sha256;
  return result;
}

const store::KeptFile* file_of(const Compensation& compensation, std::string_view role) {
  const auto found = std::ranges::find(compensation.files, role, &store::KeptFile::role);
  return found == compensation.files.end() ? nullptr : &*found;
}

Result<store::Content> kept_table(const store::Store& archive, const Compensation& compensation) {
  const store::KeptFile* table = file_of(compensation, table_role);
  if (table == nullptr) return fail(ErrorKind::damaged, "found a compensation of the archive without its table");
  return archive.content(table->content);
}

/// The table made again from what was kept, with the re-test that the version has.
Result<CompensatedAxis> made_again(const Workbench& workbench, store::Id id, const Compensation& kept) {
  const store::Store& archive = workbench.archive();
  const auto options = json::parse(kept.options);
  if (!options) return fail(ErrorKind::damaged, "found options of the archive that cannot be read");
  AXIOMETRY_TRY(const CompensateRequest request, compensate_request_from(*options));
  AXIOMETRY_TRY(const PreparedTest test, workbench.prepared(kept.test, kept.test_version));
  MeasuredAxis measured{named_test(test)};
  if (const store::KeptFile* existing = file_of(kept, existing_role)) {
    AXIOMETRY_TRY(store::Content content, archive.content(existing->content));
    measured.existing = NamedTable{existing->name, std::move(content.bytes)};
  }
  if (kept.retest) {
    AXIOMETRY_TRY(const PreparedTest retest, workbench.prepared(*kept.retest, kept.retest_version));
    measured.retest = named_test(retest);
  }
  AXIOMETRY_TRY(CompensatedAxis made, compensate(std::move(measured), request));
  AXIOMETRY_TRY(const store::Content table, kept_table(archive, kept));
  if (made.text != table.bytes)
    return fail(
        ErrorKind::conflict,
        fmt::format("found that axiometry {} would make another table than compensation {}, made by {}; expected "
                    "the same: make a new one of test {}",
                    version, id, kept.program, kept.test));
  return made;
}

Result<void> take_retest(const Workbench& workbench, Compensation& compensation,
                         const std::optional<store::Id>& retest) {
  compensation.retest = retest;
  compensation.retest_version.reset();
  if (!retest) return {};
  if (*retest == compensation.test)
    return fail(fmt::format("found test {} as its own re-test, expected one with the table active", *retest));
  AXIOMETRY_TRY(const PreparedTest test, usable_test(workbench, *retest, {}));
  if (compensation.axis && test.record.axis != compensation.axis)
    return fail(
        fmt::format("found test {} of another axis, expected one of the axis that the table corrects", *retest));
  compensation.retest_version = test.record.version;
  return {};
}

Result<TestOfCompensation> test_of(const store::Transaction& archive, store::Id id, int version) {
  AXIOMETRY_TRY(const store::TestRecord record, archive.test(id, version));
  return TestOfCompensation{id, version, record.state.title, record.state.measured_on};
}

Result<ListedCompensation> listed(const store::Transaction& archive, Versioned<Compensation> compensation,
                                  std::string made_at) {
  const Compensation& c = compensation.value;
  ListedCompensation line;
  AXIOMETRY_TRY(line.test, test_of(archive, c.test, c.test_version));
  if (c.retest) {
    AXIOMETRY_TRY(line.retest, test_of(archive, *c.retest, *c.retest_version));
  }
  if (c.axis) {
    AXIOMETRY_TRY(line.axis, archive.get<store::Axis>(*c.axis));
    AXIOMETRY_TRY(line.machine, archive.get<store::Machine>(line.axis->value.machine));
  }
  line.compensation = std::move(compensation);
  line.made_at = std::move(made_at);
  return line;
}

}  // namespace

Result<MadeCompensation> make_compensation(const Workbench& workbench, const NewCompensation& wanted) {
  AXIOMETRY_TRY(const Made made, made_of(workbench, wanted));
  return MadeCompensation{present(made.axis, {}).json, table_name(made.test, made.axis), made.axis.text};
}

Result<KeptCompensation> keep_compensation(const Workbench& workbench, const NewCompensation& wanted,
                                           const store::By& by) {
  AXIOMETRY_TRY(const Made made, made_of(workbench, wanted));
  const std::string name = table_name(made.test, made.axis);
  store::Content table = content_made(name, "compensation-table", made.axis.text);
  Compensation compensation;
  compensation.test = made.test.record.id;
  compensation.test_version = made.test.record.version;
  compensation.axis = made.test.record.axis;
  compensation.control = made.axis.control->id;
  compensation.notes = wanted.notes;
  compensation.options = json::dump(wanted.options, 0);
  compensation.files.push_back({std::string(table_role), name, table.sha256});
  std::vector<store::Content> contents = {take_found(compensation, made.axis, name)};
  if (wanted.existing) {
    contents.push_back(
        content_made(wanted.existing->name, "compensation-" + std::string(existing_role), wanted.existing->text));
    compensation.files.push_back({std::string(existing_role), wanted.existing->name, contents.back().sha256});
  }
  contents.push_back(std::move(table));
  store::Store& archive = workbench.archive();
  AXIOMETRY_TRY(const auto added, archive.write([&](store::Transaction& t) -> Result<Versioned<Compensation>> {
    for (const store::Content& content : contents) AXIOMETRY_TRY_VOID(t.keep(content, by));
    return t.add(compensation, by);
  }));
  return kept_compensation(archive, added.id);
}

Result<std::vector<ListedCompensation>> listed_compensations(const store::Store& archive,
                                                             const store::CompensationFilter& filter) {
  return archive.read([&](const store::Transaction& t) -> Result<std::vector<ListedCompensation>> {
    AXIOMETRY_TRY(auto rows, t.compensations(filter));
    std::vector<ListedCompensation> lines;
    for (store::CompensationRow& row : rows) {
      AXIOMETRY_TRY(ListedCompensation line, listed(t, std::move(row.compensation), std::move(row.made_at)));
      lines.push_back(std::move(line));
    }
    return lines;
  });
}

Result<KeptCompensation> kept_compensation(const store::Store& archive, store::Id id, std::optional<int> version) {
  return archive.read([&](const store::Transaction& t) -> Result<KeptCompensation> {
    KeptCompensation kept;
    AXIOMETRY_TRY(auto compensation, t.get<Compensation>(id, version));
    AXIOMETRY_TRY(kept.versions, t.versions<Compensation>(id));
    const Compensation& c = compensation.value;
    AXIOMETRY_TRY(const store::Content result, t.content(c.result));
    auto value = json::parse(result.bytes);
    if (!value)
      return fail(ErrorKind::damaged,
                  fmt::format("found a result of the archive that cannot be read: {}", value.error().message));
    kept.result = *std::move(value);
    const store::KeptFile* table = file_of(c, table_role);
    if (table == nullptr) return fail(ErrorKind::damaged, "found a compensation of the archive without its table");
    AXIOMETRY_TRY(store::Content bytes, t.content(table->content));
    kept.table = std::move(bytes.bytes);
    AXIOMETRY_TRY(kept.head, listed(t, std::move(compensation), kept.versions.front().change.at));
    return kept;
  });
}

Result<KeptCompensation> revise_compensation(const Workbench& workbench, store::Id id,
                                             const CompensationRevision& revision, const store::By& by) {
  if (!revision.retest && !revision.notes)
    return fail("found a revision that changes nothing, expected a re-test or notes");
  store::Store& archive = workbench.archive();
  AXIOMETRY_TRY(const auto base, archive.get<Compensation>(id, revision.base_version));
  Compensation compensation = base.value;
  if (revision.notes) compensation.notes = *revision.notes;
  std::optional<store::Content> result;
  if (revision.retest) {
    AXIOMETRY_TRY_VOID(take_retest(workbench, compensation, *revision.retest));
    AXIOMETRY_TRY(const CompensatedAxis made, made_again(workbench, id, compensation));
    result = take_found(compensation, made, file_of(compensation, table_role)->name);
  }
  const auto changed = archive.write([&](store::Transaction& t) -> Result<Versioned<Compensation>> {
    if (result) AXIOMETRY_TRY_VOID(t.keep(*result, by));
    return t.change(id, revision.base_version, compensation, by);
  });
  if (!changed) return std::unexpected(changed.error());
  return kept_compensation(archive, id);
}

Result<KeptCompensation> withdraw_compensation(store::Store& archive, store::Id id, bool withdrawn,
                                               const store::By& by) {
  const auto changed = archive.write([&](store::Transaction& t) -> Result<Versioned<Compensation>> {
    AXIOMETRY_TRY(auto latest, t.get<Compensation>(id));
    if (latest.value.withdrawn == withdrawn)
      return fail(ErrorKind::conflict, fmt::format("found compensation {} {}, expected it not to be", id,
                                                   withdrawn ? "withdrawn already" : "in the lists already"));
    latest.value.withdrawn = withdrawn;
    return t.change(id, latest.version, latest.value, by);
  });
  if (!changed) return std::unexpected(changed.error());
  return kept_compensation(archive, id);
}

Result<Rendered> compensation_report(const Workbench& workbench, store::Id id, std::optional<int> version,
                                     const ReportRequest& request) {
  const store::Store& archive = workbench.archive();
  AXIOMETRY_TRY(const auto kept, archive.get<Compensation>(id, version));
  const store::KeptFile* table = file_of(kept.value, table_role);
  if (table == nullptr) return fail(ErrorKind::damaged, "found a compensation of the archive without its table");
  const std::string extension = text::to_lower(request.extension);
  const std::string stem = table->name.substr(0, table->name.rfind('.'));
  Rendered rendered{{},
                    std::string(media_type_of(extension)),
                    fmt::format("{}{}.{}", stem, kept.version > 1 ? fmt::format("-v{}", kept.version) : "", extension)};
  if (extension == "json") {
    AXIOMETRY_TRY(store::Content result, archive.content(kept.value.result));
    rendered.bytes = std::move(result.bytes);
    return rendered;
  }
  AXIOMETRY_TRY(const CompensatedAxis made, made_again(workbench, id, kept.value));
  AXIOMETRY_TRY(rendered.bytes, document_bytes(present(made, request.options).document, extension, request.options));
  return rendered;
}

Result<Rendered> compensation_file(const store::Store& archive, store::Id id, const std::string& role) {
  AXIOMETRY_TRY(const auto kept, archive.get<Compensation>(id));
  const store::KeptFile* file = file_of(kept.value, role);
  if (file == nullptr)
    return fail(ErrorKind::not_found, fmt::format("found no file {} of compensation {}", text::quoted(role), id));
  AXIOMETRY_TRY(store::Content content, archive.content(file->content));
  return Rendered{std::move(content.bytes), std::string(octets), file->name};
}

}  // namespace axiometry::app
