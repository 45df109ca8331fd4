// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/stop_flags.h"

#include "axiometry/app/recordings/stop_options.h"
#include "cli/flags/option_text.h"
#include "cli/flags/verb.h"

namespace axiometry::cli {
namespace {

void note_given(StopFlags& flags, std::string_view name) {
  if (name == app::stops_option)
    flags.given = true;
  else
    flags.beside = name;
}

void add_stop_flag(const Verb& group, StopFlags& flags, const app::CaptureOption& option) {
  add_read(group, {std::string(option.name), std::string(option.values), std::string(option.help)},
           [&flags, &option](const std::string& word) -> Result<void> {
             note_given(flags, option.name);
             return option.apply(word, flags.said);
           });
}

/// May be said more than once.
void add_equipment_flag(const Verb& group, StopFlags& flags, const app::CaptureOption& option) {
  group
      ->add_option_function<std::vector<std::string>>(
          std::string(option.name),
          [&flags, &option](const std::vector<std::string>& given) {
            note_given(flags, option.name);
            for (const std::string& part : given)
              if (const auto put = option.apply(part, flags.said); !put)
                throw UsageError(std::string(option.name), put.error().message);
          },
          std::string(option.help))
      ->type_name(std::string(option.values))
      ->one_at_a_time();
}

}  // namespace

void add_stop_flags(const Verb& verb, StopFlags& flags, std::string& keys) {
  Verb group = verb.add_option_group("Straightness, roll, pitch, yaw: readings that do not show where the axis stops");
  for (const app::CaptureOption& option : app::stop_options())
    if (option.name != app::equipment_option) add_stop_flag(group, flags, option);
  add_read(group, {"--keys", "FILE", "What was said at the stops of a finished recording: lines 12.5,take"},
           [&flags, &keys](const std::string& word) -> Result<void> {
             note_given(flags, "--keys");
             keys = word;
             return {};
           });
  for (const app::CaptureOption& option : app::stop_options())
    if (option.name == app::equipment_option) add_equipment_flag(group, flags, option);
}

void check_stop_flags(const StopFlags& flags, app::CaptureOptions& options) {
  if (!flags.given) {
    if (flags.beside.empty()) return;
    throw UsageError(flags.beside, "found without --stops, expected with it");
  }
  if (options.part) throw UsageError("--part", "found with --stops, expected a plan of one axis alone");
  options.motion = flags.said.motion;
}

}  // namespace axiometry::cli
