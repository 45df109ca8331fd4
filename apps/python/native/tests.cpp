// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/convert/convert.h"
#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/files/output.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/results/second_opinion.h"
#include "axiometry/app/workbench/test_options.h"
#include "axiometry/base/json/json.h"
#include "axiometry/formats/test/metadata_json.h"
#include "axiometry/report/option_words.h"
#include "python/native/interpreter.h"
#include "python/native/rooms.h"
#include "python/native/taken.h"

namespace axiometry::python {
namespace {

namespace py = pybind11;
using Numbers = py::array_t<double, py::array::c_style>;

/// A test and what Python has stated of it, which counts over what its file says and is told as entered.
struct StatedTest {
  Test test;
  std::string name;          ///< of one among many in its file; else empty
  app::InputFiles inputs{};  ///< the file it was read from, whatever it is called since: no output may take its place
  app::Changes entered{};    ///< each key once

  /// As it is written and shown.
  Result<Test> whole() const {
    Test all = test;
    AXIOMETRY_TRY_VOID(app::set_metadata(all.metadata, app::metadata_items(entered)));
    return all;
  }
};

app::Changes changes_of(const std::string& json_object) {
  return taken_without_place(app::changes_from(taken(json::parse(json_object))));
}

void put_over(app::Changes& changes, app::Changes newer) {
  for (auto& [key, text] : newer) {
    std::erase_if(changes, [&](const auto& old) { return old.first == key; });
    changes.emplace_back(std::move(key), std::move(text));
  }
}

StatedTest test_of_arrays(const Numbers& targets, const Numbers& up, const Numbers& down, AxisKind kind) {
  std::vector<Position> places;
  for (py::ssize_t i = 0; i < targets.size(); ++i) places.push_back(Position::native(targets.at(i)));
  const auto runs = static_cast<std::size_t>(up.shape(1));
  std::vector<double> readings(up.data(), up.data() + up.size());
  readings.insert(readings.end(), down.data(), down.data() + down.size());
  StatedTest made{{{}, taken(Series::make_dense(std::move(places), runs, std::move(readings))), {}}, {}};
  made.test.metadata.axis.kind = kind;
  return made;
}

StatedTest test_of_file(const std::string& file, const std::string& format, const std::string& profile) {
  const OthersRun others_run;
  app::InputFiles inputs(std::vector<app::InputFile>{{file}});
  return {taken(app::read_test(file, format, profile)), {}, std::move(inputs)};
}

std::vector<StatedTest> tests_of_file(const std::string& file) {
  const OthersRun others_run;
  const app::InputFiles inputs(std::vector<app::InputFile>{{file}});
  std::vector<StatedTest> tests;
  app::Source source = taken(app::Source::open(file));
  taken(app::in_file(app::read_tests(source,
                                     [&](Test&& test, std::string&& name) -> Result<void> {
                                       tests.push_back({std::move(test), std::move(name), inputs});
                                       return {};
                                     }),
                     file));
  return tests;
}

Numbers targets_of(const StatedTest& t) {
  const auto targets = t.test.series.targets();
  Numbers numbers(static_cast<py::ssize_t>(targets.size()));
  std::ranges::transform(targets, numbers.mutable_data(), [](const Position& p) { return p.in_native(); });
  return numbers;
}

Numbers readings_of(const StatedTest& t, Direction direction) {
  const Series& series = t.test.series;
  const std::vector<std::size_t> shape = {series.target_count(), series.run_count()};
  Numbers numbers(shape);
  double* to = numbers.mutable_data();
  for (std::size_t i = 0; i < series.target_count(); ++i) to = std::ranges::copy(series.cell(i, direction), to).out;
  return numbers;
}

std::string metadata_of(const StatedTest& t) {
  json::Value object = json::Value::object();
  formats::add_metadata(object, taken(t.whole()).metadata);
  return json::dump(object, 0);
}

/// Gives what is left behind.
std::vector<std::string> write_test(const StatedTest& t, const std::string& file, const std::string& format) {
  const Test whole = taken(t.whole());
  const formats::Format* form = taken(app::format_to_write(format, file));
  taken(t.inputs.check_spared(file));
  taken(app::write_file(file, taken(app::in_file(app::lossless_bytes(whole, *form), file))));
  return app::left_behind(whole, *form);
}

/// Ctrl-C ends a long calculation as it ends one of Python.
bool goes_on(const uncertainty::Progress&) {
  const py::gil_scoped_acquire python;
  return PyErr_CheckSignals() == 0;
}

struct EvaluateCall {
  std::string options;  ///< as app::test_options_from()
  std::string stated;   ///< as app::changes_from()
  std::vector<std::string> tolerances;
  std::optional<std::string> rule;
  bool verify = false;
};

struct Outcome {
  app::Evaluated evaluated;
  app::InputFiles inputs;  ///< the test's
};

Result<app::EvaluateOptions> options_of(const EvaluateCall& call, const StatedTest& t) {
  AXIOMETRY_TRY(const json::Value given, json::parse(call.options));
  AXIOMETRY_TRY(const app::TestOptions chosen, app::test_options_from(given));
  AXIOMETRY_TRY(app::EvaluateOptions options, app::evaluate_options(chosen));
  app::Changes changes = t.entered;
  put_over(changes, changes_of(call.stated));
  for (const auto& [key, text] : changes) options.stated.items.push_back({key, StatedBy::entered});
  options.metadata = app::metadata_items(changes);
  for (const std::string& text : call.tolerances) {
    AXIOMETRY_TRY(app::ToleranceText limit, app::parse_tolerance(text));
    options.tolerance.limits.push_back(std::move(limit));
  }
  AXIOMETRY_TRY_VOID(app::check_tolerances(options.tolerance.limits));
  if (call.rule) {
    AXIOMETRY_TRY(options.tolerance.rule, app::parse_rule(*call.rule));
  }
  options.uncertainty.trials.propagation.on_progress = goes_on;
  return options;
}

Outcome evaluated(const StatedTest& t, const EvaluateCall& call) {
  const app::EvaluateOptions options = taken_without_place(options_of(call, t));
  const auto computed = [&]() -> Result<app::Evaluated> {
    const OthersRun others_run;
    AXIOMETRY_TRY(app::Evaluated outcome, app::evaluate_test(t.test, options));
    outcome.name = t.name;
    if (call.verify) {
      AXIOMETRY_TRY(outcome.verified, app::second_opinion(outcome, options.uncertainty, {}));
    }
    return outcome;
  };
  auto outcome = computed();
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  return {taken(app::in_file(std::move(outcome), t.test.provenance.file)), t.inputs};
}

struct ReportCall {
  std::string file;
  std::string language;
  std::optional<std::string> decimal;  ///< "point" or "comma"; else as the language has it
  std::optional<int> decimals;
};

Result<report::Options> report_options(const ReportCall& call) {
  report::Options options;
  AXIOMETRY_TRY(options.language, language::chosen_language(call.language));
  options.numbers = language::usual_numbers(options.language);
  if (call.decimal) {
    AXIOMETRY_TRY(options.numbers.decimal_mark, report::decimal_mark_of(*call.decimal));
  }
  if (call.decimals && (*call.decimals < 0 || *call.decimals > report::most_deviation_decimals))
    return fail(fmt::format("found {} decimals, expected 0 to {}", *call.decimals, report::most_deviation_decimals));
  options.deviation_decimals = call.decimals;
  return options;
}

void write_report(const Outcome& outcome, const ReportCall& call) {
  const report::Options options = taken(report_options(call));
  app::OutputNames names{.json = {}, .reports = {call.file}, .inputs = outcome.inputs, .uncertainty = {}};
  taken(app::check_outputs(names));
  const auto written = [&] {
    const OthersRun others_run;
    return app::write_outputs(outcome.evaluated, names, options);
  };
  taken(written());
}

}  // namespace

void add_tests(py::module_& module) {
  py::class_<StatedTest>(module, "Test")
      .def_property_readonly("name", [](const StatedTest& t) { return t.name; })
      .def_property_readonly("targets", &targets_of)
      .def_property_readonly("up", [](const StatedTest& t) { return readings_of(t, Direction::up); })
      .def_property_readonly("down", [](const StatedTest& t) { return readings_of(t, Direction::down); })
      .def_property_readonly("kind", [](const StatedTest& t) { return axis_kind_name(t.test.metadata.axis.kind); })
      .def_property_readonly("metadata", &metadata_of)
      .def_property_readonly(
          "source", [](const StatedTest& t) { return json::dump(app::source_to_json(t.test.provenance, t.name), 0); })
      .def_property_readonly("remarks",
                             [](const StatedTest& t) {
                               std::vector<std::string> remarks;
                               for (const SourceRemark& remark : t.test.provenance.remarks)
                                 remarks.push_back(remark.message);
                               return remarks;
                             })
      .def("stating",
           [](const StatedTest& t, const std::string& stated) {
             StatedTest other = t;
             put_over(other.entered, changes_of(stated));
             taken(other.whole());
             return other;
           })
      .def("write", &write_test);
  py::class_<Outcome>(module, "Outcome")
      .def_property_readonly("json", [](const Outcome& o) { return json::dump(app::to_json(o.evaluated), 0); })
      .def("report", [](const Outcome& o, std::string file, std::string language, std::optional<std::string> decimal,
                        std::optional<int> decimals) {
        write_report(o, {std::move(file), std::move(language), std::move(decimal), decimals});
      });
  module.def("test_of_arrays", [](const Numbers& targets, const Numbers& up, const Numbers& down, bool rotary) {
    return test_of_arrays(targets, up, down, rotary ? AxisKind::rotary : AxisKind::linear);
  });
  module.def("test_of_file", &test_of_file);
  module.def("tests_of_file", &tests_of_file);
  module.def("evaluate", [](const StatedTest& t, std::string options, std::string stated,
                            std::vector<std::string> tolerances, std::optional<std::string> rule, bool verify) {
    return evaluated(t, {std::move(options), std::move(stated), std::move(tolerances), std::move(rule), verify});
  });
}

}  // namespace axiometry::python
