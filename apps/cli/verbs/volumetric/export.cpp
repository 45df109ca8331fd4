// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "axiometry/app/files/output.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/app/volumetric/tables/export_tables.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "cli/failure.h"
#include "cli/flags/option_text.h"
#include "cli/flags/verb.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/serious_findings.h"
#include "cli/verbs/volumetric/volumetric.h"

namespace axiometry::cli {
namespace {

constexpr const char* volumetric_export_examples =
    R"(Every file says what a positive number does, and what of it is verified and what inferred. Try it on a machine
that may fail, and measure a line again: a doubled error is a sign that was taken the wrong way round.
Examples:
  axiometry volumetric export --list
  axiometry volumetric export result.json --for general-csv --out errors.csv
  axiometry volumetric export result.json --for axis-csv --tool T1 --out axes.csv)";

struct VolumetricExportArguments {
  app::ExportRequest request;
  std::string out = "-";
  bool list = false;
};

int list_tables() {
  for (const formats::Compensation* table : formats::compensation_table())
    fmt::print("{}: {} (takes {})\n{}\n", table->id, table->title, table->takes, table->manual);
  return exit_done;
}

int run(const VolumetricExportArguments& arguments) {
  if (arguments.list) return list_tables();
  if (arguments.request.result.empty()) throw MissingOption("RESULT");
  if (arguments.request.table.empty()) throw MissingOption("--for");
  const std::vector<app::InputFile> inputs = {{arguments.request.result, false}};
  if (const auto spared = app::InputFiles(inputs).check_spared(arguments.out); !spared)
    return failed(spared.error(), exit_usage);
  const auto table = app::exported_table(arguments.request);
  if (!table) return failed(table.error());
  if (const auto written = app::write_file(arguments.out, table->text); !written) return failed(written.error());
  tell_serious(table->against);
  return exit_code_of_findings(table->against);
}

}  // namespace

void add_volumetric_export(const Verb& volumetric, int& exit_code) {
  Verb verb = volumetric.add_subcommand("export", "Tables of the errors for controls");
  verb->footer(volumetric_export_examples);
  auto arguments = std::make_shared<VolumetricExportArguments>();
  verb->add_option("RESULT", arguments->request.result, "What identify wrote with --out");
  verb->add_flag("--list", arguments->list, "The tables that there are, and what each assumes");
  verb->add_option("--for", arguments->request.table, "One of --list")->type_name("NAME");
  verb->add_option("--out", arguments->out, "To FILE, or to the standard output with - (-)")
      ->check(fault_of_name)
      ->type_name("FILE");
  verb->add_option("--tool", arguments->request.tool, "Of tables of single axes: with which tool (the only one)")
      ->type_name("NAME");
  add_read(*verb, {"--nodes", "N", "Positions of each axis, 2 to 401 (21)"},
           [arguments](const std::string& text) -> Result<void> {
             const auto number = parse_number(text);
             if (!number || !(*number >= 2.0 && *number <= 401.0) ||
                 *number != static_cast<double>(static_cast<int>(*number)))
               return fail("found " + text::quoted(text) + ", expected a whole number from 2 to 401");
             arguments->request.nodes = static_cast<std::size_t>(*number);
             return {};
           });
  verb->callback([arguments, verb, &exit_code] {
    check_alone(*verb, "--list");
    exit_code = run(*arguments);
  });
}

}  // namespace axiometry::cli
