// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/store/compensations.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/compensate/compensate_options.h"
#include "axiometry/app/files/output.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/workbench/compensations/compensations.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/store/store.h"
#include "cli/failure.h"
#include "cli/flags/compensate_flags.h"
#include "cli/flags/option_text.h"
#include "cli/flags/store_flags.h"
#include "cli/text/flags_of_words.h"
#include "cli/text/terminal.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/store/store_report.h"

namespace axiometry::cli {
namespace {

using store::CompensationRecord;

struct CompensationArguments {
  std::string address;
  app::CompensateRequest request;
  std::string existing, out, notes, reason;
  std::int64_t test = 0, axis = 0, id = 0, retest = 0, limit = 50;
  std::int64_t version = 0;  // 0: the latest
  bool json = false, withdrawn = false, without_retest = false;
  bool has_version = false, has_retest = false;
  std::string report;
};

using SharedCompensation = std::shared_ptr<CompensationArguments>;

constexpr int id_most = 2'147'483'647;
constexpr const char* verb_name = "axiometry store compensate";

std::string figure_of(const CompensationRecord& c, const char* parameter, const char* state) {
  for (const store::KeptFigure& figure : c.figures)
    if (figure.parameter == parameter && figure.of == state) return format_fixed(figure.value, 1);
  return "–";
}

std::string_view unit_text(const CompensationRecord& c) {
  return !c.figures.empty() && c.figures[0].unit == "arcsec" ? "″" : "µm";
}

/// "E 21.3 µm → 4.2 µm predicted → 5.1 µm in test 7", and of a re-test that no longer counts why.
std::string course(const app::ListedCompensation& listed) {
  const CompensationRecord& c = listed.compensation.value;
  const std::string_view unit = unit_text(c);
  std::string text = in_language_asked(fmt::format("E {} {} → {} {} predicted", figure_of(c, "E", "before"), unit,
                                                   figure_of(c, "E", "predicted"), unit));
  const auto add = [&text](std::string_view before, const std::string& words) {
    text += std::string(before) + in_language_asked(words);
  };
  if (listed.retest_counts()) add(" → ", fmt::format("{} {} in test {}", figure_of(c, "E", "retest"), unit, *c.retest));
  if (listed.retest && !listed.retest_counts())
    add(", ", fmt::format("re-test {} {} since", *c.retest, listed.retest->withdrawn ? "withdrawn" : "revised"));
  if (listed.test.withdrawn || listed.test.revised)
    add(", ", fmt::format("test {} {}", c.test, listed.test.withdrawn ? "withdrawn since" : "has another version"));
  return text;
}

/// A re-test that shows what should not be, or a table that should be looked at.
int code_of(const app::ListedCompensation& listed, std::FILE* told) {
  if (listed.serious == 0) return exit_done;
  fmt::print(told, "{}: look at the report before the table is used\n",
             counted(static_cast<std::size_t>(listed.serious), "serious finding"));
  return exit_exceeded;
}

void check_version(const CompensationArguments& a) {
  if (a.has_version && a.version < 1)
    throw UsageError("--version", fmt::format("found {}, expected a number from 1", a.version));
}

/// Whatever is wrong with the wishes, before anything is changed.
void check_wishes(const CompensationArguments& a) {
  check_version(a);
  const bool changes = a.has_retest || a.without_retest;
  if (a.has_retest && a.retest < 1)
    throw UsageError("--retest", fmt::format("found {}, expected the number of a test", a.retest));
  if (changes && a.has_version) throw UsageError("--version", "found an old version to change, expected the latest");
  if (!changes && !a.reason.empty()) throw UsageError("--reason", "found a reason, expected a change beside it");
  if (a.json && a.out == "-") throw UsageError("--out", "found - beside --json, expected one of them in the pipe");
  check_report_name(a.report);
}

Result<int> keep(const CompensationArguments& a) {
  if (a.request.control.empty()) throw MissingOption("--for");
  check_version(a);
  app::NewCompensation wanted{a.test, {}, app::to_json(a.request), {}, a.notes};
  if (a.version > 0) wanted.version = static_cast<int>(a.version);
  if (!a.existing.empty()) {
    AXIOMETRY_TRY(std::string text, app::whole_file(a.existing));
    wanted.existing = app::NamedTable{std::filesystem::path(a.existing).filename().string(), std::move(text)};
  }
  AXIOMETRY_TRY(const auto archive, archive_at(a.address, {.create = false}));
  const app::Workbench workbench(*archive);
  AXIOMETRY_TRY(const auto kept, app::keep_compensation(workbench, wanted, {"import", verb_name}));
  const CompensationRecord& c = kept.head.compensation.value;
  std::FILE* const told = a.out == "-" ? stderr : stdout;  // the table alone goes into a pipe
  fmt::print(told, "compensation {}: {}\n", kept.head.compensation.id, report::printable(c.files[0].name));
  fmt::print(told, "{}\n", course(kept.head));
  std::fflush(told);  // what is said is kept, even if the file cannot be written
  if (!a.out.empty()) AXIOMETRY_TRY_VOID(app::write_file(a.out, kept.table));
  return code_of(kept.head, told);
}

Result<int> list_kept(const CompensationArguments& a) {
  AXIOMETRY_TRY(const auto archive, archive_at(a.address, {.create = false}));
  if (a.test > 0) AXIOMETRY_TRY_VOID(archive->test(a.test));
  if (a.axis > 0) AXIOMETRY_TRY_VOID(archive->get<store::AxisRecord>(a.axis));
  store::CompensationFilter filter{.withdrawn = a.withdrawn, .limit = a.limit};
  if (a.test > 0) filter.test = a.test;
  if (a.axis > 0) filter.axis = a.axis;
  AXIOMETRY_TRY(const auto listed, app::listed_compensations(*archive, filter));
  for (const app::ListedCompensation& line : listed) {
    const CompensationRecord& c = line.compensation.value;
    fmt::print("{} {} {} test {} {}{}\n", left(fmt::format("{}", line.compensation.id), 7),
               left(line.made_at.substr(0, 10), 11), left(c.control, 20), c.test, course(line),
               c.withdrawn ? " (withdrawn)" : "");
  }
  return exit_done;
}

void print_kept(const app::KeptCompensation& kept) {
  const app::ListedCompensation& head = kept.head;
  const CompensationRecord& c = head.compensation.value;
  fmt::print("{}\n", report::printable(c.files[0].name));
  const auto test_text = [](const app::TestOfCompensation& test) {
    return fmt::format("{} in version {}{}, {} {}{}", test.id, test.version,
                       test.latest > test.version ? fmt::format(" of {}", test.latest) : "", test.measured_on,
                       test.title, test.withdrawn ? " (withdrawn)" : "");
  };
  const std::pair<const char*, std::string> rows[] = {
      {"control", c.control},
      {"version", fmt::format("{} of {}", head.compensation.version, kept.versions.size())},
      {"machine", head.machine ? head.machine->value.name : ""},
      {"axis", head.axis ? head.axis->value.name : ""},
      {"test", test_text(head.test)},
      {"re-test", head.retest ? test_text(*head.retest) : ""},
      {"made by", c.program},
      {"options", c.options},
      {"withdrawn", c.withdrawn ? "yes" : ""},
      {"serious findings", head.serious > 0 ? fmt::format("{}", head.serious) : ""},
      {"notes", c.notes}};
  for (const auto& [name, text] : rows)
    if (!text.empty()) fmt::print("  {}{}\n", left(name, 18), report::printable(text));
  for (const store::KeptFile& file : c.files)
    fmt::print("  {}{} {}\n", left(file.role, 18), file.content.substr(0, 12), report::printable(file.name));
  fmt::print("  {}\n", course(head));
  for (const app::KeptFinding& finding : kept.findings)
    fmt::print("  {}: {}\n", finding.severity, report::printable(with_flags(finding.message, finding.message)));
}

Result<void> revise(const app::Workbench& workbench, const CompensationArguments& a) {
  AXIOMETRY_TRY(const auto latest, workbench.archive().get<CompensationRecord>(a.id));
  app::CompensationRevision revision;
  revision.base_version = latest.version;
  revision.reason = a.reason;
  revision.retest = a.without_retest ? std::optional<store::Id>() : std::optional(a.retest);
  AXIOMETRY_TRY_VOID(app::revise_compensation(
      workbench, a.id, revision, {"import", a.reason.empty() ? "axiometry store compensation" : a.reason}));
  return {};
}

Result<int> show(const CompensationArguments& a) {
  check_wishes(a);
  const bool changes = a.has_retest || a.without_retest;
  AXIOMETRY_TRY(const auto archive, archive_at(a.address, {.create = false}));
  const app::Workbench workbench(*archive);
  if (changes) AXIOMETRY_TRY_VOID(revise(workbench, a));
  const auto version = a.version > 0 ? std::optional(static_cast<int>(a.version)) : std::nullopt;
  AXIOMETRY_TRY(const auto kept, app::kept_compensation(*archive, a.id, version));
  AXIOMETRY_TRY_VOID(write_report(a.report, [&](const app::ReportRequest& request) {
    return app::compensation_report(workbench, a.id, version, request);
  }));
  if (!a.out.empty()) AXIOMETRY_TRY_VOID(app::write_file(a.out, kept.table));
  if (a.json)
    fmt::print("{}\n", json::dump(kept.result));
  else if (a.out.empty() && a.report.empty())
    print_kept(kept);
  return changes ? code_of(kept.head, a.out == "-" ? stderr : stdout) : exit_done;
}

void add_keep(const Verb& store, int& exit_code) {
  const auto made = std::make_shared<CompensationArguments>();
  Verb verb = store_verb(store, {"compensate", "Make the table by which a control corrects an axis, and keep it"},
                         exit_code, made, keep);
  verb->add_option("TEST", made->test, "Number of the test in the archive")->required();
  add_count(*verb, {"--version", "N", "Of that version of the test (the latest)"}, [made](unsigned long long n) {
    made->version = static_cast<std::int64_t>(n);
    made->has_version = true;
  });
  verb->add_option("--out", made->out, "The table to FILE, or to the standard output with -")
      ->check(fault_of_name)
      ->type_name("FILE");
  verb->add_option("--existing", made->existing, "The table that was active while the test was measured")
      ->type_name("FILE");
  verb->add_option("--notes", made->notes, "Notes");
  add_compensate_flags(*verb, made->request);
  add_measured_flags(*verb, made->request);
}

}  // namespace

void add_store_compensations(const Verb& store, int& exit_code) {
  add_keep(store, exit_code);
  auto made = std::make_shared<CompensationArguments>();
  Verb listed =
      store_verb(store, {"compensations", "List tables of compensation, the newest first"}, exit_code, made, list_kept);
  listed->add_option("--test", made->test, "Only those of that test, or proved by it")
      ->type_name("N")
      ->check_range(1, id_most);
  listed->add_option("--axis", made->axis, "Only those of that axis")->type_name("N")->check_range(1, id_most);
  listed->add_flag("--withdrawn", made->withdrawn, "Withdrawn ones, too");
  listed->add_option("--limit", made->limit, "How many (50)")->check_range(1, 1000);
  made = std::make_shared<CompensationArguments>();
  Verb shown = store_verb(store, {"compensation", "Show a table, link its re-test, or write table or report"},
                          exit_code, made, show);
  shown->add_option("N", made->id, "Its number")->required();
  add_count(*shown, {"--version", "N", "Of that version (the latest)"}, [made](unsigned long long n) {
    made->version = static_cast<std::int64_t>(n);
    made->has_version = true;
  });
  Flag retest = add_count(*shown,
                          {"--retest", "N",
                           "Number of the test that was measured with the table active: held against the prediction, "
                           "and linked"},
                          [made](unsigned long long n) {
                            made->retest = static_cast<std::int64_t>(n);
                            made->has_retest = true;
                          });
  shown->add_flag("--without-retest", made->without_retest, "Take the re-test away")->excludes(retest);
  shown->add_option("--reason", made->reason, "Why, for the audit trail");
  shown->add_flag("--json", made->json, "Print the result as it was kept, as JSON");
  shown->add_option("--out", made->out, "The table to FILE, or to the standard output with -")
      ->check(fault_of_name)
      ->type_name("FILE");
  shown->add_option("--report", made->report, "Report to FILE, by its extension html, pdf, svg, png or csv")
      ->type_name("FILE");
}

}  // namespace axiometry::cli
