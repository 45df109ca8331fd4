// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lengths/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/unit_sizes.h"
#include "axiometry/model/aligned.h"
#include "axiometry/numeric/median.h"
#include "axiometry/standards/iso230_2/parameters.h"
#include "axiometry/tracking/geometry/line_geometry.h"
#include "axiometry/tracking/lengths/beam_breaks.h"
#include "axiometry/tracking/lengths/dead_paths.h"
#include "axiometry/tracking/lengths/line_slope.h"
#include "axiometry/tracking/lengths/reading_name.h"
#include "axiometry/tracking/lines/line_metadata.h"

namespace axiometry::tracking {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
constexpr double beyond_machines_mm = 1.0;  // no machine stands that far from where its scale puts it
constexpr double oblique_deg = 1.0;         // a straightness error of 10 µm then counts with 0.2 µm

/// The way of one line from lengths to deviations.
class Course {
 public:
  Course(const LineInput& input, LineGeometry geometry) : in_(input), geometry_(std::move(geometry)) {
    for (const LengthReading& r : in_.readings) {
      const double shown = in_.options.reversed ? -r.length_difference_mm : r.length_difference_mm;
      excess_mm_.push_back(shown - geometry_.distances_mm[r.approach.target]);
    }
  }

  Result<LineOutcome> run() {
    find_breaks();
    fit();
    AXIOMETRY_TRY_VOID(check_deviations());
    AXIOMETRY_TRY(Test test, make_test());
    LineOutcome outcome{
        EvaluatedLine{in_.line.id, std::move(test), {}, {}, {}, 0.0, 0.0, 0.0, 0.0, {}, {}}, geometry_.direction, {}};
    describe(outcome.line);
    tell_jumps(outcome);
    tell_dead_paths(outcome);
    tell_lone_readings(outcome);
    tell_angle(outcome);
    return outcome;
  }

 private:
  const LengthReading& reading(std::size_t k) const { return in_.readings[k]; }
  double cosine(std::size_t k) const { return geometry_.cosines[reading(k).approach.target]; }

  void find_breaks() {
    if (in_.options.find_breaks) {
      const double sign = geometry_.cosines.front() < 0.0 ? -1.0 : 1.0;
      std::vector<LineSample> samples;
      for (std::size_t k = 0; k < in_.readings.size(); ++k)
        samples.push_back(
            {reading(k).approach.target, reading(k).approach.direction, sign * excess_mm_[k], reading(k).segment});
      jumps_ = find_jumps(samples, in_.line.plan.targets, in_.options.break_threshold_mm);
      for (auto* list : {&jumps_.breaks, &jumps_.outliers})
        for (Jump& jump : *list) jump.size_mm *= sign;
    }
    number_stretches();
  }

  /// Readings of one stated segment between two breaks that were found have one dead path.
  void number_stretches() {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> numbers;
    std::map<std::size_t, std::size_t> breaks_in;  // number of breaks found so far in each stated segment
    auto next = jumps_.breaks.begin();
    for (std::size_t k = 0; k < in_.readings.size(); ++k) {
      const std::size_t segment = reading(k).segment;
      if (next != jumps_.breaks.end() && next->before == k) ++breaks_in[segment], ++next;
      stretch_.push_back(numbers.emplace(std::pair{segment, breaks_in[segment]}, numbers.size()).first->second);
    }
    stretches_ = numbers.size();
  }

  bool is_outlier(std::size_t k) const {
    return std::ranges::any_of(jumps_.outliers, [&](const Jump& j) { return j.before == k; });
  }

  void fit() {
    std::vector<TiedSample> samples;
    for (std::size_t k = 0; k < in_.readings.size(); ++k)
      samples.push_back({reading(k).approach.target, reading(k).approach.direction, excess_mm_[k], cosine(k),
                         stretch_[k], !is_outlier(k)});
    fit_ = fit_dead_paths(samples, in_.line.plan.targets, stretches_);
    dead_path_mm_ = first_target_level();
  }

