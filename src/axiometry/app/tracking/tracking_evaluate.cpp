// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/tracking_evaluate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "axiometry/app/convert/convert.h"
#include "axiometry/app/files/file_name_part.h"
#include "axiometry/app/files/output.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/recordings/length_capture.h"
#include "axiometry/app/recordings/recording_members.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/plan/tracking_plan_json.h"
#include "axiometry/formats/text/simulated_note.h"
#include "axiometry/formats/tracking/station_json.h"
#include "axiometry/formats/tracking/tracking_lengths_csv.h"
#include "axiometry/model/aligned.h"
#include "axiometry/model/simulated.h"
#include "axiometry/report/sections/source_files.h"
#include "axiometry/report/tracking.h"
#include "axiometry/tracking/lengths/reading_order.h"

namespace axiometry::app {
namespace {

constexpr double moved_mm = 10.0;  // more is no better knowledge of the same place, but another one

/// Readings with their places in the file.
struct Assigned {
  std::vector<LengthReading> readings;
  std::vector<double> times_s;
};

Result<Assigned> assigned(const TrackingPlan& plan, const formats::TrackingLengths& lengths, bool reversed) {
  Assigned result;
  for (const formats::LengthRow& row : lengths.rows) {
    if (row.missing) continue;
    result.readings.push_back(row.reading);
    result.times_s.push_back(row.time_s);
  }
  if (std::ranges::all_of(result.times_s, [](double t) { return std::isnan(t); })) result.times_s.clear();
  if (!lengths.in_program_order) return result;
  std::vector<tracking::OrderedLength> in_order;
  for (const formats::LengthRow& row : lengths.rows)
    in_order.push_back({reversed ? -row.reading.length_difference_mm : row.reading.length_difference_mm,
                        row.reading.segment, row.missing});
  AXIOMETRY_TRY(result.readings, tracking::assign_in_order(plan, in_order));
  for (LengthReading& r : result.readings)
    if (reversed) r.length_difference_mm = -r.length_difference_mm;
  return result;
}

/// Limits of one line: its own in place of those of all.
ToleranceOptions tolerances_of(const std::string& line, const TrackingEvaluateOptions& options) {
  ToleranceOptions own = options.tolerance;
  own.many_tests = true;
  for (const LineTolerance& t : options.line_tolerances) {
    if (t.line != line) continue;
    std::erase_if(own.limits, [&](const ToleranceText& l) {
      return l.parameter == t.limit.parameter && l.unit->kind == t.limit.unit->kind;
    });
    own.limits.push_back(t.limit);
  }
  return own;
}

Result<void> check_tolerance_lines(const EvaluatedLines& evaluated, const TrackingEvaluateOptions& options) {
  std::vector<std::string_view> ids;
  for (const tracking::EvaluatedLine& line : evaluated.evaluation.lines) ids.push_back(line.id);
  for (const LineTolerance& t : options.line_tolerances)
    if (std::ranges::find(ids, t.line) == ids.end())
      return fail(fmt::format("found a tolerance for the line {}, expected one that was measured: {}",
                              text::quoted(t.line), fmt::join(ids, ", ")));
  return {};
}

Result<void> assess_lines(EvaluatedLines& evaluated, const TrackingEvaluateOptions& options) {
  AXIOMETRY_TRY_VOID(check_tolerance_lines(evaluated, options));
  for (const tracking::EvaluatedLine& line : evaluated.evaluation.lines) {
    EvaluateOptions of_line;
    of_line.artefact = false;
    of_line.tolerance = tolerances_of(line.id, options);
    of_line.uncertainty = options.uncertainty;
    AXIOMETRY_TRY(Evaluated test, evaluate_test(line.test, of_line));
    test.name = line.id;
    evaluated.tests.push_back(std::move(test));
  }
  std::vector<iso230_6::NamedEvaluation> diagonals;
  for (const Evaluated& test : evaluated.tests)
    if (is_diagonal(test.test.metadata.axis)) diagonals.push_back({test.name, test.assessment.evaluation});
  evaluated.diagonals = iso230_6::summarise(diagonals);
  return {};
}

/// The plan, with the located station in place of its own where there is one.
Result<void> read_setup(const TrackingFiles& files, EvaluatedLines& evaluated) {
  AXIOMETRY_TRY(evaluated.plan, in_file(formats::read_tracking_plan(files.plan.bytes), files.plan.name));
  evaluated.plan_file = {files.plan.name, sha256(files.plan.bytes)};
  if (!files.station) return {};
  const GivenFile& located = *files.station;
  if (is_aligned(evaluated.plan.setup))
    return std::unexpected(
        Error{"found a located station for a plan whose interferometer is aligned with each line, expected none",
              located.name,
              {}});
  AXIOMETRY_TRY(const Station station, in_file(formats::read_station(located.bytes), located.name));
  const double moved = distance(station.position_mm, evaluated.plan.setup.station.position_mm);
  evaluated.plan.setup.station = station;
  evaluated.station_file = ReadFile{located.name, sha256(located.bytes)};
  evaluated.evaluation.findings.push_back(
      {"lines-located-station", moved > moved_mm,
       fmt::format("the station of {} stands {} mm from that of the plan{}", text::quoted(base_name(located.name)),
                   format_fixed(moved, 3),
                   moved > moved_mm ? ": was the instrument moved, or does it belong to another plan?" : "")});
  return {};
}

void note_provenance(EvaluatedLines& evaluated, const formats::TrackingLengths& lengths) {
  for (tracking::EvaluatedLine& line : evaluated.evaluation.lines) {
    Provenance& p = line.test.provenance;
    p.file = evaluated.lengths.file;
    p.sha256 = evaluated.lengths.sha256;
    p.format = evaluated.recording.empty() ? "tracking-lengths" : evaluated.recording;
    p.remarks.insert(p.remarks.begin(), lengths.remarks.begin(), lengths.remarks.end());
  }
}

/// Lengths at approaches, out of a continuous recording.
Result<Assigned> recorded(Source& source, const TrackingEvaluateOptions& options, EvaluatedLines& evaluated,
                          Metadata& metadata) {
  CaptureOptions recording = options.recording;
  recording.matcher.reversed = options.reversed;
  AXIOMETRY_TRY(CapturedLengths lengths, read_length_recording(source, evaluated.plan, recording));
  evaluated.lengths = {source.name(), lengths.sha256};
  evaluated.recording = lengths.layout;
  if (lengths.simulated) metadata.conditions.purpose = simulation_purpose;
  for (std::string& note : lengths.notes)
    evaluated.evaluation.findings.push_back({"lines-recording", false, std::move(note)});
  return Assigned{std::move(lengths.readings), std::move(lengths.times_s)};
}

/// Lengths at approaches, and of a table what else it says.
Result<Assigned> read_lengths(Source& source, const TrackingEvaluateOptions& options, EvaluatedLines& evaluated,
                              formats::TrackingLengths& table) {
  AXIOMETRY_TRY(const std::string_view head, source.head());
  if (!options.recording.stream.empty() || formats::is_length_recording(head, evaluated.plan))
    return recorded(source, options, evaluated, table.metadata);
  AXIOMETRY_TRY_VOID(check_no_recording_stated(options.recording));
  AXIOMETRY_TRY(const std::string bytes, source.read_all(read_budget::file_bytes));
  evaluated.lengths = {source.name(), sha256(bytes)};
  AXIOMETRY_TRY(table, formats::read_tracking_lengths(bytes, evaluated.plan));
  evaluated.in_program_order = table.in_program_order;
  return assigned(evaluated.plan, table, options.reversed);
}

/// `files` are plan and station; the lengths are those of the source.
Result<EvaluatedLines> evaluate_source(Source& source, const TrackingFiles& files,
                                       const TrackingEvaluateOptions& options) {
  const std::string& lengths = files.lengths.name;
  EvaluatedLines evaluated;
  AXIOMETRY_TRY_VOID(read_setup(files, evaluated));
  formats::TrackingLengths read;
  AXIOMETRY_TRY(Assigned readings, in_file(read_lengths(source, options, evaluated, read), lengths));
  evaluated.lengths.file = lengths;
  if (read.metadata.conditions.purpose == simulation_purpose)
    evaluated.evaluation.findings.push_back({"lines-simulated", false, std::string(formats::simulated_lengths)});
  AXIOMETRY_TRY_VOID(set_metadata(read.metadata, options.metadata));
  tracking::LineEvaluationOptions of_lines;
  of_lines.metadata = read.metadata;
  of_lines.break_threshold_mm = options.break_threshold_mm;
  of_lines.find_breaks = options.find_breaks;
  of_lines.reversed = options.reversed;
  of_lines.in_program_order = read.in_program_order;
  of_lines.times_s = std::move(readings.times_s);
  std::vector<tracking::Finding> before = std::move(evaluated.evaluation.findings);
  AXIOMETRY_TRY(evaluated.evaluation,
                in_file(tracking::evaluate_lines(evaluated.plan, readings.readings, of_lines), lengths));
  auto& findings = evaluated.evaluation.findings;
  findings.insert(findings.begin(), before.begin(), before.end());
  note_provenance(evaluated, read);
  AXIOMETRY_TRY_VOID(in_file(assess_lines(evaluated, options), lengths));
  return evaluated;
}

}  // namespace

Result<void> add_tolerance(const std::string& text, TrackingEvaluateOptions& options) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) {
    AXIOMETRY_TRY(const ToleranceText limit, parse_tolerance(text));
    options.tolerance.limits.push_back(limit);
    return check_tolerances(options.tolerance.limits);
  }
  AXIOMETRY_TRY(const ToleranceText limit, parse_tolerance(std::string_view(text).substr(colon + 1)));
  LineTolerance own{std::string(text::trim(std::string_view(text).substr(0, colon))), limit};
  for (const LineTolerance& t : options.line_tolerances)
    if (t.line == own.line && t.limit.parameter == own.limit.parameter)
      return fail(fmt::format("found the tolerances {0}:{1} and {0}:{2}, expected one limit of {3} of a line", own.line,
                              t.limit.text(), own.limit.text(), own.limit.parameter->key));
  options.line_tolerances.push_back(std::move(own));
  return {};
}

