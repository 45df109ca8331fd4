// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "axiometry/formats/test_schema.h"
#include "commands.h"

namespace axiometry::cli {

void add_schema(CLI::App& program, int& exit_code) {
  CLI::App* verb = program.add_subcommand("schema", "Print the JSON Schema of the test format");
  verb->callback([&exit_code] {
    fmt::print("{}", formats::test_schema());
    exit_code = exit_done;
  });
}

}  // namespace axiometry::cli
