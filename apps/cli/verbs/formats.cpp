// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>
#include "cli/flags/verb.h"

#include "axiometry/formats/format.h"
#include "axiometry/formats/recording.h"
#include "axiometry/model/fields.h"
#include "cli/text/terminal.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

void list_formats() {
  for (const formats::Format* format : formats::format_table())
    fmt::print("{}{}  {}\n", left(format->id, 17), left(format->extensions, 16), format->title);
  fmt::print("\nContinuous recordings, for 'axiometry capture' and evaluate --plan:\n");
  for (const formats::Recording* recording : formats::recording_table())
    fmt::print("{}{}  {}\n", left(recording->id, 17), left(recording->extensions, 16), recording->title);
  fmt::print(
      "\n'axiometry formats ID' explains one; 'axiometry formats metadata' lists the keys of `# key: value` lines.\n");
}

std::string unit_text(const Field& field) {
  if (field.unit_linear == field.unit_rotary || field.unit_rotary.empty()) return std::string(field.unit_linear);
  return fmt::format("{} or {}", field.unit_linear, field.unit_rotary);
}

void list_metadata() {
  for (const Field& field : metadata_fields()) {
    std::string value = unit_text(field);
    if (field.type == FieldType::choice) value = fmt::format("{}", fmt::join(field.choices, "|"));
    if (field.type == FieldType::boolean) value = "yes|no";
    for (const RecordColumn& column : field.columns) value += (value.empty() ? "" : " | ") + std::string(column.key);
    fmt::print("{}\n    {}{}\n", value.empty() ? std::string(field.key) : left(field.key, 48) + value,
               field.description, field.clause.empty() ? "" : fmt::format(" ({})", field.clause));
  }
}

}  // namespace

void add_formats(const Verb& program, int& exit_code) {
  Verb verb =
      program.add_subcommand("formats", "List the formats of files and recordings that are read, or explain one");
  auto id = std::make_shared<std::string>();
  verb->add_option("ID", *id, "Format or recording to explain, or 'metadata'");
  verb->callback([id, &exit_code] {
    if (id->empty()) return list_formats();
    if (*id == "metadata") return list_metadata();
    const formats::Format* format = formats::find_format(*id);
    const formats::Recording* recording = formats::find_recording(*id);
    if (format == nullptr && recording == nullptr)
      throw UsageError(
          "ID", fmt::format("found the unknown format \"{}\", expected one that 'axiometry formats' lists", *id));
    fmt::print("{}\n", format != nullptr ? format->manual : recording->manual);
    exit_code = exit_done;
  });
}

}  // namespace axiometry::cli
