// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/compensations/compensations.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "axiometry/app/compensate/compensate_options.h"
#include "axiometry/app/files/file_name_part.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/app/workbench/compensations/compensation_standing.h"
#include "axiometry/app/workbench/kept_records.h"
#include "axiometry/app/workbench/withdrawn.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/version.h"

namespace axiometry::app {
namespace {

using json::Value;
using store::CompensationRecord;
using store::Versioned;

constexpr std::string_view compensation_word = "compensation";
constexpr std::string_view compensation_result_format = "compensation-result";
constexpr std::string_view table_role = "table";
constexpr std::string_view existing_role = "existing";

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
store::Content take_found(CompensationRecord& compensation, const CompensatedAxis& made, const std::string& name) {
  store::Content result =
      hashed_content(name + ".json", std::string(compensation_result_format), json::dump(present(made, {}).json, 0));
  compensation.program = fmt::format("axiometry {}", version);
  compensation.serious = static_cast<int>(std::ranges::count_if(made.findings, &NamedFinding::serious));
  compensation.figures = figures_of(made);
  compensation.result = result.sha256;
  return result;
}

Result<store::Content> kept_table(const store::Store& archive, const CompensationRecord& compensation) {
  const store::KeptFile* table = file_of(compensation.files, table_role);
  if (table == nullptr) return fail(ErrorKind::damaged, "found a compensation of the archive without its table");
  return archive.content(table->content);
}

/// Whether the control does the same with both, whatever their comments say: programs differ in those.
bool does_the_same(const CompensatedAxis& made, const std::string& kept) {
  if (made.text == kept) return true;
  const auto applied = nc::read_table(*made.control, kept, made.options);
  return applied && applied->positions() == made.applied.positions() &&
         applied->values(Direction::up) == made.applied.values(Direction::up) &&
         applied->values(Direction::down) == made.applied.values(Direction::down);
}

/// The table made again from what was kept, with the re-test that the version has.
Result<CompensatedAxis> made_again(const Workbench& workbench, store::Id id, const CompensationRecord& kept) {
  const store::Store& archive = workbench.archive();
  AXIOMETRY_TRY(const Value options, options_of_record(kept.options));
  AXIOMETRY_TRY(const CompensateRequest request, compensate_request_from(options));
  AXIOMETRY_TRY(const PreparedTest test, workbench.prepared(kept.test, kept.test_version));
  MeasuredAxis measured{named_test(test)};
  measured.is_kept = true;
  if (const store::KeptFile* existing = file_of(kept.files, existing_role)) {
    AXIOMETRY_TRY(store::Content content, archive.content(existing->content));
    measured.existing = NamedTable{existing->name, std::move(content.bytes)};
  }
  if (kept.retest) {
    AXIOMETRY_TRY(const PreparedTest retest, workbench.prepared(*kept.retest, kept.retest_version));
    measured.retest = named_test(retest);
  }
  AXIOMETRY_TRY(store::Content table, kept_table(archive, kept));
  if (const auto former = former_form(kept.control, table.bytes))
    return fail(ErrorKind::conflict,
                fmt::format("{} (the table of compensation {} is kept as it was made)", former->message, id));
  AXIOMETRY_TRY(CompensatedAxis made, compensate(std::move(measured), request));
  if (!does_the_same(made, table.bytes))
    return fail(
        ErrorKind::conflict,
        fmt::format("found that axiometry {} would make another table than compensation {}, made by {}; expected "
                    "the same: make a new one of test {}",
                    version, id, kept.program, kept.test));
  made.text = std::move(table.bytes);
  return made;
}

Result<void> take_retest(const Workbench& workbench, CompensationRecord& compensation,
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

/// Of those that count; the result is read only where the number that was kept with it does not tell.
Result<int> serious_of(const store::Transaction& archive, const ListedCompensation& line, const CompensationRecord& c) {
  const auto since = findings_since(line.test, line.retest);
  const auto of_tests = static_cast<int>(std::ranges::count_if(since, &NamedFinding::serious));
  if (!line.retest || line.retest_counts()) return c.serious + of_tests;
  AXIOMETRY_TRY(const Value result, result_of_record(archive, c.result));
  const auto counting = counting_findings(result, false);
  return of_tests + static_cast<int>(std::ranges::count(counting, "serious", &KeptFinding::severity));
}

Result<std::optional<NamedFinding>> former_form_of(const store::Transaction& archive, const CompensationRecord& c) {
  const auto kind = nc::axis_table_named(c.control);
  const store::KeptFile* table = file_of(c.files, table_role);
  if (!kind || (*kind)->former == nullptr || table == nullptr) return std::optional<NamedFinding>();
  AXIOMETRY_TRY(const store::Content content, archive.content(table->content));
  return former_form(c.control, content.bytes);
}

Result<ListedCompensation> listed(const store::Transaction& archive, Versioned<CompensationRecord> compensation,
                                  std::string made_at) {
  const CompensationRecord& c = compensation.value;
  ListedCompensation line;
  AXIOMETRY_TRY(line.test, test_of_compensation(archive, c.test, c.test_version));
  if (c.retest) {
    AXIOMETRY_TRY(line.retest, test_of_compensation(archive, *c.retest, *c.retest_version));
  }
  AXIOMETRY_TRY(line.serious, serious_of(archive, line, c));
  AXIOMETRY_TRY(line.former, former_form_of(archive, c));
  line.serious += line.former ? 1 : 0;
  if (c.axis) {
    AXIOMETRY_TRY(line.axis, archive.get<store::AxisRecord>(*c.axis));
    AXIOMETRY_TRY(line.machine, archive.get<store::MachineRecord>(line.axis->value.machine));
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
  store::Content table = hashed_content(name, "compensation-table", made.axis.text);
  CompensationRecord compensation;
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
        hashed_content(wanted.existing->name, "compensation-" + std::string(existing_role), wanted.existing->text));
    compensation.files.push_back({std::string(existing_role), wanted.existing->name, contents.back().sha256});
  }
  contents.push_back(std::move(table));
  store::Store& archive = workbench.archive();
  AXIOMETRY_TRY(const auto added, add_with(archive, compensation, contents, by));
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
    AXIOMETRY_TRY(auto compensation, t.get<CompensationRecord>(id, version));
    AXIOMETRY_TRY(kept.versions, t.versions<CompensationRecord>(id));
    const CompensationRecord& c = compensation.value;
    AXIOMETRY_TRY(kept.result, result_of_record(t, c.result));
    const store::KeptFile* table = file_of(c.files, table_role);
    if (table == nullptr) return fail(ErrorKind::damaged, "found a compensation of the archive without its table");
    AXIOMETRY_TRY(store::Content bytes, t.content(table->content));
    kept.table = std::move(bytes.bytes);
    AXIOMETRY_TRY(kept.head, listed(t, std::move(compensation), kept.versions.front().change.at));
    if (kept.head.former) {
      const NamedFinding& former = *kept.head.former;
      kept.findings.push_back({former.id, std::string(severity_word(former)), former.message});
    }
    for (NamedFinding& finding : findings_since(kept.head.test, kept.head.retest))
      kept.findings.push_back({std::move(finding.id), std::string(severity_word(finding)), std::move(finding.message)});
    std::ranges::move(counting_findings(kept.result, !kept.head.retest || kept.head.retest_counts()),
                      std::back_inserter(kept.findings));
    return kept;
  });
}

