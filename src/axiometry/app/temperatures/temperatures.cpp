// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/temperatures/temperatures.h"

#include <fmt/format.h>

#include <utility>

#include "axiometry/app/files/output.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/results/uncertainty_json.h"
#include "axiometry/report/temperatures/temperatures.h"

namespace axiometry::app {
namespace {

using json::Value;

Value share_to_json(const std::optional<iso230_2::RecordedShare>& share) {
  if (!share) return {};
  Value object = Value::object();
  object.add("recorded_h", share->recorded_h);
  object.add("whole_h", share->whole_h);
  object.add("complete", share->complete());
  return object;
}

Value quantities_to_json(const iso230_2::TestEnvironment& environment) {
  Value items = Value::array();
  for (const iso230_2::EnvironmentItem& item : environment.items) {
    Value& row = items.push(Value::object());
    row.add("key", item.key);
    row.add("title", item.title);
    row.add("unit", item.unit);
    row.add("clause", item.clause);
    row.add("measured", number_or_null(item.measured));
    row.add("agreed", number_or_null(item.agreed));
    row.add("limit", item.lower_limit ? "lowest" : "highest");
    row.add("stated", item.stated);
    row.add("standing", iso230_2::standing_key(item.standing));
  }
  return items;
}

Value sensors_to_json(const TemperatureLog& log) {
  Value sensors = Value::array();
  for (const TemperatureCourse& course : log.sensors) {
    Value& row = sensors.push(Value::object());
    const auto extremes = extremes_of(course);
    row.add("name", course.location);
    row.add("role", course.role);
    row.add("readings", course.celsius.size());
    row.add("lowest_C", extremes ? Value(extremes->low) : Value());
    row.add("highest_C", extremes ? Value(extremes->high) : Value());
  }
  return sensors;
}

}  // namespace

json::Value to_json(const EvaluatedTemperatures& evaluated) {
  const TemperatureLog& log = evaluated.log;
  Value object = Value::object();
  object.add("standard", iso230_2::edition);
  object.add("result", "temperatures");
  object.add("log_begin", log.begin ? Value(moment_text(*log.begin)) : Value());
  object.add("began", evaluated.began.empty() ? Value() : Value(evaluated.began));
  object.add("ended", evaluated.ended.empty() ? Value() : Value(evaluated.ended));
  object.add("test_placed", evaluated.test.has_value());
  object.add("quantities", quantities_to_json(evaluated.environment));
  object.add("during", share_to_json(evaluated.environment.during));
  object.add("before", share_to_json(evaluated.environment.before));
  object.add("sensors", sensors_to_json(log));
  Value& remarks = object.add("remarks", Value::array());
  for (const std::string& remark : log.remarks) remarks.push(remark);
  Value& gaps = object.add("gaps", Value::array());
  for (const std::string& gap : iso230_2::gaps_of(evaluated.environment)) gaps.push(gap);
  Value& source = object.add("source", Value::object());
  source.add("file", evaluated.file);
  source.add("sha256", evaluated.sha256);
  object.add("program", program_to_json());
  return object;
}

json::Value environment_to_json(const EvaluatedTemperatures& evaluated) {
  const iso230_2::TestEnvironment& environment = evaluated.environment;
  Value object = Value::object();
  object.add("quantities", quantities_to_json(environment));
  object.add("exceeded", environment.exceeded());
  object.add("open", environment.open());
  object.add("soaked_h", number_or_null(environment.soaked_h));
  object.add("log_begin", evaluated.log.begin ? Value(moment_text(*evaluated.log.begin)) : Value());
  object.add("began", evaluated.began.empty() ? Value() : Value(evaluated.began));
  object.add("ended", evaluated.ended.empty() ? Value() : Value(evaluated.ended));
  object.add("ended_by_readings", evaluated.ended_by_readings.empty() ? Value() : Value(evaluated.ended_by_readings));
  object.add("test_placed", evaluated.test.has_value());
  object.add("during", share_to_json(environment.during));
  object.add("before", share_to_json(environment.before));
  object.add("sensors", sensors_to_json(evaluated.log));
  Value& remarks = object.add("remarks", Value::array());
  for (const std::string& remark : evaluated.log.remarks) remarks.push(remark);
  Value& gaps = object.add("gaps", Value::array());
  for (const std::string& gap : iso230_2::gaps_of(environment)) gaps.push(gap);
  Value& source = object.add("source", Value::object());
  source.add("file", evaluated.file);
  source.add("sha256", evaluated.sha256);
  return object;
}

json::Value environment_to_json(const iso230_2::TestEnvironment& stated) {
  Value object = Value::object();
  object.add("quantities", quantities_to_json(stated));
  object.add("exceeded", stated.exceeded());
  object.add("open", stated.open());
  object.add("soaked_h", number_or_null(stated.soaked_h));
  for (const char* of_a_log : {"log_begin", "began", "ended", "ended_by_readings"}) object.add(of_a_log, Value());
  object.add("test_placed", false);
  for (const char* of_a_log : {"during", "before"}) object.add(of_a_log, Value());
  for (const char* of_a_log : {"sensors", "remarks", "gaps"}) object.add(of_a_log, Value::array());
  object.add("source", Value());
  return object;
}

Result<void> write_outputs(const EvaluatedTemperatures& evaluated, const OutputNames& names,
                           const report::Options& options) {
  AXIOMETRY_TRY_VOID(check_inputs_spared(names));
  if (!names.reports.empty()) {
    const report::Document document = report::compose(report::subject_of(evaluated), options);
    AXIOMETRY_TRY_VOID(write_document(document, names.reports, options));
  }
  if (!names.json.empty()) AXIOMETRY_TRY_VOID(write_file(names.json, json::dump(to_json(evaluated)) + "\n"));
  return {};
}

}  // namespace axiometry::app
