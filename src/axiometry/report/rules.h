// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "axiometry/model/test.h"
#include "axiometry/report/document.h"
#include "axiometry/report/report.h"
#include "axiometry/standards/rules/comparison.h"

/// The report of one test by several rules: its rows as people read them, the whole document.
namespace axiometry::report {

struct RulesSubject {
  const Test& test;
  const standards::RuleComparison& comparison;
};

/// A figure of a rule as it is shown; texts are empty where there is nothing to say.
struct RuleRow {
  std::string title;              ///< "Positioning uncertainty"
  std::string symbol;             ///< as document.h's symbol() reads it: "P_s,max"
  std::string clause;             ///< clause of the rule
  std::string value;              ///< value in the native unit: "12.3"
  std::string share_of_travel;    ///< "0.0013 %", of figures that are stated so
  std::string interval;           ///< "10.1 to 11.2", after trials
  std::string no_interval;        ///< why there is none, after trials
  std::string absence;            ///< why there is no value
  std::string counterpart;        ///< symbol of the parameter of ISO 230-2:2014: "A"
  std::string counterpart_value;  ///< "9.6"
  std::string difference;         ///< difference of the unrounded values: "+2.7"
  std::string relative;           ///< "+28 %"
  std::string departs_by;         ///< what differs from the counterpart's formula
  std::string evidence_source;    ///< "second-hand"
  std::string evidence;           ///< "second-hand, not checked against the text of the rule"
};

/// One row for each figure of the rule. Values end where parameters of the test do; two significant digits at least.
std::vector<RuleRow> rule_rows(const standards::ComparedRule& rule, const standards::RuleComparison& comparison,
                               const Options& options);

/// Results, what must not be compared, how the formulas differ, findings, identification, provenance.
Document compose(const RulesSubject& subject, const Options& options);

}  // namespace axiometry::report
