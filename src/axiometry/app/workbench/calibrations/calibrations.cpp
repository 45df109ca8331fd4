// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/calibrations/calibrations.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "axiometry/app/files/file_name_part.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/app/workbench/kept_records.h"
#include "axiometry/app/workbench/withdrawn.h"
#include "axiometry/base/text/text.h"
#include "axiometry/report/drawing/utf8.h"

namespace axiometry::app {
namespace {

using json::Value;
using store::CalibrationRecord;
using store::KeptFigure;
using store::Versioned;

constexpr std::string_view calibration_word = "calibration";
constexpr std::string_view result_format = "calibration-result";

Result<void> take_instrument(const store::Store& archive, CalibrationRecord& calibration, std::optional<store::Id> id) {
  calibration.instrument = id;
  calibration.instrument_version.reset();
  if (!id) return {};
  AXIOMETRY_TRY(const auto instrument, archive.get<store::InstrumentRecord>(*id));
  calibration.instrument_version = instrument.version;
  return {};
}

/// The machine of the archive that the files name, where there is one: no machine is added by a calibration.
Result<std::optional<store::Id>> known_machine(const store::Store& archive, const std::string& name) {
  if (text::trim(name).empty()) return std::nullopt;
  store::MachineRecord stated;
  stated.name = name;
  AXIOMETRY_TRY(const auto known, archive.read([&](const store::Transaction& t) { return t.known(stated); }));
  return known ? std::optional(known->id) : std::nullopt;
}

/// The result of an evaluation among the contents.
store::Content result_content(const CalibrationRecord& calibration, const EvaluatedCalibration& evaluated) {
  return hashed_content(file_name_part(calibration.title) + ".json", std::string(result_format),
                        json::dump(result_of(evaluated), 0));
}

/// The files of a version as they were kept, in memory.
struct LoadedFiles {
  std::vector<store::Content> contents;
  std::vector<CalibrationSource> sources;
};

Result<LoadedFiles> loaded(const store::Store& archive, const CalibrationRecord& calibration) {
  LoadedFiles files;
  for (const store::KeptFile& file : calibration.files) {
    AXIOMETRY_TRY(store::Content content, archive.content(file.content));
    files.contents.push_back(std::move(content));
  }
  for (std::size_t k = 0; k < files.contents.size(); ++k)
    files.sources.push_back({calibration.files[k].role, calibration.files[k].name, files.contents[k].bytes});
  return files;
}

Result<EvaluatedCalibration> evaluated_again(const store::Store& archive, const CalibrationRecord& calibration,
                                             const Value& options, const std::stop_token& stop) {
  AXIOMETRY_TRY(const LoadedFiles files, loaded(archive, calibration));
  return evaluate_calibration(calibration.kind, files.sources, options, stop);
}

bool is_same(const KeptFigure& a, const KeptFigure& b) {
  return a.parameter == b.parameter && a.of == b.of && a.value == b.value && a.u == b.u && a.unit == b.unit;
}

/// Slopes of lines and what follows from them as JSON has it, which a report says and no figure holds.
std::vector<std::string> slopes_in(const Value& result) {
  const auto member = [](const Value* of, std::string_view name) {
    return of != nullptr && of->is(json::Kind::object) ? of->find(name) : nullptr;
  };
  std::vector<std::string> all;
  const auto add = [&](const Value* found) { all.push_back(found != nullptr ? json::dump(*found, 0) : ""); };
  add(member(member(&result, "squareness"), "terms"));
  add(member(member(&result, "diagonals"), "face_pairs"));
  const Value* lines = member(&result, "lines");
  if (lines != nullptr && lines->is(json::Kind::array))
    for (const Value& line : lines->items()) add(member(&line, "slope"));
  return all;
}

/// An edit over what a version says.
Result<void> take_texts(const store::Store& archive, CalibrationRecord& calibration,
                        const CalibrationRevision& revision) {
  if (revision.title) calibration.title = *revision.title;
  if (revision.machine) calibration.machine = *revision.machine;
  if (revision.measured_on) calibration.measured_on = *revision.measured_on;
  if (revision.notes) calibration.notes = *revision.notes;
  if (!revision.instrument) return {};
  return take_instrument(archive, calibration, *revision.instrument);
}

/// Whether both have the same bytes for the same ends, whatever the files are called.
bool has_same_files(std::vector<store::KeptFile> a, std::vector<store::KeptFile> b) {
  std::ranges::sort(a, {}, &store::KeptFile::role);
  std::ranges::sort(b, {}, &store::KeptFile::role);
  return std::ranges::equal(
      a, b, [](const auto& one, const auto& other) { return one.role == other.role && one.content == other.content; });
}

/// Those that are kept of exactly these files, in the order in which they came.
Result<std::vector<store::Id>> calibrations_of_files(const store::Store& archive,
                                                     const std::vector<store::KeptFile>& files) {
  std::vector<store::Id> ids;
  store::CalibrationFilter filter;
  filter.withdrawn = true;
  filter.descending = false;
  filter.limit = store::largest_page;
  while (true) {
    AXIOMETRY_TRY(const store::CalibrationPage page, archive.calibrations(filter));
    for (const store::CalibrationRow& row : page.rows)
      if (has_same_files(row.calibration.value.files, files)) ids.push_back(row.calibration.id);
    filter.offset += static_cast<std::int64_t>(page.rows.size());
    if (page.rows.empty() || filter.offset >= page.total) return ids;
  }
}

}  // namespace

Result<KeptCalibration> keep_calibration(store::Store& archive, const NewCalibration& sent, const store::By& by) {
  AXIOMETRY_TRY(const EvaluatedCalibration evaluated,
                evaluate_calibration(sent.kind, sent.files, sent.options, sent.stop));
  const SuggestedText own = suggested(evaluated);
  // Later on a person may correct it, with a name in the trail; nobody contradicts a file without noticing.
  if (!sent.measured_on.empty() && !own.measured_on.empty() && sent.measured_on != own.measured_on)
    return fail(fmt::format("found the date of test {} in the files, expected {} as given", own.measured_on,
                            sent.measured_on));
  CalibrationRecord calibration = calibration_of(sent.kind, evaluated);
  calibration.title = sent.title.empty() ? report::printable(own.title) : sent.title;
  if (text::trim(calibration.title).empty()) calibration.title = sent.kind;
  calibration.measured_on = sent.measured_on.empty() ? own.measured_on : sent.measured_on;
  calibration.notes = sent.notes;
  calibration.options = json::dump(sent.options, 0);
  calibration.machine = sent.machine;
  if (!sent.machine) {
    AXIOMETRY_TRY(calibration.machine, known_machine(archive, own.machine));
  }
  AXIOMETRY_TRY_VOID(take_instrument(archive, calibration, sent.instrument));
  const store::Content result = result_content(calibration, evaluated);
  calibration.result = result.sha256;
  std::vector<store::Content> contents;
  for (const CalibrationSource& file : sent.files) {
    contents.push_back(hashed_content(file.name, "calibration-" + file.role, std::string(file.bytes)));
    calibration.files.push_back({file.role, file.name, contents.back().sha256});
  }
  contents.push_back(result);
  AXIOMETRY_TRY(std::vector<store::Id> same_files, calibrations_of_files(archive, calibration.files));
  AXIOMETRY_TRY(const auto added, add_with(archive, calibration, contents, by));
  AXIOMETRY_TRY(KeptCalibration kept, kept_calibration(archive, added.id));
  kept.same_files = std::move(same_files);
  return kept;
}

Result<KeptCalibration> kept_calibration(const store::Store& archive, store::Id id, std::optional<int> version) {
  return archive.read([&](const store::Transaction& t) -> Result<KeptCalibration> {
    KeptCalibration kept;
    AXIOMETRY_TRY(kept.calibration, t.get<CalibrationRecord>(id, version));
    AXIOMETRY_TRY(kept.versions, t.versions<CalibrationRecord>(id));
    const CalibrationRecord& c = kept.calibration.value;
    if (c.machine) {
      AXIOMETRY_TRY(kept.machine, t.get<store::MachineRecord>(*c.machine));
    }
    if (c.instrument) {
      AXIOMETRY_TRY(kept.instrument, t.get<store::InstrumentRecord>(*c.instrument, c.instrument_version));
    }
    AXIOMETRY_TRY(kept.result, result_of_record(t, c.result));
    return kept;
  });
}

Result<KeptCalibration> revise_calibration(store::Store& archive, store::Id id, const CalibrationRevision& revision,
                                           const store::By& by) {
  AXIOMETRY_TRY(const auto base, archive.get<CalibrationRecord>(id, revision.base_version));
  AXIOMETRY_TRY_VOID(check_not_withdrawn(base, calibration_word));
  CalibrationRecord calibration = base.value;
  AXIOMETRY_TRY_VOID(take_texts(archive, calibration, revision));
  std::optional<store::Content> result;
  if (revision.options) {
    AXIOMETRY_TRY(const auto evaluated, evaluated_again(archive, calibration, *revision.options, revision.stop));
    CalibrationRecord found = calibration_of(calibration.kind, evaluated);
    calibration.program = std::move(found.program);
    calibration.figures = std::move(found.figures);
    calibration.verdict = std::move(found.verdict);
    calibration.serious = found.serious;
    calibration.options = json::dump(*revision.options, 0);
    result = result_content(calibration, evaluated);
    calibration.result = result->sha256;
  }
  AXIOMETRY_TRY_VOID(change_with(archive, base, calibration, result, by));
  return kept_calibration(archive, id);
}

Result<KeptCalibration> withdraw_calibration(store::Store& archive, store::Id id, bool withdrawn, const store::By& by) {
  AXIOMETRY_TRY_VOID(set_withdrawn<CalibrationRecord>(archive, id, withdrawn, by, calibration_word));
  return kept_calibration(archive, id);
}

Result<Rendered> calibration_report(const store::Store& archive, store::Id id, std::optional<int> version,
                                    const ReportRequest& request) {
  AXIOMETRY_TRY(const auto kept, archive.get<CalibrationRecord>(id, version));
  AXIOMETRY_TRY(const auto latest, archive.get<CalibrationRecord>(id));
  const std::string extension = text::to_lower(request.extension);
  AXIOMETRY_TRY(Rendered rendered,
                begun_report(archive, file_name_part(kept.value.title), kept.version, extension, kept.value.result));
  if (extension == "json") return as_json_report(std::move(rendered), latest.value.withdrawn);
  AXIOMETRY_TRY(const Value options, options_of_record(kept.value.options));
  AXIOMETRY_TRY(const auto evaluated, evaluated_again(archive, kept.value, options, request.stop));
  AXIOMETRY_TRY(const Value result, archive.read([&](const store::Transaction& t) -> Result<Value> {
    return result_of_record(t, kept.value.result);
  }));
  if (!std::ranges::equal(figures_of(evaluated), kept.value.figures, is_same) ||
      slopes_in(result_of(evaluated)) != slopes_in(result))
    return fail(ErrorKind::conflict,
                fmt::format("found other figures for calibration {} in version {} than {} kept with it, expected the "
                            "same: evaluate it again, which makes a new version",
                            id, kept.version, kept.value.program));
  report::Document document = document_of(evaluated, request.options);
  if (latest.value.withdrawn) document = labelled_withdrawn(std::move(document));
  AXIOMETRY_TRY(rendered.bytes, document_bytes(document, extension, request.options));
  return rendered;
}

Result<Rendered> calibration_file(const store::Store& archive, store::Id id, const std::string& role) {
  AXIOMETRY_TRY(const auto kept, archive.get<CalibrationRecord>(id));
  return kept_file(archive, kept.value.files, role, fmt::format("{} {}", calibration_word, id));
}

}  // namespace axiometry::app