  /// c of the first stretch, so that the mean deviation of the first target is 0; without outliers where that leaves
  /// something.
  double first_target_level() const {
    std::size_t first = reading(0).approach.target;
    for (const LengthReading& r : in_.readings) first = std::min(first, r.approach.target);
    for (const bool all : {false, true}) {
      double sum[2] = {0.0, 0.0}, count[2] = {0.0, 0.0};
      for (std::size_t k = 0; k < in_.readings.size(); ++k) {
        if (reading(k).approach.target != first || (!all && is_outlier(k))) continue;
        const auto d = static_cast<std::size_t>(reading(k).approach.direction);
        sum[d] += excess_mm_[k] - fit_.stretches[stretch_[k]].shift_mm;
        count[d] += 1.0;
      }
      double level = 0.0, directions = 0.0;
      for (std::size_t d = 0; d < 2; ++d)
        if (count[d] > 0.0) level += sum[d] / count[d], directions += 1.0;
      if (directions > 0.0) return level / directions;
    }
    return 0.0;
  }

  /// What neither breaks nor single bad readings explain is no machine's: lengths in disorder raise the threshold of
  /// breaks above themselves. Judged against the straight line through the medians, which a scale is.
  Result<void> check_deviations() const {
    if (!in_.options.find_breaks) return {};
    const auto& targets = in_.line.plan.targets;
    std::vector<std::size_t> used;
    for (std::size_t k = 0; k < in_.readings.size(); ++k)
      if (!is_outlier(k)) used.push_back(k);
    const auto position = [&](std::size_t k) { return targets[reading(k).approach.target].in_native(); };
    const auto mm = [&](std::size_t k) { return deviation_um(k, fit_.stretches[stretch_[k]].shift_mm) / um_per_mm; };
    std::vector<double> slopes;
    for (std::size_t i = 1; i < used.size(); ++i)
      if (const double way = position(used[i]) - position(used[i - 1]); way != 0.0)
        slopes.push_back((mm(used[i]) - mm(used[i - 1])) / way);
    if (slopes.empty()) return {};
    const double slope = numeric::upper_median(std::move(slopes));
    std::vector<double> left;
    for (const std::size_t k : used) left.push_back(mm(k) - slope * position(k));
    const double level = numeric::upper_median(left);
    const auto off = [&](double x) { return std::abs(x - level); };
    const auto worst = std::ranges::max_element(left, {}, off) - left.begin();
    const double limit = std::max(beyond_machines_mm, in_.options.break_threshold_mm.value_or(0.0));
    const double found = off(left[static_cast<std::size_t>(worst)]);
    if (found <= limit) return {};
    return fail(fmt::format(
        "found a length of line {} that puts the reflector {} mm from its place ({}), expected {} mm at most, which no "
        "machine exceeds: the lengths stand in another order or belong to another plan, or the beam was broken more "
        "often "
        "than its readings tell (state it in a column segment)",
        in_.line.id, format_fixed(found, 3), reading_name(reading(used[static_cast<std::size_t>(worst)])),
        format_exact(limit)));
  }

  double deviation_um(std::size_t k, double shift_mm) const {
    return um_per_mm * (excess_mm_[k] - dead_path_mm_ - shift_mm) / cosine(k);
  }

