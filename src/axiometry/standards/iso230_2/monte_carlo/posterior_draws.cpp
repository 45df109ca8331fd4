// SPDX-License-Identifier: Apache-2.0

// Draws of posterior.h: what is drawn of many trials, in rows with a number for each trial.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/kernels/kernel_table.h"
#include "axiometry/standards/iso230_2/monte_carlo/kernels/cell_kernel_types.h"
#include "axiometry/standards/iso230_2/monte_carlo/kernels/moment_kernel_types.h"
#include "axiometry/standards/iso230_2/monte_carlo/posterior.h"

namespace axiometry::iso230_2 {

AXIOMETRY_KERNEL_TABLE(cell_kernel, CellKernel);

AXIOMETRY_KERNEL_TABLE(moment_kernel, MomentKernel);

const CellKernel& cell_kernel_of(numeric::VectorTarget target) { return cell_kernel_table.of(target); }
const MomentKernel& moment_kernel_of(numeric::VectorTarget target) { return moment_kernel_table.of(target); }

namespace {

constexpr double no_reading = std::numeric_limits<double>::quiet_NaN();
constexpr double negligible_share = 1e-12;  // share of the variance of δ below which other noise is neglected

/// Rows of the random numbers of one key, made when they are taken, so that they are in the nearest cache.
class RandomRows {
 public:
  RandomRows(numeric::RandomKey key, std::size_t trials, std::size_t rows) : stream_(key), trials_(trials) {
    if (trials % numeric::RandomKernel::normal_group == 0) return;
    all_.resize(rows * trials);  // a piece must end with a group
    stream_.fill_normal(all_);
  }

  /// The next rows of normal numbers, one after the other; those before are gone.
  std::span<const double> next(std::size_t rows = 1) {
    const std::size_t count = rows * trials_, begin = std::exchange(taken_, taken_ + count);
    if (!all_.empty()) return std::span(all_).subspan(begin, count);
    numbers_.resize(std::max(numbers_.size(), count));
    stream_.fill_normal(std::span(numbers_).first(count));
    return std::span(numbers_).first(count);
  }

  /// The next numbers, to be kept. Contract: trials in whole groups.
  void fill_normal(std::span<double> numbers) {
    AXIOMETRY_CONTRACT(all_.empty());
    stream_.fill_normal(numbers);
  }

  /// As next(), of a row that nobody wants: a group of normal numbers takes as many words of 64 bits.
  void skip() {
    taken_ += trials_;
    if (!all_.empty()) return;
    bits(1);
  }

  /// The next rows of whole numbers; those before are gone. Contract: trials in whole groups.
  std::span<const std::uint64_t> bits(std::size_t rows) {
    AXIOMETRY_CONTRACT(all_.empty());
    const std::size_t count = rows * trials_;
    bits_.resize(std::max(bits_.size(), count));
    stream_.fill_bits(std::span(bits_).first(count));
    return std::span(bits_).first(count);
  }

 private:
  numeric::RandomStream stream_;
  std::size_t trials_;
  std::size_t taken_ = 0;
  std::vector<double> numbers_, all_;
  std::vector<std::uint64_t> bits_;
};

const CellKernel& best_cell_kernel() { return cell_kernel_of(numeric::best_vector_target()); }
const MomentKernel& best_moment_kernel() { return moment_kernel_of(numeric::best_vector_target()); }

}  // namespace

/// What all draws of a batch of trials need: rows over the cells, one value per trial.
struct ReadingPosterior::State {
  std::size_t trials = 0;
  numeric::UnsetNumbers<double> sds;       ///< σ
  numeric::UnsetNumbers<double> means;     ///< μ, then the true means of the cells' own approaches
  numeric::UnsetNumbers<double> run_sds;   ///< σ_ρ, one row
  numeric::UnsetNumbers<double> machines;  ///< σ²/(σ² + u²), the machine's share of the scatter; from share_mean()
  std::optional<RandomRows> normals{};     ///< normal numbers, taken first by share_means(), then by the readings
  std::vector<double> target_shifts{};     ///< δ of every target; empty where there is none
  std::vector<double> residuals{};         ///< residuals of the cell that is being drawn; the next three are of it too
  std::vector<const double*> run_shifts{};
  std::vector<double*> rows{};
  std::vector<double> signed_shift{};            ///< δ as it acts on the cell
  std::vector<double> parted_shifts{}, shift{};  ///< q_j − q̄ in rows over all runs, and q̄; from part_shifts()
  bool parted_of_all_runs = false;               ///< whether these hold for every cell that has all runs

