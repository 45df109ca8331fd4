// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/rounded_text.h"
#include "axiometry/numeric/distributions/chi_square.h"
#include "axiometry/standards/iso230_2/monte_carlo/environment_modes.h"
#include "axiometry/standards/iso230_2/monte_carlo/environment_recording.h"
#include "axiometry/standards/iso230_2/monte_carlo/gross_errors.h"

namespace axiometry::iso230_2 {
namespace {

constexpr double upper_limit = 0.025;               // probability beyond the upper limit of the scatter
constexpr double range_of_unit_sd = 3.4641016151;   // √12
constexpr double white_shares[] = {0.0, 0.5, 1.0};  // shares of the largest white noise that may act beside a drift
constexpr double doubt = 5.0;  // factor for E_VE of an unknown kind: one recording may miss so much of noise or trend
constexpr double wide = 3.0;   // standard deviation of errors of single readings over the largest departure
constexpr double negligible = 1e-12;  // E_VE, in the native deviation unit

/// The noise that inputs state; E_VE for itself.
struct StatedNoise {
  ReadingNoise noise;
  double environment = 0.0;  ///< standard deviation of E_VE taken as white
};

StatedNoise stated_noise(const NoiseQuestion& question) {
  StatedNoise stated{{.up_down_correlation = question.inputs.up_down_correlation}, 0.0};
  const auto& inputs = question.inputs.inputs;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    if (question.only_input && *question.only_input != k) continue;
    const double sd = inputs[k].distribution.standard_deviation().value_or(0.0);
    if (inputs[k].key == "environmental_variation") {
      stated.environment = sd > negligible ? sd : 0.0;
      continue;
    }
    double* of_effect = inputs[k].effect == Effect::reading            ? &stated.noise.reading
                        : inputs[k].effect == Effect::run              ? &stated.noise.run
                        : inputs[k].effect == Effect::target           ? &stated.noise.target
                        : inputs[k].effect == Effect::target_direction ? &stated.noise.target_direction
                                                                       : nullptr;
    if (of_effect != nullptr) *of_effect = std::hypot(*of_effect, sd);
  }
  return stated;
}

class NoiseModeller {
 public:
  explicit NoiseModeller(const NoiseQuestion& question)
      : question_(question),
        stated_(stated_noise(question)),
        within_(within_runs(question.series, question.course)),
        unit_(deviation_unit(question.metadata.axis.kind)) {}

  NoiseModels operator()() {
    add({"none", "no noise in the readings", false, {}, ""}, {ReadingNoise{}}, nullptr);
    add_stated();
    if (states_noise_of_readings() && question_.drifts && !question_.only_input) add_single_errors();
    return std::move(result_);
  }

  std::vector<EnvironmentKind> kinds() const {
    using Kind = EnvironmentKind;
    const Kind stated = stated_kind();
    if (stated == Kind::white && !refuted()) return {Kind::white};
    if (stated == Kind::drift || stated == Kind::random_walk) return {stated};
    std::vector<Kind> all = {Kind::drift, Kind::random_walk};
    if (!refuted()) all.insert(all.begin(), Kind::white);
    return all;
  }

 private:
  /// A resolution is the error of a target and a drift that of a run: neither acts on B, and the former not on R. Where
  /// nothing more is stated, errors of single readings would be all that is known of these.
  bool states_noise_of_readings() const { return stated_.environment > 0.0 || stated_.noise.reading > 0.0; }

  void add_stated() {
    const bool environment = stated_.environment > 0.0;
    const ReadingNoise& noise = stated_.noise;
    if (!environment && noise.reading == 0.0 && noise.run == 0.0 && noise.target == 0.0 &&
        noise.target_direction == 0.0)
      return;
    check_noise();
    if (!environment) {
      add({"white", "noise as it is stated", false, {}, ""}, {limited(noise)}, nullptr);
      return;
    }
    using Kind = EnvironmentKind;
    if (question_.drifts && add_recording()) return;
    if (stated_kind() == Kind::unknown || stated_kind() == Kind::white) add_white();
    for (Kind kind : kinds()) {
      if (kind == Kind::drift) add_drift(kind, "drift", "slow drift");
      if (kind == Kind::drift) add_trend();
      if (kind == Kind::random_walk) add_drift(kind, "random-walk", "random walk");
    }
    if (kind_is_open() && !question_.only_input) note_doubt();
  }

  /// Nothing is stated of it, or what the readings refute.
  bool kind_is_open() const {
    return stated_kind() == EnvironmentKind::unknown || (stated_kind() == EnvironmentKind::white && refuted());
  }

  void note_doubt() {
    result_.notes.emplace_back(
        several_runs()
            ? "The kind of E_VE is open: the interval assumes that white noise, and a trend that shifts of the "
              "runs hide, are at most five times what E_VE says, and that nothing in the environment repeats "
              "with every run"
            : "The kind of E_VE is open: the interval assumes that white noise is at most five times what "
              "E_VE says");
  }