  Result<Test> make_test() {
    const Plan& plan = in_.line.plan;
    std::vector<bool> reached(plan.targets.size());
    std::size_t runs = 0;
    for (const LengthReading& r : in_.readings) {
      reached[r.approach.target] = true;
      runs = std::max(runs, r.approach.run + 1);
    }
    std::vector<std::size_t> place(plan.targets.size());
    std::vector<Position> targets;
    for (std::size_t i = 0; i < plan.targets.size(); ++i) {
      place[i] = targets.size();
      if (!reached[i]) continue;
      targets.push_back(plan.targets[i]);
      kept_.push_back(i);
    }
    if (targets.size() < 2)
      return fail(fmt::format("found readings at {} of the {} targets of line {}, expected at least two",
                              targets.size(), plan.targets.size(), in_.line.id));
    const std::size_t m = targets.size();
    std::vector<double> corrected(2 * m * runs, not_known), raw = corrected, times = corrected;
    for (std::size_t k = 0; k < in_.readings.size(); ++k) {
      const auto& [target, direction, run] = reading(k).approach;
      const std::size_t cell = (static_cast<std::size_t>(direction) * m + place[target]) * runs + run;
      corrected[cell] = deviation_um(k, fit_.stretches[stretch_[k]].shift_mm);
      raw[cell] = deviation_um(k, 0.0);
      if (!in_.times_s.empty()) times[cell] = in_.times_s[k];
    }
    AXIOMETRY_TRY(Series series, Series::make_dense(targets, runs, std::move(corrected)));
    Test test{line_metadata({in_.line, in_.setup, geometry_, series.travel_native(), in_.options.metadata}),
              std::move(series),
              {}};
    test.provenance.remarks =
        line_remarks({in_.line, in_.setup, geometry_, test.series.travel_native(), in_.options.metadata});
    if (in_.options.reversed)
      test.provenance.remarks.push_back({false, "the sign of all lengths was reversed, as asked for"});
    if (!in_.times_s.empty()) test.times_s = std::move(times);
    if (stretches_ > 1) {
      AXIOMETRY_TRY(test.as_measured, Series::make_dense(std::move(targets), runs, std::move(raw)));
      test.provenance.corrections.push_back(correction());
    }
    if (m < plan.targets.size())
      test.provenance.remarks.push_back(
          {true, fmt::format("found no reading at {} of the {} targets of the plan, expected one from every approach: "
                             "left out of the test",
                             plan.targets.size() - m, plan.targets.size())});
    return test;
  }

  std::size_t first_of(std::size_t stretch) const {
    return static_cast<std::size_t>(std::ranges::find(stretch_, stretch) - stretch_.begin());
  }

  /// What was taken off: the shift of each stretch against the first.
  AppliedCorrection correction() const {
    AppliedCorrection record{"beam-breaks", "Dead paths after breaks of the beam", {}, {}, {}};
    double smallest = 0.0, largest = 0.0;
    for (std::size_t k = 0; k < in_.readings.size(); ++k) {
      const double added = deviation_um(k, fit_.stretches[stretch_[k]].shift_mm) - deviation_um(k, 0.0);
      smallest = std::min(smallest, added);
      largest = std::max(largest, added);
    }
    record.smallest = Deviation::native(smallest);
    record.largest = Deviation::native(largest);
    record.details.push_back({"Dead path of the first stretch", format_exact(dead_path_mm_) + " mm"});
    for (std::size_t s = 1; s < stretches_; ++s)
      record.details.push_back(
          {fmt::format("Stretch {}, from reading {} ({})", s + 1, first_of(s) + 1, reading_name(reading(first_of(s)))),
           format_exact(fit_.stretches[s].shift_mm) + " mm more"});
    return record;
  }

  void describe(EvaluatedLine& line) const {
    for (const std::size_t i : kept_)
      line.distances_mm.push_back(is_aligned(in_.setup) ? in_.line.plan.targets[i].in_native()
                                                        : geometry_.distances_mm[i]);
    line.beam_angle_most_deg = geometry_.angle_most_deg;
    if (const auto& covariance = in_.setup.station.covariance_mm2) {
      line.offset = offset_uncertainty(*covariance, geometry_.direction);
      const auto farthest = std::ranges::max_element(line.distances_mm) - line.distances_mm.begin();
      line.length_difference_bounds =
          length_difference_bounds(line.offset, line.distances_mm, static_cast<std::size_t>(farthest));
      line.negligible_from_mm = negligible_from_mm(line.offset, in_.setup.ranging, 1.0 / 3.0);
    }
    const SlopeFit slope = fit_slope(line.test.series);
    line.slope_um_per_m = slope.slope_um_per_m;
    line.slope_uncertainty_um_per_m = slope.uncertainty_um_per_m;
    line.slope_degrees_of_freedom = slope.degrees_of_freedom;
    for (const Jump& jump : jumps_.breaks) line.breaks.push_back({in_.line.id, jump.before, jump.size_mm});
    for (std::size_t s = 0; s < stretches_; ++s) {
      const StretchFit& f = fit_.stretches[s];
      line.dead_paths.push_back({first_of(s), static_cast<std::size_t>(std::ranges::count(stretch_, s)),
                                 dead_path_mm_ + f.shift_mm, f.uncertainty_mm, f.ties, f.tied});
    }
  }