  std::span<double> sd(std::size_t cell) { return sds.all().subspan(cell * trials, trials); }
  std::span<double> mean(std::size_t cell) { return means.all().subspan(cell * trials, trials); }
  std::span<double> machine(std::size_t cell) { return machines.all().subspan(cell * trials, trials); }
};

/// σ of every cell and σ_ρ, a value for each trial; `uniforms` hold what belongs to one trial after the other.
void ReadingPosterior::draw_spreads(std::span<const double> uniforms, numeric::Rows<double> sds,
                                    std::span<double> run_sds) const {
  for (std::size_t t = 0; t < run_sds.size(); ++t) {
    const std::span<const double> u = uniforms.subspan(t * uniforms_each(), uniforms_each());
    spread_->draw({u[0], u[1], u.last(cells_.size())}, sds.values.subspan(t), sds.stride);
    run_sds[t] = run_sds_[run_choice_(u[2])] * std::exp(run_step_ * (u[3] - 0.5));
  }
}

/// σ, σ_ρ and μ of every trial.
ReadingPosterior::State ReadingPosterior::draw_state(numeric::RandomKey key, std::size_t trials, Asked asked) const {
  const std::size_t cells = cells_.size();
  using Numbers = numeric::UnsetNumbers<double>;
  State state{trials, Numbers(cells * trials), Numbers(cells * trials), Numbers(trials),
              Numbers(asked == Asked::readings ? cells * trials : 0)};
  const std::size_t rows_shared = (shared_variance_ > 0.0 ? targets_ : 0) + 2 * cells;
  const std::size_t rows_of_readings = runs_ + (noise_.reading > 0.0 ? cells * runs_ : 0);
  if (asked == Asked::readings)
    state.normals.emplace(numeric::RandomKey{key.seed, key.stream + 1, key.block}, trials,
                          rows_shared + rows_of_readings);
  const Numbers uniforms(uniforms_each() * trials), curve_normals(curve_normals_ * trials);
  numeric::fill_uniform({key.seed, key.stream, 2 * key.block}, uniforms.all());
  numeric::fill_normal({key.seed, key.stream, 2 * key.block + 1}, curve_normals.all());
  draw_spreads(uniforms.all(), {state.sds.all(), trials}, state.run_sds.all());
  draw_means(state, uniforms.all(), curve_normals.all());
  return state;
}

/// μ of every trial; `uniforms` and `normals` hold what belongs to one trial after the other.
void ReadingPosterior::draw_means(State& state, std::span<const double> uniforms,
                                  std::span<const double> normals) const {
  const std::size_t trials = state.trials, uniforms_each = uniforms.size() / trials;
  std::vector<double> choices(trials);
  std::vector<char> begun(cells_.size(), 0);  // every cell is in some curve
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    const numeric::CurvePosterior& posterior = curves_[k].posterior;
    for (std::size_t t = 0; t < trials; ++t) choices[t] = uniforms[t * uniforms_each + 4 + k];
    const numeric::UnsetNumbers<double> values(posterior.size() * trials);
    posterior.draw({choices, normals, curve_normals_}, numeric::Rows<double>{values.all(), trials});
    normals = normals.subspan(posterior.normals_each());
    for (const Curve::Term& term : curves_[k].terms) {
      double* const of_cell = state.mean(term.cell).data();
      const double* const value = values.all().data() + term.place * trials;
      if (std::exchange(begun[term.cell], 1) == 0)
        for (std::size_t t = 0; t < trials; ++t) of_cell[t] = term.factor * value[t];
      else
        for (std::size_t t = 0; t < trials; ++t) of_cell[t] += term.factor * value[t];
    }
  }
}