Result<KeptCompensation> revise_compensation(const Workbench& workbench, store::Id id,
                                             const CompensationRevision& revision, const store::By& by) {
  if (!revision.retest && !revision.notes)
    return fail("found a revision that changes nothing, expected a re-test or notes");
  store::Store& archive = workbench.archive();
  AXIOMETRY_TRY(const auto base, archive.get<CompensationRecord>(id, revision.base_version));
  AXIOMETRY_TRY_VOID(check_not_withdrawn(base, compensation_word));
  CompensationRecord compensation = base.value;
  if (revision.notes) compensation.notes = *revision.notes;
  std::optional<store::Content> result;
  if (revision.retest) {
    AXIOMETRY_TRY_VOID(take_retest(workbench, compensation, *revision.retest));
    AXIOMETRY_TRY(const CompensatedAxis made, made_again(workbench, id, compensation));
    result = take_found(compensation, made, file_of(compensation.files, table_role)->name);
  }
  AXIOMETRY_TRY_VOID(change_with(archive, base, compensation, result, by));
  return kept_compensation(archive, id);
}

Result<KeptCompensation> withdraw_compensation(store::Store& archive, store::Id id, bool withdrawn,
                                               const store::By& by) {
  AXIOMETRY_TRY_VOID(set_withdrawn<CompensationRecord>(archive, id, withdrawn, by, compensation_word));
  return kept_compensation(archive, id);
}

Result<Rendered> compensation_report(const Workbench& workbench, store::Id id, std::optional<int> version,
                                     const ReportRequest& request) {
  const store::Store& archive = workbench.archive();
  AXIOMETRY_TRY(const auto kept, archive.get<CompensationRecord>(id, version));
  AXIOMETRY_TRY(const auto latest, archive.get<CompensationRecord>(id));
  const store::KeptFile* table = file_of(kept.value.files, table_role);
  if (table == nullptr) return fail(ErrorKind::damaged, "found a compensation of the archive without its table");
  const std::string extension = text::to_lower(request.extension);
  const std::string stem = table->name.substr(0, table->name.rfind('.'));
  AXIOMETRY_TRY(Rendered rendered, begun_report(archive, stem, kept.version, extension, kept.value.result));
  if (extension == "json") return as_json_report(std::move(rendered), latest.value.withdrawn);
  AXIOMETRY_TRY(const ListedCompensation now,
                archive.read([&](const store::Transaction& t) { return listed(t, kept, std::string()); }));
  CompensationRecord counting = kept.value;
  if (!now.retest_counts()) counting.retest.reset();
  AXIOMETRY_TRY(CompensatedAxis made, made_again(workbench, id, counting));
  std::ranges::move(findings_since(now.test, now.retest), std::inserter(made.findings, made.findings.begin()));
  report::Document document = present(made, request.options, kept.value.notes).document;
  if (latest.value.withdrawn) document = labelled_withdrawn(std::move(document));
  AXIOMETRY_TRY(rendered.bytes, document_bytes(document, extension, request.options));
  return rendered;
}

Result<Rendered> compensation_file(const store::Store& archive, store::Id id, const std::string& role) {
  AXIOMETRY_TRY(const auto kept, archive.get<CompensationRecord>(id));
  return kept_file(archive, kept.value.files, role, fmt::format("{} {}", compensation_word, id));
}

}  // namespace axiometry::app
