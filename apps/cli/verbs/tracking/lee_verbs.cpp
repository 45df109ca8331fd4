// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/tracking/lee_verbs.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>
#include "cli/flags/verb.h"

#include "axiometry/app/files/amount_text.h"
#include "axiometry/app/files/number_list.h"
#include "axiometry/app/simulate/tracked_machine_text.h"
#include "axiometry/app/studies/lee_reports.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "cli/failure.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/verbs/tracking/length_difference_verb.h"

namespace axiometry::cli {
namespace {

namespace lee = app::lee;

Result<void> put_vector(const std::string& text, Vector3& target) {
  AXIOMETRY_TRY(target, app::parse_vector(text));
  return {};
}

Result<void> put_relative(const std::string& text, RelativeLength& target) {
  AXIOMETRY_TRY(target, app::parse_relative(text));
  return {};
}

void add_noise(const Verb& verb, Length& noise, std::uint64_t& seed) {
  add_read(verb, {"--noise", "SIZE", "Standard deviation of a length: 1um (none)"},
           [&noise](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(const Deviation d, app::parse_deviation(text, AxisKind::linear));
             noise = Length::um(d.in_native());
             return {};
           });
  add_seed(verb, "Seed of the noise (1)", [&seed](unsigned long long n) { seed = n; });
}

/// Points that are given take the place of those there are.
struct Points {
  std::vector<Vector3> given;
  void put(std::vector<Vector3>& points) const {
    if (!given.empty()) points = given;
  }
};

void add_set(const Verb& verb, lee::Set& set, Points& points) {
  add_read(verb, {"--station", "X,Y,Z", "True station, mm (653.60,-27.13,262.18)"},
           [&set](const std::string& text) { return put_vector(text, set.station_mm); });
  add_read(verb, {"--point", "X,Y,Z", "A point of the station location, mm; repeated (six about the station)"},
           [&points](const std::string& text) { return put_vector(text, points.given.emplace_back()); })
      ->take_all()
      ->trigger_on_parse();
  add_noise(verb, set.noise, set.seed);
}

/// Where a scale has its origin.
Result<void> put_place(const std::string& text, Vector3 station_mm, Vector3& target) {
  if (text == "home" || text == "station") {
    target = text == "home" ? Vector3{} : station_mm;
    return {};
  }
  if (const auto place = app::parse_vector(text)) {
    target = *place;
    return {};
  }
  return fail(fmt::format("found the place {}, expected home, station or X,Y,Z", text::quoted(text)));
}

/// Runs `compute` when the verb is given.
template <typename Compute>
void on_call(const Verb& verb, const std::shared_ptr<ExperimentArguments>& outputs, int& exit_code, Compute compute) {
  add_experiment_flags(verb, *outputs);
  verb.callback([outputs, &exit_code, compute] {
    check_experiment_outputs(*outputs);
    Result<app::Experiment> experiment = compute(outputs->report);
    exit_code = experiment ? finish_experiment(*experiment, *outputs) : failed(experiment.error());
  });
}

void add_coordinate_offset(const Verb& simulate, int& exit_code) {
  struct Arguments {
    lee::Set set;
    Points points;
    double offset_mm = 1.0;
  };
  Verb verb = simulate.add_subcommand("coordinate-offset", "2.2, Table 2: all points displaced by the same amount");
  auto a = std::make_shared<Arguments>();
  add_set(*verb, a->set, a->points);
  add_number(*verb, {"--offset", "MM", "Offset of the axes, mm (1)"}, [a](double mm) { a->offset_mm = mm; });
  on_call(*verb, std::make_shared<ExperimentArguments>(), exit_code,
          [a](const report::Options& options) -> Result<app::Experiment> {
            a->points.put(a->set.points_mm);
            AXIOMETRY_TRY(const auto result, lee::coordinate_offset(a->set, a->offset_mm));
            return lee::present(result, options);
          });
}

void add_proportional_error(const Verb& simulate, int& exit_code) {
  struct Arguments {
    std::string fixture = "all";
    lee::Set set;
    Points points;
    double error = 1e-3;
    std::string about = "station";
    std::string estimator = "eq14";
  };
  Verb verb = simulate.add_subcommand("proportional-error", "2.3, Table 3: a scale error of one or two axes");
  verb->footer(
      "The paper prints neither its points nor where its scale has its origin. F1 to F5 are points for which its "
      "table\n"
      "comes out within its scatter (docs/studies/lee-proportional-error.md); with --point it is computed for others.");
  auto a = std::make_shared<Arguments>();
  add_set(*verb, a->set, a->points);
  verb->add_option("--fixture", a->fixture, "F1 to F5, or all (all)")->type_name("NAME");
  add_read(*verb, {"--error", "ERROR", "With --point: the scale error, 0.1% or 1e-3 (1e-3)"},
           [a](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(const RelativeLength e, app::parse_relative(text));
             a->error = e.in_um_per_m() * 1e-6;
             return {};
           });
  verb->add_option("--about", a->about, "With --point: origin of the scale: station, home or X,Y,Z (station)")
      ->type_name("PLACE");
  verb->add_option("--estimator", a->estimator, "With --point: eq14 or refined, to be compared with the print (eq14)")
      ->check_among({"eq14", "refined"})
      ->type_name("NAME");
  on_call(*verb, std::make_shared<ExperimentArguments>(), exit_code,
          [a](const report::Options& options) -> Result<app::Experiment> {
            std::vector<lee::Fixture> chosen;
            if (!a->points.given.empty()) {
              lee::Fixture given{"given", a->error, a->set.station_mm, {}, a->estimator == "refined", a->points.given};
              AXIOMETRY_TRY_VOID(put_place(a->about, a->set.station_mm, given.origin_mm));
              chosen.push_back(given);
            } else {
              for (const lee::Fixture& f : lee::fixtures())
                if (a->fixture == "all" || text::equal_ignoring_case(a->fixture, f.name)) chosen.push_back(f);
              if (chosen.empty())
                return fail(fmt::format("found the fixture {}, expected F1 to F5 or all", text::quoted(a->fixture)));
            }
            std::vector<lee::ProportionalError> results;
            for (const lee::Fixture& f : chosen) {
              AXIOMETRY_TRY(auto result, lee::proportional_error(f, a->set.noise, a->set.seed));
              results.push_back(std::move(result));
            }
            return lee::present(results, options);
          });
}

void add_slope(const Verb& simulate, int& exit_code) {
  struct Arguments {
    lee::SlopeRequest request;
    Points points;
    std::string about = "home";
  };
  Verb verb = simulate.add_subcommand("slope", "2.4, Fig. 6: the slope of seven lines before and after a scale error");
  auto a = std::make_shared<Arguments>();
  lee::SlopeRequest& r = a->request;
  add_set(*verb, r.set, a->points);
  add_read(*verb, {"--axis", "AXIS", "Axis with the error (y)"}, [&r](const std::string& text) -> Result<void> {
    AXIOMETRY_TRY(r.axis, app::parse_axis(text));
    return {};
  });
  add_read(*verb, {"--base", "ERROR", "Its scale error before (-30um/m)"},
           [&r](const std::string& text) { return put_relative(text, r.base); });
  add_read(*verb, {"--added", "ERROR", "What is added to it (100um/m)"},
           [&r](const std::string& text) { return put_relative(text, r.added); });
  verb->add_option("--about", a->about, "Origin of the scale: home, station or X,Y,Z (home)")->type_name("PLACE");
  add_read(*verb, {"--offset", "X,Y,Z", "Constant displacement that comes with it, mm (0,0,0)"},
           [&r](const std::string& text) { return put_vector(text, r.offset_mm); });
  add_read(*verb, {"--distances", "LIST", "Of the targets from the station, mm (300:1100:100)"},
           [&r](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(r.distances_mm, app::parse_distances(text));
             return {};
           });
  on_call(*verb, std::make_shared<ExperimentArguments>(), exit_code,
          [a](const report::Options& options) -> Result<app::Experiment> {
            a->points.put(a->request.set.points_mm);
            AXIOMETRY_TRY_VOID(put_place(a->about, a->request.set.station_mm, a->request.origin_mm));
            AXIOMETRY_TRY(const auto result, lee::slopes(a->request));
            return lee::present(result, options);
          });
}

}  // namespace

void add_lee_verbs(const Verb& simulate, int& exit_code) {
  add_coordinate_offset(simulate, exit_code);
  add_proportional_error(simulate, exit_code);
  add_slope(simulate, exit_code);
  const app::LengthDifferenceRequest paper{
      .station_error_mm = {0.7978, 0.2715, 0.1965},
      .distances_mm = *app::parse_distances("10:100:10,200:1100:100"),
  };
  add_length_difference_verb(simulate, "4.1, Figs 11 to 13: what an error of the station does to lengths", paper,
                             exit_code);
}

}  // namespace axiometry::cli