/// δ of every target, as it acts on ↑: rows over the targets; none where there is no such noise.
std::vector<double> ReadingPosterior::draw_target_shifts(State& state) const {
  if (!(shared_variance_ > 0.0)) return {};
  const double u2 = noise_.reading * noise_.reading;
  std::vector<double> precision(targets_ * state.trials, 0.0), pull(targets_ * state.trials, 0.0);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const Cell& cell = cells_[c];
    const double sign = cell.place < targets_ ? 1.0 : down_sign_;
    for (std::size_t t = 0; t < state.trials; ++t) {
      const double sd = state.sd(c)[t];
      const double of_mean = (sd * sd + u2) / static_cast<double>(cell.count);
      // Means without any noise of their own (n = 1, or all readings alike) tell δ all but exactly.
      const double own = std::max(of_mean + own_variance_, negligible_share * shared_variance_);
      const double weight = 1.0 / own;
      precision[cell.target * state.trials + t] += weight;
      pull[cell.target * state.trials + t] += sign * weight * (cell.mean - state.mean(c)[t]);
    }
  }
  std::vector<double> shift(targets_ * state.trials, 0.0);
  for (std::size_t i = 0; i < targets_; ++i) {
    const auto z = state.normals->next();
    for (std::size_t t = 0; t < state.trials; ++t) {
      const std::size_t k = i * state.trials + t;
      const double variance = 1.0 / (precision[k] + 1.0 / shared_variance_);
      shift[k] = variance * pull[k] + std::sqrt(variance) * z[t];
    }
  }
  return shift;
}

/// From the long-run means to those of the cells' own approaches: what x̄ − μ holds is shared between the target's
/// δ, the direction's own, the noise of the readings and the machine's scatter, in the ratio of their variances.
void ReadingPosterior::share_means(State& state) const {
  state.target_shifts = draw_target_shifts(state);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const bool directions_differ = own_variance_ > 0.0;
    if (!directions_differ) state.normals->skip();
    share_mean(c, state, state.normals->next(directions_differ ? 2 : 1).data());
  }
}

/// Of one cell, after the δ of the targets; `z` are rows of normal numbers: for what the direction has of its own,
/// where it has anything, and for the mean of the readings.
void ReadingPosterior::share_mean(std::size_t index, State& state, const double* z) const {
  const Cell& cell = cells_[index];
  const bool has_target_shift = !state.target_shifts.empty(), directions_differ = own_variance_ > 0.0;
  const double sign = cell.place < targets_ ? 1.0 : down_sign_;
  state.signed_shift.resize(has_target_shift ? state.trials : 0);
  for (std::size_t t = 0; t < state.signed_shift.size(); ++t)
    state.signed_shift[t] = sign * state.target_shifts[cell.target * state.trials + t];
  best_cell_kernel().share({.trials = state.trials,
                            .observed_mean = cell.mean,
                            .count = static_cast<double>(cell.count),
                            .noise_variance = noise_.reading * noise_.reading,
                            .own_variance = own_variance_,
                            .sds = state.sd(index).data(),
                            .shift = has_target_shift ? state.signed_shift.data() : nullptr,
                            .direction_normals = z,
                            .reading_normals = directions_differ ? z + state.trials : z,
                            .means = state.mean(index).data(),
                            .machines = state.machine(index).data()});
}

/// The machine's part of the runs' shifts: rows over the runs. What was seen of a run is ρ_j + d_j and the mean of what
/// its C readings have of their own: the machine has σ_ρ² + σ²/C of it, the measurement u_d² + u²/C. draw_cell() and
/// draw_moments_of() bring the noise of single readings, so that its part is left out here.
std::vector<double> ReadingPosterior::draw_run_shifts(State& state) const {
  std::vector<double> shifts(runs_ * state.trials, 0.0);
  if (cells_per_run_ == 0.0) return shifts;
  const double u2 = noise_.reading * noise_.reading;
  best_cell_kernel().run_shifts({.trials = state.trials,
                                 .cells = cells_.size(),
                                 .runs = runs_,
                                 .noise_variance = u2,
                                 .measured = noise_.run * noise_.run + u2 / cells_per_run_,
                                 .cells_per_run = cells_per_run_,
                                 .sds = state.sds.all().data(),
                                 .run_sds = state.run_sds.all().data(),
                                 .observed = run_shifts_.data(),
                                 .normals = state.normals->next(runs_).data(),
                                 .shifts = shifts.data()});
  return shifts;
}

