// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/temperatures/evaluated_temperatures.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <utility>

#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/time/moment.h"
#include "axiometry/digest/sha256.h"

namespace axiometry::app {
namespace {

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

}  // namespace

bool TemperatureRequest::about_log_empty() const { return began.empty() && ended.empty() && roles.empty(); }

Result<EvaluatedTemperatures> evaluate_temperatures(std::string_view bytes, const std::string& name,
                                                    const TemperatureRequest& request) {
  const iso230_2::AgreedEnvironment& agreed = request.agreed;
  if (agreed.lowest && agreed.highest && agreed.lowest->in_celsius() > agreed.highest->in_celsius())
    return fail(fmt::format("found an agreed lowest temperature of {} °C above the highest of {} °C",
                            format_exact(agreed.lowest->in_celsius()), format_exact(agreed.highest->in_celsius())));
  AXIOMETRY_TRY(TemperatureLog log, formats::read_temperature_log(bytes, request.roles));
  AXIOMETRY_TRY(const auto test, placed_test(log, request));
  auto environment = iso230_2::test_environment(log, test, agreed);
  return EvaluatedTemperatures{name,           sha256(bytes), request.began,         request.ended,
                               std::move(log), test,          std::move(environment)};
}

Result<EvaluatedTemperatures> evaluate_temperatures(const std::string& file, const TemperatureRequest& request) {
  const std::string shown = file == "-" ? "(standard input)" : file;
  auto source = Source::open(file);
  if (!source) return std::unexpected(in_file(std::move(source).error(), shown));
  auto bytes = source->read_all(read_budget::file_bytes);
  if (!bytes) return std::unexpected(in_file(std::move(bytes).error(), shown));
  auto evaluated = evaluate_temperatures(*bytes, file, request);
  if (!evaluated) return std::unexpected(in_file(std::move(evaluated).error(), shown));
  return evaluated;
}

TemperatureRequest with_end_of_readings(TemperatureRequest request, const std::optional<Duration>& duration) {
  const auto began = moment_of(request.began);
  constexpr double ns_per_s = 1e9, longest_s = 366.0 * 86'400.0;  // times over a year are those of no test
  if (!request.ended.empty() || !began || !duration) return request;
  if (!(duration->in_s() > 0.0 && duration->in_s() <= longest_s)) return request;
  request.ended =
      moment_text({began->ns + static_cast<std::int64_t>(std::ceil(duration->in_s()) * ns_per_s), began->zoned});
  return request;
}

iso230_2::AgreedEnvironment agreed_of(iso230_2::AgreedEnvironment asked, const iso230_2::AgreedEnvironment& stated) {
  if (!asked.lowest) asked.lowest = stated.lowest;
  if (!asked.highest) asked.highest = stated.highest;
  if (!asked.rate) asked.rate = stated.rate;
  if (!asked.machine_gradient) asked.machine_gradient = stated.machine_gradient;
  return asked;
}

Result<EvaluatedTemperatures> evaluate_log_with_test(const LogWithTest& log, const std::optional<Duration>& duration,
                                                     const iso230_2::AgreedEnvironment& stated) {
  TemperatureRequest request = with_end_of_readings(log.request, duration);
  request.agreed = agreed_of(request.agreed, stated);
  auto evaluated =
      log.bytes ? evaluate_temperatures(*log.bytes, log.file, request) : evaluate_temperatures(log.file, request);
  if (!evaluated && log.bytes) return std::unexpected(in_file(std::move(evaluated).error(), log.file));
  if (evaluated && log.request.ended.empty()) evaluated->ended_by_readings = std::exchange(evaluated->ended, "");
  return evaluated;
}

}  // namespace axiometry::app
