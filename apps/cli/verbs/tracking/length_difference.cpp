// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include "cli/flags/verb.h"

#include "axiometry/app/files/number_list.h"
#include "axiometry/app/tracking/length_difference.h"
#include "cli/failure.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/tracking/length_difference_verb.h"
#include "cli/verbs/tracking/tracking.h"

namespace axiometry::cli {
namespace {

constexpr const char* tracking_length_difference_examples =
    R"(The station's error is determined − actual. Of distances, … goes on with the step of the two
numbers before it.
Examples:
  axiometry tracking length-difference --station-error 0.7978,0.2715,0.1965 --distances 10,20,…,1100
  axiometry tracking length-difference --station-error 0.05,0.05,0.1 --distances 200:1200:100 --direction 1,1,1
  axiometry tracking length-difference --distances 200:900:100 --station-uncertainty 0.003,0.003,0.01 --report d.pdf)";

struct TrackingLengthDifferenceArguments {
  app::LengthDifferenceRequest request;
  ExperimentArguments outputs;
};

void add_request(const Verb& verb, app::LengthDifferenceRequest& request) {
  const auto vector = [](const std::string& text, auto& target) -> Result<void> {
    AXIOMETRY_TRY(target, app::parse_vector(text));
    return {};
  };
  add_read(verb, {"--station-error", "X,Y,Z", "Error of the station, determined minus actual, mm (0,0,0)"},
           [&request, vector](const std::string& text) { return vector(text, request.station_error_mm); });
  Flag distances =
      add_read(verb, {"--distances", "LIST", "Distances from the station, mm: 10,20,…,1100 or 200:1100:100, ascending"},
               [&request](const std::string& text) -> Result<void> {
                 AXIOMETRY_TRY(request.distances_mm, app::parse_distances(text));
                 return {};
               });
  if (request.distances_mm.empty()) distances->required();
  add_number(verb, {"--reference", "MM", "The distance of which the differences are relative (the last)"},
             [&request](double mm) { request.reference_mm = mm; });
  add_read(verb, {"--direction", "X,Y,Z", "Direction of a further line, of any length"},
           [&request, vector](const std::string& text) { return vector(text, request.direction); });
  add_read(verb,
           {"--station-uncertainty", "X,Y,Z", "Standard uncertainty of the station, mm: bounds of the difference"},
           [&request, vector](const std::string& text) { return vector(text, request.station_uncertainty_mm); });
}

}  // namespace

void add_length_difference_verb(const Verb& parent, const std::string& description,
                                const app::LengthDifferenceRequest& defaults, int& exit_code) {
  Verb verb = parent.add_subcommand("length-difference", description);
  verb->footer(tracking_length_difference_examples);
  auto arguments = std::make_shared<TrackingLengthDifferenceArguments>();
  arguments->request = defaults;
  add_request(*verb, arguments->request);
  add_experiment_flags(*verb, arguments->outputs);
  verb->callback([arguments, &exit_code] {
    check_experiment_outputs(arguments->outputs);
    const auto result = app::compare_lengths(arguments->request);
    if (!result) {
      exit_code = failed(result.error(), exit_usage);
      return;
    }
    exit_code = finish_experiment(app::present(*result, arguments->outputs.report), arguments->outputs);
  });
}

void add_tracking_length_difference(const Verb& tracking, int& exit_code) {
  add_length_difference_verb(tracking, "What an error of the station does to lengths along lines", {}, exit_code);
}

}  // namespace axiometry::cli
