// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/tolerance_flags.h"

#include <vector>
#include "cli/flags/option_text.h"
#include "cli/flags/verb.h"

namespace axiometry::cli {

void add_tolerance_flags(const Verb& verb, app::ToleranceOptions& tolerance, std::string& table) {
  constexpr const char* group = "Tolerances, over what the file says";
  verb.add_option_function<std::vector<std::string>>(
          "--tolerance",
          [&](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              auto limit = app::parse_tolerance(text);
              if (!limit) throw UsageError("--tolerance", limit.error().message);
              tolerance.limits.push_back(*limit);
            }
            if (auto all = app::check_tolerances(tolerance.limits); !all)
              throw UsageError("--tolerance", all.error().message);
          },
          "Limit of a parameter, such as A=10um or R_up=0.003mm; exit code 3 when a test does not conform; may be "
          "repeated")
      ->type_name("PARAMETER=LIMIT")
      ->one_at_a_time()
      ->group(group);
  verb.add_option("--tolerance-table", table,
                  "Limits by the kind and travel of the axis from a CSV file, and which of the named tables in it; "
                  "without NAME the one that the test's file names, or the only one")
      ->check(fault_of_empty_name)
      ->type_name("FILE[:NAME]")
      ->group(group);
  verb.add_option_function<std::string>(
          "--rule",
          [&](const std::string& text) {
            auto rule = app::parse_rule(text);
            if (!rule) throw UsageError("--rule", rule.error().message);
            tolerance.rule = *rule;
          },
          "How the uncertainty counts: simple (not at all; when nothing is said), iso14253-1 (conforms where it keeps "
          "the limit "
          "with a probability of 95 % or more, does not where it exceeds it with 95 % or more, else undecided with "
          "exit code 4), or "
          "guard-band=WIDTH such as guard-band=3um (likewise with that width)")
      ->type_name("RULE")
      ->group(group);
}

}  // namespace axiometry::cli