/// The readings of one cell about its true mean: shifts of the runs, and the machine's share of the residuals.
void ReadingPosterior::draw_cell(std::size_t index, std::span<const double> shifts, State& state,
                                 numeric::Rows<double> readings) const {
  const Cell& cell = cells_[index];
  state.residuals.clear();
  state.run_shifts.clear();
  state.rows.clear();
  for (std::size_t j = 0; j < runs_; ++j) {
    if (std::isnan(cell.residuals[j])) continue;
    state.residuals.push_back(cell.residuals[j]);
    state.run_shifts.push_back(shifts.data() + j * state.trials);
    state.rows.push_back(readings.row(j, state.trials).data());
  }
  const auto normals = state.normals->next(noise_.reading > 0.0 ? state.rows.size() : 0);
  best_cell_kernel().readings({.trials = state.trials,
                               .count = state.rows.size(),
                               .noise_sd = noise_.reading,
                               .residuals = state.residuals.data(),
                               .means = state.mean(index).data(),
                               .machines = state.machine(index).data(),
                               .shifts = state.run_shifts.data(),
                               .normals = normals.data(),
                               .readings = state.rows.data()});
}

void ReadingPosterior::draw_cells(numeric::RandomKey key, std::size_t trials, const VisitCell& visit) const {
  std::vector<double> memory(runs_ * trials);
  const numeric::Rows<double> readings{memory, trials};
  if (exact_) {
    for (const Cell& cell : cells_) {
      for (std::size_t j = 0; j < runs_; ++j) std::ranges::fill(readings.row(j, trials), cell.readings[j]);
      visit(cell.place, readings);
    }
    return;
  }
  State state = draw_state(key, trials, Asked::readings);
  share_means(state);
  const std::vector<double> shifts = draw_run_shifts(state);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    for (std::size_t j = 0; j < runs_; ++j)
      if (std::isnan(cells_[c].residuals[j])) std::ranges::fill(readings.row(j, trials), no_reading);
    draw_cell(c, shifts, state, readings);
    visit(cells_[c].place, readings);
  }
}

void ReadingPosterior::draw_readings(numeric::RandomKey key, numeric::Rows<double> readings) const {
  const std::size_t trials = readings.stride;
  std::ranges::fill(readings.values, no_reading);
  draw_cells(key, trials, [&](std::size_t place, numeric::Rows<double> drawn) {
    std::ranges::copy(drawn.values, readings.values.begin() + static_cast<std::ptrdiff_t>(place * runs_ * trials));
  });
}

/// Shifts of the runs that a cell has, less what is to be taken away, about their mean.
void ReadingPosterior::part_shifts(std::size_t index, std::span<const double> shifts, const TakeAway& take_away,
                                   State& state) const {
  const Cell& cell = cells_[index];
  const bool of_all_runs = cell.count == runs_ && !take_away;
  if (of_all_runs && std::exchange(state.parted_of_all_runs, true)) return;
  if (!of_all_runs) state.parted_of_all_runs = false;
  state.parted_shifts.assign(shifts.begin(), shifts.end());
  state.shift.resize(state.trials);
  const numeric::Rows<double> parted{state.parted_shifts, state.trials};
  state.run_shifts.clear();
  state.rows.clear();
  for (std::size_t j = 0; j < runs_; ++j) {
    if (std::isnan(cell.residuals[j])) {
      std::ranges::fill(parted.row(j, state.trials), no_reading);
      continue;
    }
    state.rows.push_back(parted.row(j, state.trials).data());
    state.run_shifts.push_back(state.rows.back());
  }
  if (take_away) take_away(cell.place, parted);
  best_moment_kernel().about_mean(
      {state.trials, state.rows.size(), state.run_shifts.data(), state.rows.data(), state.shift.data()});
}

