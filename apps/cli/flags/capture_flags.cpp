// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/capture_flags.h"

#include <string>
#include "cli/flags/verb.h"

#include "axiometry/app/recordings/capture_text.h"
#include "axiometry/app/recordings/recording_members.h"

namespace axiometry::cli {
namespace {

void apply(const app::CaptureOption& option, const std::string& text, app::CaptureOptions& options) {
  if (const auto done = option.apply(text, options); !done)
    throw UsageError(std::string(option.name), done.error().message);
  options.stated = option.name;
}

void add_option_flag(const Verb& group, const app::CaptureOption& option, app::CaptureOptions& options) {
  const std::string name(option.name);
  const std::string help(option.help);
  if (option.values.empty())
    group.add_flag_callback(
        name, [&option, &options] { apply(option, "1", options); }, help);
  else
    group
        .add_option_function<std::string>(
            name, [&option, &options](const std::string& text) { apply(option, text, options); }, help)
        ->type_name(std::string(option.values));
}

}  // namespace

void add_capture_flags(const Verb& verb, app::CaptureOptions& options) {
  Verb group = verb.add_option_group("Continuous recordings");
  group->add_option("--plan", options.plan, "The plan the axis moved after (see 'axiometry plan')")->type_name("FILE");
  for (const app::CaptureOption& option : app::capture_options()) add_option_flag(*group, option, options);
  group->get_option("--zero")->excludes(group->get_option("--datum"));
}

void add_length_recording_flags(const Verb& verb, app::CaptureOptions& options) {
  Verb group = verb.add_option_group("Continuous recordings");
  for (const app::CaptureOption& option : app::capture_options())
    if (app::is_of_lengths(option.name.substr(2))) add_option_flag(*group, option, options);
}

void check_capture_flags(const Verb& verb) {
  if (verb.count("--plan") > 0) return;
  for (const app::CaptureOption& option : app::capture_options()) {
    const std::string name(option.name);
    if (verb.count(name) > 0)
      throw UsageError(name, "found without --plan, expected with a continuous recording and its plan");
  }
}

}  // namespace axiometry::cli
