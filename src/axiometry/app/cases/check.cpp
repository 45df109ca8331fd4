// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/cases/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "axiometry/app/cases/case_expectation.h"
#include "axiometry/app/cases/case_model.h"
#include "axiometry/app/cases/case_text.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/model/fields.h"
#include "axiometry/standards/readings/nde_correction.h"

namespace axiometry::app {
namespace {

struct Setting {
  std::string key;
  std::string value;
};

/// What one operation has said so far.
struct Operation {
  std::optional<std::string> file;
  std::vector<Setting> settings;
  bool correct_expansion = false;
  AxisKind kind = AxisKind::linear;
  std::vector<Position> targets;
  std::vector<Reading> readings;
  std::size_t runs_up = 0;
  std::size_t runs_down = 0;
  StatedTolerance tolerance;
  std::optional<Result<OperationOutcome>> outcome;  ///< once an expectation has asked for it
};

Result<Test> make_test(const Operation& operation, const LoadTest& load) {
  if (operation.file) return load(*operation.file);
  AXIOMETRY_TRY(Series series, Series::make(operation.targets, operation.readings));
  Test test{{}, std::move(series), {}};
  test.metadata.axis.kind = operation.kind;
  return test;
}

Result<OperationOutcome> carry_out(const Operation& operation, const LoadTest& load) {
  AXIOMETRY_TRY(Test test, make_test(operation, load));
  for (const Setting& setting : operation.settings)
    AXIOMETRY_TRY_VOID(set_field_text(test.metadata, setting.key, setting.value));
  if (operation.correct_expansion) {
    AXIOMETRY_TRY(test, correct_expansion(std::move(test)));
  }
  iso230_2::Assessment assessment = iso230_2::assess(test);
  AXIOMETRY_TRY(assessment.gum, iso230_2::gum(test, assessment.evaluation));
  return OperationOutcome{std::move(test), std::move(assessment)};
}

/// Reads a case from the top; each statement is a member of its name.
class CaseReader {
 public:
  explicit CaseReader(const LoadTest& load) : load_(load) {}

  Result<void> read(const Statement& s) {
    if (s.words.empty()) return {};
    const Word& verb = s.words.front();
    if (verb.is("title")) return title(s);
    if (verb.is("operation")) return operation(s);
    if (!operation_ && !model_) return unexpected_word(s, 0, "'operation iso230-2' or 'operation model' first");
    if (verb.is("expect")) return expect(s);
    if (model_) return model_->read(s);
    if (verb.is("tolerance")) return tolerance(s);
    if (operation_->outcome) return unexpected_word(s, 0, "'expect', or a new 'operation' before other data");
    if (verb.is("file")) return file(s);
    if (verb.is("set")) return set(s);
    if (verb.is("correct")) return correct(s);
    if (verb.is("targets")) return targets(s);
    if (verb.is("up")) return run(s, Direction::up);
    if (verb.is("down")) return run(s, Direction::down);
    const auto near = text::nearest(
        verb.text, {"title", "operation", "expect", "tolerance", "file", "set", "correct", "targets", "up", "down"});
    return unexpected_word(s, 0,
                           near ? fmt::format("perhaps '{}'", *near) : "a word that docs/conformance-cases.md lists");
  }

  Result<CheckReport> finish() && {
    if (report_.comparisons.empty()) return fail("found no expectation, expected at least one line 'expect …'");
    return std::move(report_);
  }

 private:
  Result<void> title(const Statement& s) {
    report_.title = text::trim(s.text.substr(s.words[0].text.size()));
    return {};
  }

  Result<void> operation(const Statement& s) {
    const bool model = s.words.size() > 1 && s.words[1].is("model");
    if (!model && !(s.words.size() > 1 && s.words[1].is("iso230-2"))) return unexpected_word(s, 1, "iso230-2 or model");
    if (s.words.size() > 2) return unexpected_word(s, 2, "the end of the line");
    operation_.reset();
    model_.reset();
    if (model)
      model_.emplace();
    else
      operation_.emplace();
    return {};
  }

  Result<void> file(const Statement& s) {
    if (!operation_->targets.empty() || operation_->file) return unexpected_word(s, 0, "one file, or targets and runs");
    const std::string_view name = text::trim(s.text.substr(s.words[0].text.size()));
    if (name.empty()) return unexpected_word(s, 1, "the name of a file");
    operation_->file = s.words[1].quoted ? s.words[1].text : name;
    return {};
  }

