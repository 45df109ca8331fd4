// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include "cli/flags/verb.h"

#include "axiometry/app/tracking/tracker_list.h"
#include "cli/flags/experiment_flags.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/tracking/tracking.h"

namespace axiometry::cli {

void add_tracking_instruments(const Verb& tracking, int& exit_code) {
  Verb verb = tracking.add_subcommand("instruments",
                                      "The kinds of instruments that have a name, with what their makers stated");
  verb->footer(
      R"(A name stands for an uncertainty wherever --ranging or --instrument is asked for; NAME:adm and NAME:ifm take
its absolute lengths or its interferometer.
Examples:
  axiometry tracking instruments
  axiometry tracking locate points.csv --ranging leica-at901)");
  auto arguments = std::make_shared<ExperimentArguments>();
  add_experiment_flags(*verb, *arguments);
  verb->callback([arguments, &exit_code] {
    check_experiment_outputs(*arguments);
    exit_code = finish_experiment(app::tracker_list(arguments->report), *arguments);
  });
}

}  // namespace axiometry::cli