  void tell_jumps(LineOutcome& outcome) const {
    for (const Jump& jump : jumps_.breaks)
      outcome.findings.push_back(
          {"lines-beam-broken", false,
           fmt::format("line {}: the lengths jump by {} mm before reading {} ({}) and stay there, more than {} mm "
                       "that no machine does: the beam was broken; the readings from there on have a dead path of "
                       "their own",
                       in_.line.id, format_fixed(jump.size_mm, 4), jump.before + 1, reading_name(reading(jump.before)),
                       format_fixed(jumps_.threshold_mm, 3))});
    for (const Jump& jump : jumps_.outliers) {
      std::string message = fmt::format(
          "reading {} ({}) lies {} mm from where its neighbours say and the next one does not: kept as it "
          "is, and in all results",
          jump.before + 1, reading_name(reading(jump.before)), format_fixed(jump.size_mm, 4));
      outcome.line.test.provenance.remarks.push_back({false, message});
      outcome.findings.push_back({"lines-outlier", true, fmt::format("line {}: {}", in_.line.id, message)});
    }
  }

  void tell_dead_paths(LineOutcome& outcome) const {
    for (std::size_t s = 1; s < stretches_; ++s) {
      const DeadPath& path = outcome.line.dead_paths[s];
      if (path.tied && path.readings == 1) continue;  // told separately
      std::string message;
      if (path.tied) {
        message = fmt::format(
            "{} readings from reading {} on have their own dead path, which differs from the first by {} mm; {} of "
            "them "
            "tie it (u = {} µm){}",
            path.readings, path.first_reading + 1, format_fixed(fit_.stretches[s].shift_mm, 4), path.ties,
            format_fixed(um_per_mm * path.uncertainty_mm, 2),
            fit_.by_approach ? "" : ", taking the reversal error for alike at all targets");
      } else {
        message = fmt::format(
            "{} readings from reading {} on share no approach with those before, so that the line is split: what the "
            "deviation does between the parts cannot be told and was taken for no step",
            path.readings, path.first_reading + 1);
      }
      outcome.line.test.provenance.remarks.push_back({!path.tied, message});
      outcome.findings.push_back({path.tied ? "lines-dead-path" : "lines-split", !path.tied,
                                  fmt::format("line {}: {}", in_.line.id, message)});
    }
  }

  /// Its dead path follows from what the other runs show there.
  void tell_lone_readings(LineOutcome& outcome) const {
    for (const DeadPath& path : outcome.line.dead_paths) {
      if (path.readings != 1 || stretches_ == 1) continue;
      const std::string message = fmt::format(
          "reading {} ({}) alone has a dead path of its own, so that it tells nothing of the machine: take it again",
          path.first_reading + 1, reading_name(reading(path.first_reading)));
      outcome.line.test.provenance.remarks.push_back({false, message});
      outcome.findings.push_back({"lines-lone-reading", true, fmt::format("line {}: {}", in_.line.id, message)});
    }
  }

  void tell_angle(LineOutcome& outcome) const {
    if (geometry_.angle_most_deg < oblique_deg) return;
    const std::string message = fmt::format(
        "the beam stands at up to {}° to the line, which passes the station {} mm beside it: errors across the line "
        "enter the deviations",
        format_fixed(geometry_.angle_most_deg, 1), format_fixed(geometry_.miss_mm, 1));
    outcome.line.test.provenance.remarks.push_back({false, message});
    outcome.findings.push_back({"lines-oblique-beam", true, fmt::format("line {}: {}", in_.line.id, message)});
  }

  const LineInput& in_;
  LineGeometry geometry_;
  std::vector<double> excess_mm_;  // ΔL − d
  Jumps jumps_;
  std::vector<std::size_t> stretch_;  // stretch of each reading
  std::size_t stretches_ = 0;
  DeadPathFit fit_;
  double dead_path_mm_ = 0.0;      // c of the first stretch
  std::vector<std::size_t> kept_;  // targets that have a reading
};

}  // namespace

Result<LineOutcome> evaluate_line(const LineInput& input) {
  AXIOMETRY_TRY(LineGeometry geometry, line_geometry(setup_along(input.setup, input.line), input.line));
  return Course(input, std::move(geometry)).run();
}

}  // namespace axiometry::tracking