Result<EvaluatedLines> evaluate_tracking(const std::string& lengths, const TrackingEvaluateOptions& options) {
  AXIOMETRY_TRY(const std::string plan, whole_file(options.plan));
  AXIOMETRY_TRY(const std::string station,
                options.station.empty() ? Result<std::string>(std::string()) : whole_file(options.station));
  AXIOMETRY_TRY(Source source, in_file(Source::open(lengths), lengths));
  TrackingFiles files{{lengths, {}}, {options.plan, plan}, {}};
  if (!options.station.empty()) files.station = GivenFile{options.station, station};
  return evaluate_source(source, files, options);
}

Result<EvaluatedLines> evaluate_tracking(const TrackingFiles& files, const TrackingEvaluateOptions& options) {
  Source source = Source::of_bytes(files.lengths.name, files.lengths.bytes);
  return evaluate_source(source, files, options);
}

report::Document lines_document(const EvaluatedLines& evaluated, const report::Options& options) {
  std::vector<report::AssessedLine> lines;
  for (std::size_t k = 0; k < evaluated.tests.size(); ++k)
    lines.push_back({evaluated.evaluation.lines[k], evaluated.tests[k].assessment, evaluated.tests[k].judgements});
  std::vector<report::SourceFile> others;
  if (!evaluated.plan_file.sha256.empty())
    others.push_back({"File of the plan", evaluated.plan_file.file, evaluated.plan_file.sha256});
  if (evaluated.station_file)
    others.push_back({"File of the station", evaluated.station_file->file, evaluated.station_file->sha256});
  return report::compose(report::LinesSubject{evaluated.plan, evaluated.evaluation, lines, evaluated.diagonals,
                                              evaluated.lengths.file, evaluated.lengths.sha256, others},
                         options);
}