  bool several_runs() const { return question_.series.run_count() > 1; }

  void add(NoiseHypothesis hypothesis, std::vector<ReadingNoise> shares, std::shared_ptr<const DriftPosterior> drift) {
    result_.hypotheses.push_back(hypothesis);
    if (!hypothesis.refuted) result_.models.push_back({std::move(hypothesis), std::move(shares), std::move(drift)});
  }

  /// No more noise of readings than they scatter within runs.
  ReadingNoise limited(ReadingNoise noise) const {
    noise.reading = std::min(noise.reading, within_.upper_sd());
    return noise;
  }

  EnvironmentKind stated_kind() const {
    if (!question_.drifts) return EnvironmentKind::white;
    return question_.metadata.gum.environment_kind.value_or(EnvironmentKind::unknown);
  }

  /// The standard deviation of the most white noise that E_VE may stand for.
  double largest_white() const {
    return question_.drifts && kind_is_open() ? doubt * stated_.environment : stated_.environment;
  }

  ReadingNoise with_environment(double sd) const {
    ReadingNoise noise = stated_.noise;
    noise.reading = std::hypot(noise.reading, sd);
    return limited(noise);
  }

  /// What is stated of single readings beside E_VE has no other kind that it could be.
  void check_noise() {
    const double u = stated_.noise.reading;
    if (u == 0.0 || question_.only_input) return;
    const double p = within_.probability_of(u);
    if (p >= refuted_below) return;
    result_.notes.push_back(fmt::format(
        "The stated noise of a reading, u = {:.3g} {}, contradicts the readings: within runs they scatter by "
        "s = {:.3g} {} alone ({}); no more than that is taken for noise",
        u, unit_, within_.sd(), unit_, format_chance(p)));
  }

  double white_size() const { return std::hypot(stated_.environment, stated_.noise.reading); }

  /// Whether the scatter within runs leaves no room for white noise of the stated size.
  bool refuted() const { return question_.drifts && within_.probability_of(white_size()) < refuted_below; }

  void add_white() {
    const double p = within_.probability_of(white_size());
    NoiseHypothesis hypothesis{"white", "white noise from reading to reading", refuted(), p,
                               "the scatter within runs leaves room for it"};
    if (hypothesis.refuted)
      hypothesis.reason = fmt::format(
          "within runs the readings scatter by s = {:.2g} {}, where white noise of this size alone would give {:.2g} "
          "{}",
          within_.sd(), unit_, white_size(), unit_);
    if (hypothesis.refuted && stated_kind() == EnvironmentKind::white && !question_.only_input)
      result_.notes.push_back(
          fmt::format("E_VE is stated as white noise, which the readings refute ({}): {}; every other kind is "
                      "considered in its place",
                      format_chance(p), hypothesis.reason));
    add(std::move(hypothesis), {with_environment(largest_white())}, nullptr);
  }

  /// Whether there is one. It says itself of what kind the variation is.
  bool add_recording() {
    const auto recorded = recorded_environment(question_.metadata, question_.course);
    if (!recorded) return false;
    const std::vector<ReadingNoise> shares = {with_environment(recorded->white_sd)};
    const std::string white = fmt::format("white noise of u = {:.2g} {}", recorded->white_sd, unit_);
    if (recorded->covariance.front() > 0.0)
      add_slow({"recording", "as the recording at standstill",
                fmt::format("how its values go together over the length of the test, and {} beside it", white),
                modes_of_covariance(recorded->covariance, question_.course.share), 1.0},
               shares);
    else
      add({"recording", "as the recording at standstill", false, {}, white + " and nothing beside it"}, shares,
          nullptr);
    if (recorded->whole && !question_.only_input)
      result_.notes.push_back(
          question_.course.duration
              ? "The recording at standstill is shorter than the test: what is slower than it is not known"
              : "The readings have no times: the test is taken to be as long as the recording at standstill");
    return true;
  }

  std::vector<ReadingNoise> beside_a_drift() const {
    std::vector<ReadingNoise> shares;
    for (double share : white_shares)
      shares.push_back(with_environment(share * std::min(largest_white(), within_.upper_sd())));
    return shares;
  }

  double stated_range() const { return stated_.environment * range_of_unit_sd; }

  void add_drift(EnvironmentKind kind, std::string_view key, std::string_view title) {
    add_slow({key, title, "its size is taken from the readings",
              environment_modes(kind, question_.course.share, question_.series.run_count()), stated_range()},
             beside_a_drift());
  }

