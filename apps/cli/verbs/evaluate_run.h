// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/results/outputs.h"
#include "cli/text/method_text.h"
#include "cli/text/terminal.h"

namespace axiometry::cli {

/// What the command line of evaluate and uncertainty says.
struct EvaluateArguments {
  std::vector<std::string> inputs;
  app::EvaluateOptions evaluate;
  app::CaptureOptions recording;  ///< when it names a plan, inputs are continuous recordings
  app::LogWithTest temperatures;  ///< log of the temperatures; no file where none was given
  app::OutputNames outputs;
  report::Options report;
  ColourChoice colour = ColourChoice::automatic;
  std::string tolerance_table;      ///< file, perhaps with ":name"
  Detail detail = Detail::summary;  ///< detail of the uncertainty in the terminal
  bool verify = false;              ///< whether each result gets a second opinion before it is shown or written
  bool quiet = false;
  bool keep_going = false;
};

/// Carries it out and gives the exit code. Ctrl-C ends running trials and leaves nothing half written.
int run_evaluation(EvaluateArguments& arguments);

}  // namespace axiometry::cli
