// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/temperatures/temperatures.h"

#include <fmt/format.h>

#include <utility>

#include "axiometry/app/files/output.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/results/uncertainty_json.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/base/text.h"
#include "axiometry/report/temperatures/temperatures.h"

namespace axiometry::app {
namespace {

using json::Value;

Result<std::optional<Moment>> asked_moment(const std::string& text, std::string_view what) {
  if (text.empty()) return std::nullopt;
  const auto moment = moment_of(text);
  if (!moment)
    return fail(fmt::format("found {} as {} of the test, expected a moment such as 2026-03-02T09:00",
                            text::quoted(text), what));
  return moment;
}

Result<std::optional<TimeStretch>> placed_test(const TemperatureLog& log, const TemperatureRequest& request) {
  AXIOMETRY_TRY(const auto began, asked_moment(request.began, "the beginning"));
  AXIOMETRY_TRY(const auto ended, asked_moment(request.ended, "the end"));
  if (ended && !began) return fail("found the end of the test without its beginning, expected both");
  if (!began) return std::nullopt;
  if (!log.begin) return fail("found a temperature log without dates, expected dates to know when the test was");
  if (began->zoned != log.begin->zoned || (ended && ended->zoned != log.begin->zoned))
    return fail(fmt::format("found times {} a time zone in the temperature log, expected moments of the test {} one",
                            log.begin->zoned ? "with" : "without", log.begin->zoned ? "with" : "without"));
  const auto test = test_in_log(began, ended, log);
  if (!test)
    return fail(fmt::format("found a test that ended {}, expected an end after its beginning {}",
                            text::quoted(request.ended), text::quoted(request.began)));
  constexpr double an_hour = 3600.0;
  const TimeStretch all = stretch_of(log.sensors);
  if (test->end_s < all.begin_s || test->begin_s - hours_before_test * an_hour > all.end_s)
    return fail(
        fmt::format("found a temperature log that begins {} and lasts {:.3g} h, expected one of the test or of "
                    "the twelve hours before it",
                    moment_text(*log.begin), all.length_s() / an_hour));
  return test;
}

Result<EvaluatedTemperatures> evaluated_log(const std::string& bytes, const TemperatureRequest& request) {
  const iso230_2::AgreedEnvironment& agreed = request.agreed;
  if (agreed.lowest && agreed.highest && agreed.lowest->in_celsius() > agreed.highest->in_celsius())
    return fail(fmt::format("found an agreed lowest temperature of {} °C above the highest of {} °C",
                            format_exact(agreed.lowest->in_celsius()), format_exact(agreed.highest->in_celsius())));
  AXIOMETRY_TRY(TemperatureLog log, formats::read_temperature_log(bytes, request.roles));
  AXIOMETRY_TRY(const auto test, placed_test(log, request));
  auto environment = iso230_2::test_environment(log, test, agreed);
  return EvaluatedTemperatures{{},   sha256(bytes),         request.began, request.ended, std::move(log),
                               test, std::move(environment)};
}

Value share_to_json(const std::optional<iso230_2::RecordedShare>& share) {
  if (!share) return {};
  Value object = Value::object();
  object.add("recorded_h", share->recorded_h);
  object.add("whole_h", share->whole_h);
  object.add("complete", share->complete());
  return object;
}

}  // namespace

Result<EvaluatedTemperatures> evaluate_temperatures(const std::string& file, const TemperatureRequest& request) {
  const std::string shown = file == "-" ? "(standard input)" : file;
  auto source = Source::open(file);
  if (!source) return std::unexpected(in_file(std::move(source).error(), shown));
  auto bytes = source->read_all(read_budget::file_bytes);
  if (!bytes) return std::unexpected(in_file(std::move(bytes).error(), shown));
  auto evaluated = evaluated_log(*bytes, request);
  if (!evaluated) return std::unexpected(in_file(std::move(evaluated).error(), shown));
  evaluated->file = file;
  return evaluated;
}

json::Value to_json(const EvaluatedTemperatures& evaluated) {
  const TemperatureLog& log = evaluated.log;
  Value object = Value::object();
  object.add("standard", iso230_2::edition);
  object.add("result", "temperatures");
  object.add("log_begin", log.begin ? Value(moment_text(*log.begin)) : Value());
  object.add("began", evaluated.began.empty() ? Value() : Value(evaluated.began));
  object.add("ended", evaluated.ended.empty() ? Value() : Value(evaluated.ended));
  object.add("test_placed", evaluated.test.has_value());
  Value& items = object.add("quantities", Value::array());
  for (const iso230_2::EnvironmentItem& item : evaluated.environment.items) {
    Value& row = items.push(Value::object());
    row.add("key", item.key);
    row.add("title", item.title);
    row.add("unit", item.unit);
    row.add("clause", item.clause);
    row.add("measured", number_or_null(item.measured));
    row.add("agreed", number_or_null(item.agreed));
    row.add("limit", item.lower_limit ? "lowest" : "highest");
    row.add("standing", iso230_2::standing_key(item.standing));
  }
  object.add("during", share_to_json(evaluated.environment.during));
  object.add("before", share_to_json(evaluated.environment.before));
  Value& sensors = object.add("sensors", Value::array());
  for (const TemperatureCourse& course : log.sensors) {
    Value& row = sensors.push(Value::object());
    const auto [low, high] = std::ranges::minmax(course.celsius);
    row.add("name", course.location);
    row.add("role", course.role);
    row.add("readings", course.celsius.size());
    row.add("lowest_C", low);
    row.add("highest_C", high);
  }
  Value& remarks = object.add("remarks", Value::array());
  for (const std::string& remark : log.remarks) remarks.push(remark);
  Value& source = object.add("source", Value::object());
  source.add("file", evaluated.file);
  source.add("sha256", evaluated.sha256);
  object.add("program", program_to_json());
  return object;
}

Result<void> write_outputs(const EvaluatedTemperatures& evaluated, const OutputNames& names,
                           const report::Options& options) {
  AXIOMETRY_TRY_VOID(check_inputs_spared(names));
  if (!names.reports.empty()) {
    const report::Document document = report::compose(
        report::TemperatureSubject{base_name(evaluated.file), evaluated.sha256, evaluated.began, evaluated.ended,
                                   evaluated.log, evaluated.test, evaluated.environment},
        options);
    AXIOMETRY_TRY_VOID(write_document(document, names.reports, options));
  }
  if (!names.json.empty()) AXIOMETRY_TRY_VOID(write_file(names.json, json::dump(to_json(evaluated)) + "\n"));
  return {};
}

}  // namespace axiometry::app
