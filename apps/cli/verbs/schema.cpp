// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>
#include "cli/flags/verb.h"

#include "axiometry/base/json/json.h"
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/formats/plan/tracking_plan_json.h"
#include "axiometry/formats/table/import_profile.h"
#include "axiometry/formats/test/test_schema.h"
#include "axiometry/formats/tracking/station_json.h"
#include "axiometry/formats/volumetric/machine_json.h"
#include "axiometry/formats/volumetric/volumetric_plan_json.h"
#include "axiometry/formats/volumetric/volumetric_result_json.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

struct Schema {
  std::string_view name;
  std::string (*text)();
};

constexpr Schema schemas[] = {
    {"test", formats::test_schema},
    {"plan", [] { return json::dump(formats::plan_schema()) + "\n"; }},
    {"station", [] { return json::dump(formats::station_schema()) + "\n"; }},
    {"tracking-plan", [] { return json::dump(formats::tracking_plan_schema()) + "\n"; }},
    {"machine", [] { return json::dump(formats::machine_schema()) + "\n"; }},
    {"volumetric-result", [] { return json::dump(formats::volumetric_result_schema()) + "\n"; }},
    {"volumetric-plan", [] { return json::dump(formats::volumetric_plan_schema()) + "\n"; }},
    {"import-profile", formats::profile_schema},
};

}  // namespace

void add_schema(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand("schema", "Print the JSON Schema of tests or of another JSON file");
  auto name = std::make_shared<std::string>("test");
  std::vector<std::string_view> names;
  for (const Schema& schema : schemas) names.push_back(schema.name);
  verb->add_option("NAME", *name, fmt::format("What it describes: {} (test)", fmt::join(names, ", ")));
  verb->callback([name, names, &exit_code] {
    const auto schema = std::ranges::find(schemas, std::string_view(*name), &Schema::name);
    if (schema == std::end(schemas))
      throw UsageError("NAME", fmt::format("found \"{}\", expected one of {}", *name, fmt::join(names, ", ")));
    fmt::print("{}", schema->text());
    exit_code = exit_done;
  });
}

}  // namespace axiometry::cli
