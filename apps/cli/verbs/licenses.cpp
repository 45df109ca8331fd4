// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include "cli/flags/verb.h"

#include "axiometry/base/text/text.h"
#include "cli/components.h"
#include "cli/text/terminal.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

constexpr std::string_view own_text = "LICENSE";

std::string_view text_of_license(std::string_view file) {
  const auto place = std::ranges::find(license_files(), file, &EmbeddedFile::name);
  return place == license_files().end() ? std::string_view() : place->bytes;
}

void list_components() {
  fmt::print("Axiometry is free software under the Apache License 2.0. It holds or needs what others wrote:\n\n");
  for (const Component& component : components())
    fmt::print("{}{}{}{}\n", left(component.name, 22), left(component.version, 10), left(component.use, 24),
               component.license);
  fmt::print("\n'axiometry licenses NAME' prints the licence of one that is in the program, 'all' every one.\n");
}

void print_all() {
  for (const EmbeddedFile& file : license_files())
    fmt::print("{}\n{}\n", file.name == own_text ? "Axiometry\n" : std::string(80, '-') + "\n", file.bytes);
}

}  // namespace

void add_licenses(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand("licenses", "List what others wrote in the program, and print its licences");
  auto name = std::make_shared<std::string>();
  verb->add_option("NAME", *name, "Whose licence is printed, 'axiometry', or 'all'");
  verb->callback([name, &exit_code] {
    exit_code = exit_done;
    if (name->empty()) return list_components();
    if (*name == "all") return print_all();
    if (text::equal_ignoring_case(*name, "axiometry")) return fmt::print("{}", text_of_license(own_text));
    const auto place = std::ranges::find_if(
        components(), [&](const Component& component) { return text::equal_ignoring_case(component.name, *name); });
    if (place == components().end())
      throw UsageError("NAME",
                       fmt::format("found {}, expected one that 'axiometry licenses' lists", text::quoted(*name)));
    if (place->text.empty())
      return fmt::print("{} is a shared library of the system under {}; nothing of it is in this program.\n",
                        place->name, place->license);
    fmt::print("{}", text_of_license(place->text));
  });
}

}  // namespace axiometry::cli
