// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>
#include "cli/flags/verb.h"

#include "axiometry/app/files/number_list.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/tracking/compare_methods.h"
#include "axiometry/app/tracking/tracking_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/tracking/ranges_csv.h"
#include "cli/failure.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/tracking/tracking.h"

namespace axiometry::cli {
namespace {

constexpr const char* compare_methods_examples =
    R"(Points are those of --points, or a grid in --travel. Every station sees every point. Lengths alone need
four stations or more, up to five of them not on one plane.
Examples:
  axiometry tracking compare-methods --travel X=0:800,Y=0:600,Z=0:500 --station -600,-500,100 \
    --station 1400,-400,0 --station 1300,1100,700 --station -500,1000,200
  axiometry tracking compare-methods --points p.csv --station -600,-500,100 --instrument faro-ion --trials 5000)";

struct CompareMethodsArguments {
  app::CompareMethodsRequest request;
  std::string points;
  std::optional<TravelBox> travel;
  unsigned long long per_axis = 3;
  std::string instrument = "leica-at901", ranging = "etalon-lasertracer";
  ExperimentArguments outputs;
};

void put_grid(const TravelBox& box, std::size_t per_axis, app::CompareMethodsRequest& request) {
  const auto at = [&](std::size_t axis, std::size_t k) {
    const double share = static_cast<double>(k) / static_cast<double>(per_axis - 1);
    return box.lowest_mm[axis] + share * (box.highest_mm[axis] - box.lowest_mm[axis]);
  };
  for (std::size_t i = 0; i < per_axis; ++i)
    for (std::size_t j = 0; j < per_axis; ++j)
      for (std::size_t k = 0; k < per_axis; ++k) {
        request.points_mm.push_back({at(0, i), at(1, j), at(2, k)});
        request.point_names.push_back(fmt::format("{}", request.points_mm.size()));
      }
}

Result<void> take_points(CompareMethodsArguments& arguments) {
  if (arguments.travel) {
    put_grid(*arguments.travel, arguments.per_axis, arguments.request);
    return {};
  }
  AXIOMETRY_TRY(const std::string bytes, app::file_bytes(arguments.points));
  AXIOMETRY_TRY(formats::NamedPoints named, app::in_file(formats::read_named_points(bytes), arguments.points));
  arguments.request.points_mm = std::move(named.at_mm);
  arguments.request.point_names = std::move(named.names);
  return {};
}

Result<void> take_instruments(CompareMethodsArguments& arguments) {
  app::CompareMethodsRequest& request = arguments.request;
  AXIOMETRY_TRY(const auto polar, tracking::find_tracker(arguments.instrument, tracking::LengthMode::absolute));
  AXIOMETRY_TRY(const auto alone, tracking::find_tracker(arguments.instrument, tracking::LengthMode::changes));
  if (!polar || !alone)
    return fail(fmt::format("found the instrument {}, expected one of those that axiometry tracking instruments lists",
                            text::quoted(arguments.instrument)));
  request.polar = *polar;
  if (alone->length) request.polar_changes = alone->length->expanded_uncertainty();
  AXIOMETRY_TRY(request.ranging, app::parse_ranging(arguments.ranging));
  if (!(request.ranging.standard_mm(1000.0) > 0.0))
    return fail("found an uncertainty of lengths of 0, expected one above 0");
  request.ranging_name = arguments.ranging;
  return {};
}

int run_compare_methods(CompareMethodsArguments& arguments) {
  if (const auto taken = take_instruments(arguments); !taken) return failed(taken.error(), exit_usage);
  std::vector<app::InputFile> inputs;
  if (!arguments.points.empty()) inputs.push_back({arguments.points, false});
  arguments.outputs.outputs.inputs = app::InputFiles(inputs);
  if (const auto spared = app::check_inputs_spared(arguments.outputs.outputs); !spared)
    return failed(spared.error(), exit_usage);
  if (const auto taken = take_points(arguments); !taken) return failed(taken.error());
  const auto compared = app::compare_methods(arguments.request);
  if (!compared) return failed(compared.error());
  return finish_experiment(app::present(*compared, arguments.outputs.report), arguments.outputs);
}

}  // namespace

void add_tracking_compare_methods(const Verb& tracking, int& exit_code) {
  Verb verb = tracking.add_subcommand(
      "compare-methods",
      "How well the same points are known by lengths and angles, and by lengths of several stations");
  verb->footer(compare_methods_examples);
  auto arguments = std::make_shared<CompareMethodsArguments>();
  Flag points =
      verb->add_option("--points", arguments->points, "Points as CSV: point,x_mm,y_mm,z_mm")->type_name("FILE");
  add_read(*verb, {"--travel", "BOX", "A box with a grid of points: X=0:800,Y=0:600,Z=0:500"},
           [arguments](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(arguments->travel, app::parse_travel_box(text));
             return {};
           })
      ->excludes(points);
  Flag per_axis = add_count(*verb, {"--per-axis", "N", "Points of the grid along each axis, 2 to 10 (3)"},
                            [arguments](unsigned long long n) { arguments->per_axis = n; });
  add_read(*verb, {"--station", "X,Y,Z", "Where an instrument stands, mm; repeated"},
           [arguments](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(const Vector3 at, app::parse_vector(text));
             arguments->request.stations_mm.push_back(at);
             return {};
           })
      ->take_all()
      ->trigger_on_parse()
      ->required();
  verb->add_option("--instrument", arguments->instrument, "Kind that gives lengths and angles (leica-at901)")
      ->type_name("NAME");
  verb->add_option("--ranging", arguments->ranging,
                   "Lengths of the other: expanded uncertainty a + b L, or a kind's name (etalon-lasertracer)")
      ->type_name("U");
  add_count(*verb, {"--trials", "N", "Simulated measurements by each method, 100 to 100000 (1000)"},
            [arguments](unsigned long long n) {
              if (n < 100 || n > 100'000)
                throw UsageError("--trials", fmt::format("found {}, expected 100 to 100000", n));
              arguments->request.trials = n;
            });
  add_seed(*verb, "Seed of the trials (1)", [arguments](unsigned long long n) { arguments->request.seed = n; });
  add_experiment_flags(*verb, arguments->outputs);
  verb->callback([arguments, per_axis, &exit_code] {
    check_experiment_outputs(arguments->outputs);
    if (arguments->points.empty() && !arguments->travel) throw MissingOption("--points or --travel");
    if (per_axis.count() > 0 && !arguments->travel)
      throw UsageError("--per-axis", "found it without --travel, expected both");
    if (arguments->per_axis < 2 || arguments->per_axis > 10)
      throw UsageError("--per-axis", fmt::format("found {}, expected 2 to 10", arguments->per_axis));
    exit_code = run_compare_methods(*arguments);
  });
}

}  // namespace axiometry::cli
