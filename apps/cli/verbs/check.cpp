// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>
#include "cli/failure.h"
#include "cli/flags/verb.h"

#include "axiometry/app/cases/check.h"
#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/files/source.h"
#include "axiometry/base/counted.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

constexpr std::size_t case_limit = std::size_t{16} << 20;

Result<app::CheckReport> check_file(const std::string& name) {
  AXIOMETRY_TRY(app::Source source, app::Source::open(name));
  AXIOMETRY_TRY(const std::string text, source.read_all(case_limit));
  const auto folder = std::filesystem::path(name).parent_path();
  return app::check_case(text, [&](std::string_view file) { return app::read_test((folder / file).string()); });
}

/// Every expectation with what came, the second in a column.
void print_figures(const app::CheckReport& report) {
  std::size_t width = 0;
  for (const app::CaseComparison& c : report.comparisons) width = std::max(width, c.expectation.size());
  for (const app::CaseComparison& c : report.comparisons)
    fmt::print("  {:<{}}  {}{}\n", c.expectation, width, c.got, c.met ? "" : "  " + in_language_asked("NOT MET"));
}

int check(const std::vector<std::string>& names, bool figures) {
  std::size_t passed = 0;
  bool bad = false;
  for (const std::string& name : names) {
    auto report = check_file(name);
    if (!report) {
      Error error = report.error();
      if (error.file.empty()) error.file = name;
      tell(error);
      bad = true;
      continue;
    }
    passed += report->passed();
    for (const app::CaseComparison& failure : report->failures())
      fmt::print("{}: {}\n", name, in_language_asked(app::to_string(failure)));
    if (report->passed())
      fmt::print("{}: {}\n", name,
                 in_language_asked(fmt::format("{} met", counted(report->comparisons.size(), "expectation"))));
    if (figures) print_figures(*report);
  }
  fmt::print("{}\n", in_language_asked(fmt::format("{} passed, {} failed", passed, names.size() - passed)));
  return bad ? exit_bad_input : passed == names.size() ? exit_done : exit_exceeded;
}

}  // namespace

void add_check(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand("check", "Check conformance cases: readings and what they must give");
  auto names = std::make_shared<std::vector<std::string>>();
  verb->add_option("FILE.case", *names, "Cases (docs/conformance-cases.md)")->required();
  auto figures = std::make_shared<bool>(false);
  verb->add_flag("--figures", *figures, "Print what came for each expectation, met or not");
  verb->callback([names, figures, &exit_code] { exit_code = check(*names, *figures); });
}

}  // namespace axiometry::cli
