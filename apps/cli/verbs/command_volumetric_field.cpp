// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>

#include "axiometry/app/files/output.h"
#include "axiometry/app/volumetric/field_points.h"
#include "cli/failure.h"
#include "cli/flags/option_text.h"
#include "cli/flags/verb.h"
#include "cli/verbs/command_volumetric.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

constexpr const char* examples =
    R"(Points are a table with the columns tool, x_mm, y_mm, z_mm: where the axes stand.
Examples:
  axiometry volumetric field result.json --at points.csv --json -)";

struct Arguments {
  app::FieldRequest request;
  std::string json = "-";
};

int run(const Arguments& arguments) {
  const auto field = app::field_at_points(arguments.request);
  if (!field) return failed(field.error());
  const auto written = app::write_file(arguments.json, json::dump(*field) + "\n");
  return written ? exit_done : failed(written.error());
}

}  // namespace

void add_volumetric_field(const Verb& volumetric, int& exit_code) {
  Verb verb = volumetric.add_subcommand("field", "The error of the tool point, with its covariance, at given places");
  verb->footer(examples);
  auto arguments = std::make_shared<Arguments>();
  verb->add_option("RESULT", arguments->request.result, "What identify wrote with --out")->required();
  verb->add_option("--at", arguments->request.points, "Places as CSV, or - for the standard input")
      ->type_name("FILE")
      ->required();
  verb->add_option("--json", arguments->json, "As JSON to FILE, or to the standard output with - (-)")
      ->check(fault_of_name)
      ->type_name("FILE");
  verb->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace axiometry::cli