/// Mean and estimator of one cell, after part_shifts().
void ReadingPosterior::draw_moments_of(std::size_t index, State& state, const MomentRows& moments) const {
  const Cell& cell = cells_[index];
  state.residuals.clear();
  for (double residual : cell.residuals)
    if (!std::isnan(residual)) state.residuals.push_back(residual);
  const MomentNumbers numbers = moment_numbers(cell.count);
  best_moment_kernel().in_noise({.trials = state.trials,
                                 .count = cell.count,
                                 .noise_variance = noise_.reading * noise_.reading,
                                 .residuals = state.residuals.data(),
                                 .machines = state.machine(index).data(),
                                 .about = state.run_shifts.data(),
                                 .shift = state.shift.data(),
                                 .normals = state.normals->next(numbers.normals).data(),
                                 .bits = state.normals->bits(numbers.bits).data(),
                                 .own_means = state.mean(index).data(),
                                 .means = moments.means.row(cell.place, state.trials).data(),
                                 .estimators = moments.estimators.row(cell.place, state.trials).data()});
}

void ReadingPosterior::draw_moments(numeric::RandomKey key, const MomentRows& moments,
                                    const TakeAway& take_away) const {
  const std::size_t trials = moments.means.stride;
  AXIOMETRY_CONTRACT(independent_noise() && trials % numeric::RandomKernel::normal_group == 0);
  AXIOMETRY_CONTRACT(moments.estimators.stride == trials);
  if (cells_.size() < 2 * targets_) {
    std::ranges::fill(moments.means.values, no_reading);
    std::ranges::fill(moments.estimators.values, no_reading);
  }
  State state = draw_state(key, trials, Asked::readings);
  state.target_shifts = draw_target_shifts(state);
  const std::vector<double> shifts = draw_run_shifts(state);
  const std::size_t numbers_each = (own_variance_ > 0.0 ? 2 : 1) * trials;
  const numeric::UnsetNumbers<double> of_means(cells_.size() * numbers_each);
  state.normals->fill_normal(of_means.all());
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    share_mean(c, state, of_means.all().data() + c * numbers_each);
    part_shifts(c, shifts, take_away, state);
    draw_moments_of(c, state, moments);
  }
}

void ReadingPosterior::draw_long_run(numeric::RandomKey key, numeric::Rows<double> means,
                                     numeric::Rows<double> sds) const {
  AXIOMETRY_CONTRACT(!curves_.empty());
  std::ranges::fill(means.values, no_reading);
  std::ranges::fill(sds.values, no_reading);
  State state = draw_state(key, means.stride, Asked::long_run);
  const TiltDraws tilts = draw_tilts(key, means.stride);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    std::ranges::copy(state.mean(c), means.row(cells_[c].place, means.stride).begin());
    const auto sd = state.sd(c);
    const auto row = sds.row(cells_[c].place, means.stride);
    for (std::size_t t = 0; t < means.stride; ++t) row[t] = std::hypot(sd[t], state.run_sds.all()[t]);
    if (!tilts_) continue;
    const std::size_t d = cells_[c].place < targets_ ? 0 : 1;
    const double lever = tilts_->levers[cells_[c].target];
    // Variance of shift and tilt of a run, less that of the shift.
    const double with_shift = tilts_->variances[d] * (lever * lever + 2.0 * lever * tilts_->shifts[d]);
    const auto mean = means.row(cells_[c].place, means.stride);
    for (std::size_t t = 0; t < means.stride; ++t) {
      mean[t] += lever * tilts.of_mean[d][t];
      const double run_sd = state.run_sds.all()[t];
      row[t] = std::sqrt(
          std::max(0.0, tilts_->kept * sd[t] * sd[t] + run_sd * run_sd + with_shift * tilts.square_shares[t]));
    }
  }
}

}  // namespace axiometry::iso230_2
