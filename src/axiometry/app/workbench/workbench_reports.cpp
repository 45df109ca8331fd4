// SPDX-License-Identifier: Apache-2.0
// Reports, figures and documents of the tests in the archive.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "axiometry/app/files/file_name_part.h"
#include "axiometry/app/files/given_text.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/results/report_subject.h"
#include "axiometry/app/results/second_opinion.h"
#include "axiometry/app/workbench/from_archive/axis_limits.h"
#include "axiometry/app/workbench/test_state.h"
#include "axiometry/app/workbench/withdrawn.h"
#include "axiometry/app/workbench/workbench_state.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/temperatures/temperature_log.h"
#include "axiometry/report/drawing/dark_page.h"
#include "axiometry/report/drawing/svg.h"
#include "axiometry/report/figures/conformity.h"
#include "axiometry/report/figures/contribution.h"
#include "axiometry/report/figures/distribution.h"
#include "axiometry/report/figures/drift_recording.h"
#include "axiometry/report/figures/figures.h"
#include "axiometry/report/figures/mean_deviations.h"
#include "axiometry/report/temperatures/temperatures.h"
#include "axiometry/report/translated.h"
#include "axiometry/report/writer.h"

namespace axiometry::app {
namespace {

struct MediaRow {
  std::string_view extension;
  std::string_view media_type;
};
constexpr std::array media_types = {
    MediaRow{"html", "text/html; charset=utf-8"},
    MediaRow{"pdf", "application/pdf"},
    MediaRow{"svg", "image/svg+xml"},
    MediaRow{"png", "image/png"},
    MediaRow{"csv", "text/csv; charset=utf-8"},
    MediaRow{"json", "application/json"},
};

/// Types that a browser shows and does not run.
constexpr std::array<std::string_view, 6> harmless = {"image/png",  "image/jpeg",      "image/gif",
                                                      "image/webp", "application/pdf", "text/plain"};

/// "image/png" of "image/PNG; q=1"; octets of what is no media type.
std::string checked_media_type(std::string_view sent) {
  const std::string type = text::to_lower(text::trim(sent.substr(0, sent.find(';'))));
  const auto is_token = [](std::string_view s) {
    return !s.empty() && s.size() <= 100 && std::ranges::all_of(s, [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || std::string_view("!#$&-^_.+").contains(c);
    });
  };
  const auto parts = text::split(type, '/');
  const bool sound = parts.size() == 2 && is_token(parts[0]) && is_token(parts[1]);
  return sound ? type : std::string(octets);
}

std::string report_file_name(const store::TestRecord& record, std::string_view extension) {
  const std::string& title = record.state.title;
  return fmt::format("{}{}.{}", title.empty() ? fmt::format("test-{}", record.id) : file_name_part(title),
                     record.version > 1 ? fmt::format("-v{}", record.version) : std::string(), extension);
}

Result<const report::Writer*> report_writer_of(const std::string& extension) {
  if (const report::Writer* writer = report::find_writer(extension)) return writer;
  std::vector<std::string_view> known;
  for (const report::Writer* writer : report::writer_table()) known.push_back(writer->extension);
  return fail(ErrorKind::not_found, fmt::format("found a report ending in .{}, expected .json, .{}",
                                                text::to_lower(extension), fmt::join(known, ", .")));
}

/// The result that a version keeps, as `axiometry evaluate --json` writes it, and what has changed since; where it is
/// issued, with what the trail was before.
Result<std::string> kept_json(Workbench::State& state, const store::TestRecord& record, const std::string& trail_head) {
  AXIOMETRY_TRY(const auto changed, state.changed_limits_of(record));
  AXIOMETRY_TRY(json::Value value, kept_result(record));
  value = with_finding(std::move(value), changed);
  if (record.withdrawn) value.add("withdrawn", true);
  if (!trail_head.empty()) value.add("issue", json::Value::object()).add("trail_head", trail_head);
  return json::dump(value) + "\n";
}

/// No report leaves the archive whose figures a second way does not find again.
Result<report::VerifiedFigures> second_opinion_of(const Evaluated& evaluated, const report::Options& options,
                                                  std::string written = {}) {
  const UncertaintyOptions asked{
      evaluated.assessment.gum.has_value(), evaluated.assessment.monte_carlo.has_value(), {}};
  auto verified = second_opinion(evaluated, asked, options, std::move(written));
  if (!verified) return fail(ErrorKind::damaged, verified.error().message);
  return verified;
}

/// A copy: what was evaluated is remembered without what changes later.
std::shared_ptr<const Evaluated> with_finding(Evaluated evaluated, const iso230_2::Finding& finding) {
  evaluated.assessment.findings.push_back(finding);
  return std::make_shared<const Evaluated>(std::move(evaluated));
}

/// As the archive sees it now: what is withdrawn says so wherever its results stand.
iso230_2::Assessment assessment_of_record(const store::TestRecord& record, const Evaluated& evaluated) {
  return record.withdrawn ? labelled_withdrawn(evaluated.assessment) : evaluated.assessment;
}

report::Subject with_assessment(const report::Subject& s, const iso230_2::Assessment& assessment) {
  return {s.test, assessment, s.judgements, s.verified, s.trail_head, s.temperatures, s.environment};
}

/// Of an issued report, where the audit trail ended before.
Result<Rendered> render(Workbench::State& state, const store::TestRecord& record, const ReportRequest& request,
                        const std::string& trail_head = {}) {
  const std::string extension = text::to_lower(request.extension);
  Rendered rendered{{}, std::string(media_type_of(extension)), report_file_name(record, extension)};
  if (extension == "json") {
    AXIOMETRY_TRY(rendered.bytes, kept_json(state, record, trail_head));
    return rendered;
  }
  AXIOMETRY_TRY(const report::Writer* writer, report_writer_of(extension));
  AXIOMETRY_TRY(auto evaluated, state.evaluated(record, request.stop));
  AXIOMETRY_TRY(const auto changed, state.changed_limits_of(record));
  if (changed) evaluated = with_finding(*evaluated, *changed);
  AXIOMETRY_TRY_VOID(go_on_unless(request.stop));
  AXIOMETRY_TRY(const auto verified, second_opinion_of(*evaluated, request.options));
  AXIOMETRY_TRY_VOID(go_on_unless(request.stop));
  const iso230_2::Assessment labelled = assessment_of_record(record, *evaluated);
  report::Subject subject = with_assessment(report_subject(*evaluated, trail_head), labelled);
  subject.verified = verified;
  AXIOMETRY_TRY(rendered.bytes, writer->write(subject, request.options));
  return rendered;
}

std::vector<report::Figure> drawn_figures(const store::TestRecord& record, const Evaluated& evaluated,
                                          const report::Options& options) {
  const iso230_2::Assessment labelled = assessment_of_record(record, evaluated);
  const report::Subject subject = with_assessment(report_subject(evaluated), labelled);
  std::vector<report::Figure> figures = report::figures(subject, options);
  for (auto& further :
       {report::surroundings_figure(subject, options), report::conformity_figure(subject, options),
        report::mean_annex_a_figure(subject, options), report::mean_deviation_figure(subject, options),
        report::mean_interval_figure(subject, options), report::contribution_figure(subject, options),
        report::distribution_figure(subject, options), report::drift_recording_figure(subject, options)})
    if (further) figures.push_back(*further);
  for (report::Figure& figure : figures) figure = report::with_words_translated(std::move(figure), options);
  return figures;
}

}  // namespace

std::string_view media_type_of(std::string_view extension) {
  const auto row = std::ranges::find(media_types, extension, &MediaRow::extension);
  return row == media_types.end() ? octets : row->media_type;
}

Result<Rendered> Workbench::report(store::Id id, std::optional<int> version, const ReportRequest& request) const {
  AXIOMETRY_TRY(const store::TestRecord record, state_->store.test(id, version));
  return render(*state_, record, request);
}

Result<bool> Workbench::runs_trials_for(store::Id id, std::optional<int> version) const {
  AXIOMETRY_TRY(const store::TestRecord record, state_->store.test(id, version));
  if (state_->remembered(record)) return false;
  AXIOMETRY_TRY(const KeptOptions kept, kept_options(record.state.evaluation));
  return kept.options.monte_carlo;
}

Result<store::DocumentRecord> Workbench::issue(store::Id id, std::optional<int> version, const ReportRequest& request,
                                               const store::By& by) {
  AXIOMETRY_TRY(const store::TestRecord record, state_->store.test(id, version));
  if (record.withdrawn)
    return fail(ErrorKind::conflict,
                fmt::format("found test {} withdrawn, expected one that is not: reinstate it first", id));
  AXIOMETRY_TRY(const store::Head head, state_->store.head());
  AXIOMETRY_TRY(const Rendered rendered, render(*state_, record, request, store::short_text(head)));
  if (text::to_lower(request.extension) == "json") {
    AXIOMETRY_TRY(const auto evaluated, state_->evaluated(record, request.stop));
    AXIOMETRY_TRY([[maybe_unused]] const auto verified, second_opinion_of(*evaluated, request.options, rendered.bytes));
  }
  store::DocumentRecord document;
  document.test = id;
  document.version = record.version;
  document.kind = store::DocumentRecord::Kind::report;
  document.name = rendered.file_name;
  document.media_type = rendered.media_type;
  document.language = language::tag(request.language);
  return state_->store.write([&](store::Transaction& archive) -> Result<store::DocumentRecord> {
    AXIOMETRY_TRY_VOID(go_on_unless(request.stop));
    return archive.add_document(document, rendered.bytes, by);
  });
}

Result<store::DocumentRecord> Workbench::attach(store::Id id, const Attachment& attachment, const store::By& by) {
  if (attachment.bytes.empty()) return fail("found an empty file, expected an attachment");
  AXIOMETRY_TRY(const store::TestRecord record, state_->store.test(id));
  store::DocumentRecord document;
  document.test = id;
  document.version = record.version;
  document.kind = store::DocumentRecord::Kind::attachment;
  AXIOMETRY_TRY(document.name, given_file_name(attachment.name));
  document.media_type = checked_media_type(attachment.media_type);
  return state_->store.add_document(document, attachment.bytes, by);
}

Result<Rendered> Workbench::document(store::Id id) const {
  AXIOMETRY_TRY(const store::DocumentRecord document, state_->store.document(id));
  AXIOMETRY_TRY(store::Content content, state_->store.content(document.sha256));
  const std::string type = checked_media_type(document.media_type);
  const bool shown = std::ranges::find(harmless, type) != harmless.end();
  return Rendered{std::move(content.bytes), shown ? type : std::string(octets), document.name};
}

Result<std::vector<std::string>> Workbench::temperature_sensors(store::Id id) const {
  AXIOMETRY_TRY(const store::DocumentRecord document, state_->store.document(id));
  AXIOMETRY_TRY(const auto bytes, state_->log_bytes(document.sha256));
  return in_file(formats::sensors_of_log(*bytes), document.name);
}

Result<std::vector<std::string>> Workbench::figures(store::Id id, std::optional<int> version,
                                                    const ReportRequest& request) const {
  AXIOMETRY_TRY(const store::TestRecord record, state_->store.test(id, version));
  AXIOMETRY_TRY(const auto evaluated, state_->evaluated(record, request.stop));
  std::vector<std::string> titles;
  for (const report::Figure& figure : drawn_figures(record, *evaluated, request.options))
    titles.push_back(figure.title);
  return titles;
}

Result<std::string> Workbench::figure(store::Id id, std::optional<int> version, std::size_t index, bool dark,
                                      const ReportRequest& request) const {
  AXIOMETRY_TRY(const store::TestRecord record, state_->store.test(id, version));
  AXIOMETRY_TRY(const auto evaluated, state_->evaluated(record, request.stop));
  auto figures = drawn_figures(record, *evaluated, request.options);
  if (index >= figures.size())
    return fail(ErrorKind::not_found,
                fmt::format("found the figure {} of a test with {}, expected one of them", index + 1, figures.size()));
  report::Figure& figure = figures[index];
  return report::to_svg(dark ? report::for_dark_page(std::move(figure)) : figure);
}

}  // namespace axiometry::app
