// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "axiometry/report/report.h"
#include "axiometry/report/writer.h"
#include "tests/support/series.h"

/// Tests with their assessment, ready for the writers of reports.
namespace axiometry::testing_support {

struct Reported {
  Test test;
  iso230_2::Assessment assessment;
  std::vector<iso230_2::Judgement> judgements;
  report::Options options;

  /// With the uncertainties that the assessment knows.
  void judge(const std::vector<iso230_2::Tolerance>& tolerances, const uncertainty::DecisionRule& rule = {}) {
    judgements = iso230_2::judge(
        assessment.evaluation.parameters, tolerances, rule,
        {iso230_2::uncertainties_of_record(assessment), {}, {}, {}, iso230_2::lower_bounds(assessment.evaluation)});
  }

  report::Subject subject() const { return {test, assessment, judgements}; }
  std::string written(std::string_view extension) const {
    return report::find_writer(extension)->write(subject(), options).value();
  }
};

inline Reported reported(Test test) {
  auto assessment = iso230_2::assess(test);
  return {std::move(test), std::move(assessment), {}, {}};
}

inline Reported reported_table2() { return reported(table2::complete_test()); }

/// The same readings, and nothing known about them.
inline Reported reported_without_metadata() { return reported({{}, table2::series(), {}}); }

inline iso230_2::Tolerance tolerance(std::string_view key, double limit) {
  for (const auto& parameter : iso230_2::parameters)
    if (parameter.key == key) return {&parameter, Deviation::native(limit)};
  throw std::logic_error("no such parameter");
}

}  // namespace axiometry::testing_support