Result<void> write_outputs(const EvaluatedLines& evaluated, const OutputNames& names, const report::Options& options) {
  AXIOMETRY_TRY_VOID(check_inputs_spared(names));
  if (!names.reports.empty())
    AXIOMETRY_TRY_VOID(write_document(lines_document(evaluated, options), names.reports, options));
  if (!names.json.empty()) AXIOMETRY_TRY_VOID(write_file(names.json, json::dump(to_json(evaluated)) + "\n"));
  return {};
}

Result<void> save_tests(const EvaluatedLines& evaluated, const std::string& name, const InputFiles& inputs) {
  const std::size_t mark = name.find(name_mark);
  if (mark == std::string::npos)
    return fail(fmt::format("found the name {} for the tests of all lines, expected one with {} for that of the line",
                            text::quoted(name), name_mark));
  AXIOMETRY_TRY(const formats::Format* format, format_to_write("", name));
  std::map<std::string, std::string> taken;
  for (const Evaluated& e : evaluated.tests) {
    std::string file = name;
    file.replace(mark, name_mark.size(), file_name_part(e.name));
    if (const auto [other, is_new] = taken.emplace(file, e.name); !is_new)
      return fail(fmt::format("found the lines {} and {} with the same file {}, expected different ones",
                              text::quoted(other->second), text::quoted(e.name), text::quoted(file)));
    AXIOMETRY_TRY_VOID(inputs.check_spared(file));
    Test test = e.test;
    test.provenance.file = base_name(test.provenance.file);
    for (const AppliedCorrection& correction : test.provenance.corrections) {
      std::string& comment = test.metadata.conditions.comment;
      comment += fmt::format("{}{} taken off", comment.empty() ? "" : "; ", correction.title);
    }
    AXIOMETRY_TRY_VOID(write_file(file, format->write(test)));
  }
  return {};
}

}  // namespace axiometry::app