  /// A machine whose runs shift hides a trend, in its run means and, since every run takes the same way, in the means
  /// of its targets.
  void add_trend() {
    if (!several_runs()) return;
    const bool open = kind_is_open();
    const VariationSize size{(open ? doubt : 1.0) * stated_range(), !open};
    add({"trend-beside-runs",
         "a trend that shifts of the runs hide",
         false,
         {},
         open ? "of up to five times of what is stated, as far as the means of the runs leave room"
              : "of about the size that is stated, as far as the means of the runs leave room"},
        beside_a_drift(),
        std::make_shared<const DriftPosterior>(question_.series, trend_mode(question_.course.share), size,
                                               MachineRuns::scattered));
  }

  /// Where errors are beyond doubt no interval is stated at all.
  void add_single_errors() {
    const Series& series = question_.series;
    if (!gross_errors(series, question_.course, question_.step).empty()) return;
    const auto suspected = gross_errors(series, question_.course, question_.step, one_test_in_ten);
    if (suspected.empty()) return;
    std::vector<std::size_t> readings;
    double largest = 0.0;
    for (const GrossError& error : suspected) {
      const std::size_t cell = static_cast<std::size_t>(error.direction) * series.target_count() + error.target;
      readings.push_back(cell * series.run_count() + error.run);
      largest = std::max(largest, std::abs(error.departure.in_native()));
    }
    const std::size_t places = 2 * series.target_count() * series.run_count();
    add({"single-errors",
         "errors of single readings",
         false,
         {},
         fmt::format("readings that depart from the others of their targets by up to {:.1f} times the standard "
                     "deviation of such a departure: {}",
                     suspected.front().factor, suspected.size())},
        stated_.environment > 0.0 ? beside_a_drift() : std::vector{limited(stated_.noise)},
        std::make_shared<const DriftPosterior>(series, single_errors(readings, places),
                                               VariationSize{wide * largest, false}, MachineRuns::steady));
  }

  struct Slow {
    std::string_view key;
    std::string_view title;
    std::string reason;
    EnvironmentModes modes;
    double range = 0.0;
  };

  /// A shift of a whole run may be the variation's or the machine's own: both are held possible.
  void add_slow(const Slow& slow, const std::vector<ReadingNoise>& shares) {
    for (const MachineRuns machine_runs : {MachineRuns::steady, MachineRuns::shifting}) {
      const bool shifting = machine_runs == MachineRuns::shifting;
      if (shifting && !several_runs()) continue;
      const auto drift =
          std::make_shared<const DriftPosterior>(question_.series, slow.modes, VariationSize{slow.range}, machine_runs);
      NoiseHypothesis hypothesis{std::string(slow.key) + (shifting ? "-beside-runs" : ""),
                                 std::string(slow.title) + (shifting ? ", and runs that shift of their own" : ""),
                                 false,
                                 {},
                                 ""};
      hypothesis.reason =
          fmt::format("{}; the readings show about {:.2g} of what is stated", slow.reason, drift->relative_size());
      add(std::move(hypothesis), shares, drift);
    }
  }

  const NoiseQuestion& question_;
  StatedNoise stated_;
  WithinRuns within_;
  std::string_view unit_;
  NoiseModels result_;
};

}  // namespace

double WithinRuns::sd() const { return degrees_of_freedom > 0.0 ? std::sqrt(squares / degrees_of_freedom) : 0.0; }

double WithinRuns::probability_of(double noise_sd) const {
  if (!(degrees_of_freedom > 0.0) || !(noise_sd > 0.0)) return 1.0;
  return numeric::chi_square_probability(squares / (noise_sd * noise_sd), degrees_of_freedom);
}

double WithinRuns::upper_sd() const {
  if (!(degrees_of_freedom > 0.0)) return std::numeric_limits<double>::infinity();
  return std::sqrt(squares / numeric::chi_square_quantile(upper_limit, degrees_of_freedom));
}

WithinRuns within_runs(const Series& series, const TestCourse& course) {
  const EnvironmentModes modes = environment_modes(EnvironmentKind::drift, course.share, 1);
  const SeenModes all(series, modes);
  const SeenModes within(series, modes, MachineRuns::shifting);
  // Where shapes and shifts use up the degrees of freedom, what they explain may be scatter as well.
  if (within.degrees_of_freedom_left >= 0.5 * all.degrees_of_freedom)
    return {within.squares_left, within.degrees_of_freedom_left};
  return {all.squares, all.degrees_of_freedom};
}

bool refutes_stated_white(const Test& test) {
  const auto& variation = test.metadata.uncertainty.environmental_variation;
  if (!variation || test.metadata.gum.environment_kind != EnvironmentKind::white) return false;
  return within_runs(test.series, course_of(test)).probability_of(variation->in_native() / range_of_unit_sd) <
         refuted_below;
}

NoiseModels noise_models(const NoiseQuestion& question) { return NoiseModeller(question)(); }

std::vector<EnvironmentKind> environment_kinds(const NoiseQuestion& question) {
  return NoiseModeller(question).kinds();
}

}  // namespace axiometry::iso230_2
