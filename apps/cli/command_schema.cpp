// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "axiometry/formats/plan_json.h"
#include "axiometry/formats/test_schema.h"
#include "commands.h"

namespace axiometry::cli {

void add_schema(CLI::App& program, int& exit_code) {
  CLI::App* verb = program.add_subcommand("schema", "Print the JSON Schema of the test format, or of plans");
  const auto of = std::make_shared<std::string>("test");
  verb->add_option("WHAT", *of, "test (what it is without) or plan")->check(CLI::IsMember({"test", "plan"}));
  verb->callback([&exit_code, of] {
    fmt::print("{}", *of == "plan" ? json::dump(formats::plan_schema()) + "\n" : formats::test_schema());
    exit_code = exit_done;
  });
}

}  // namespace axiometry::cli