  Result<void> set(const Statement& s) {
    if (s.words.size() < 3 || !s.words[2].is("=")) return unexpected_word(s, 2, "'set KEY = VALUE'");
    const bool quoted = s.words.size() == 4 && s.words[3].quoted;
    const std::string_view value = quoted ? s.words[3].text : text::trim(s.text.substr(s.text.find('=') + 1));
    Metadata scratch;  // a slip is reported where it stands, before any data is looked at
    if (auto result = set_field_text(scratch, s.words[1].text, value); !result)
      return fail(result.error().message, s.words[1].at);
    operation_->settings.push_back({std::string(s.words[1].text), std::string(value)});
    return {};
  }

  Result<void> correct(const Statement& s) {
    if (s.words.size() != 2 || !s.words[1].is("expansion")) return unexpected_word(s, 1, "'correct expansion'");
    operation_->correct_expansion = true;
    return {};
  }

  Result<void> targets(const Statement& s) {
    if (!operation_->targets.empty() || operation_->file)
      return unexpected_word(s, 0, "one list of targets, or a file");
    if (s.words.size() < 3) return unexpected_word(s, s.words.size(), "positions and their unit");
    AXIOMETRY_TRY(operation_->kind, read_position_unit(s, s.words.size() - 1));
    for (std::size_t k = 1; k + 1 < s.words.size(); ++k) {
      AXIOMETRY_TRY(const double position, read_number(s, k));
      operation_->targets.push_back(Position::native(position));
    }
    return {};
  }

  Result<void> run(const Statement& s, Direction direction) {
    if (operation_->targets.empty()) return unexpected_word(s, 0, "'targets' before the runs");
    const std::size_t found = s.words.size() - 1;  // with the unit
    if (found != operation_->targets.size() + 1)
      return fail(fmt::format("found {} after '{}', expected {} readings (- where one is missing) and their unit",
                              counted(found, "value"), s.words[0].text, operation_->targets.size()),
                  s.at(1));
    AXIOMETRY_TRY(const formats::Unit* unit, read_deviation_unit(s, found, operation_->kind));
    std::size_t& runs = direction == Direction::up ? operation_->runs_up : operation_->runs_down;
    if (runs == read_budget::runs)
      return fail(fmt::format("found more than {} runs, expected fewer", read_budget::runs), s.at(0));
    for (std::size_t i = 0; i < operation_->targets.size(); ++i) {
      if (s.words[i + 1].is("-")) continue;
      AXIOMETRY_TRY(const double x, read_number(s, i + 1));
      operation_->readings.push_back({i, direction, runs, formats::deviation_in(*unit, x)});
    }
    ++runs;
    return {};
  }

  Result<void> tolerance(const Statement& s) {
    // A file tells the kind of its axis only when it is read.
    if (operation_->file && !operation_->outcome) operation_->outcome = carry_out(*operation_, load_);
    AXIOMETRY_TRY(operation_->tolerance, read_tolerance(s, 1, kind()));
    if (s.words.size() > 3) return unexpected_word(s, 3, "the end of the line");
    return {};
  }

  Result<void> expect(const Statement& s) {
    AXIOMETRY_TRY(CaseComparison comparison, model_ ? model_->expect(s) : expect_of_test(s));
    report_.comparisons.push_back(std::move(comparison));
    return {};
  }

  Result<CaseComparison> expect_of_test(const Statement& s) {
    if (!operation_->outcome) operation_->outcome = carry_out(*operation_, load_);
    return check_expectation(s, *operation_->outcome, {kind(), operation_->tolerance});
  }

  AxisKind kind() const {
    const auto& outcome = operation_->outcome;
    return outcome && *outcome ? (**outcome).test.metadata.axis.kind : operation_->kind;
  }

  const LoadTest& load_;
  CheckReport report_;
  std::optional<Operation> operation_;
  std::optional<ModelCase> model_;
};

}  // namespace

std::string to_string(const CaseComparison& c) {
  std::string text = fmt::format("line {}: {}: got {}, expected {}", c.line, c.expectation, c.got, c.expected);
  if (!c.difference.empty()) text += ", difference " + c.difference;
  return text;
}

std::vector<CaseComparison> CheckReport::failures() const {
  std::vector<CaseComparison> result;
  std::ranges::copy_if(comparisons, std::back_inserter(result), [](const CaseComparison& c) { return !c.met; });
  return result;
}

Result<CheckReport> check_case(std::string_view text, const LoadTest& load) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (const auto bad = text::invalid_utf8(text)) {
    const auto line = static_cast<std::size_t>(std::ranges::count(text.substr(0, *bad), '\n')) + 1;
    return fail("found a byte that is not UTF-8, expected plain text", {line, 0});
  }
  CaseReader reader(load);
  std::size_t number = 0;
  for (std::string_view line : text::split(text, '\n')) {
    AXIOMETRY_TRY(const Statement statement, read_statement(line, ++number));
    AXIOMETRY_TRY_VOID(reader.read(statement));
  }
  return std::move(reader).finish();
}

}  // namespace axiometry::app
