// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "axiometry/app/files/given_file.h"
#include "axiometry/app/results/experiment.h"
#include "axiometry/capture/dynamics/motion_course.h"
#include "axiometry/capture/dynamics/motion_spectrum.h"
#include "axiometry/capture/dynamics/uniform_motion.h"
#include "axiometry/model/axis.h"
#include "axiometry/report/report.h"

/// The use case "from a continuous recording to velocity, acceleration, vibrations and how evenly an axis moved": no
/// plan and no standstill is needed, and no parameter of ISO 230-2 comes of it.
namespace axiometry::app {

struct DynamicOptions {
  AxisKind kind = AxisKind::linear;
  std::string stream{};             ///< id of the layout; empty: recognised by content
  std::optional<double> rate_hz{};  ///< samples a second, for layouts that tell no time
  std::optional<double> units_per_count{};
  std::optional<std::size_t> stream_axis{};  ///< number in a stream of several, from 0; else columns by name
  bool skip_damaged = false;                 ///< leaves out what is no sample, as is always done of a raw recording
  bool reverse = false;                      ///< it counts up when the axis moves down
  std::optional<double> window_s{};          ///< capture::usual_window_s()
  std::optional<double> from_s{}, to_s{};    ///< only that part of the recording
  std::optional<double> feed{};              ///< feed that was asked for, native units per minute
  double uniform_share = 0.05;
  std::size_t samples_most = 20'000'000;
  std::stop_token stop{};  ///< nobody waits for it any more
};

/// Bounds of what is stated, also on the command line.
inline constexpr double largest_even_percent = 50.0;
inline constexpr std::size_t largest_stream_axis = 1'000'000;

/// What a request asks: "kind": "linear" or "rotary"; "stream", id of a layout; "rate_hz", "units_per_count",
/// "window_s", "from_s", "to_s", "feed_per_min", "even_percent"; "stream_axis", from 1; "skip_damaged", "reverse". What
/// is absent is as the verb has it. Fails on others, on other kinds of values and on numbers beyond the bounds.
Result<DynamicOptions> dynamic_options_from(const json::Value& options);

/// What the spectrum is of.
enum class SpectrumOf {
  longest_stretch,  ///< residuals of the longest stretch of even motion
  whole,            ///< the whole recording less a straight line
};

struct DynamicMotion {
  std::string file, sha256, layout;
  AxisKind kind = AxisKind::linear;
  capture::MotionRecord record;
  capture::MotionCourse course;
  std::vector<capture::UniformStretch> stretches;
  SpectrumOf spectrum_of = SpectrumOf::whole;
  capture::UniformStretch spectrum_stretch;  ///< samples and line
  capture::MotionSpectrum spectrum;          ///< amplitudes in µm or ″
  std::optional<double> feed{};
  double uniform_share = 0.05;
  std::vector<std::string> remarks;  ///< remarks on the file, and what these figures lack
};

/// Fails, with the file's name, as the reader of the layout does, on samples that are lost, not evenly spaced (beyond 1
/// % of the interval from one to the next, or from its place among all) or fewer than 64, on more of them than are
/// allowed, and on a part or a window that does not fit. Where what is damaged is skipped, on samples that are missing
/// in the part alone.
Result<DynamicMotion> measure_dynamic(const std::string& file, const DynamicOptions& options);
/// The same of bytes that are at hand; beside them no file is looked for.
Result<DynamicMotion> measure_dynamic(const GivenFile& file, const DynamicOptions& options);

/// Samples at which something is extreme, but for those within half a window of the ends.
struct DynamicExtremes {
  std::size_t fastest_up = 0, fastest_down = 0;      ///< samples with the highest and the lowest velocity
  std::size_t strongest_up = 0, strongest_down = 0;  ///< samples with the highest and the lowest acceleration
};
DynamicExtremes extremes_of(const DynamicMotion& motion);

/// Distance along the axis in one period of a vibration, native; absent where the axis did not move evenly.
std::optional<double> way_of(const DynamicMotion& motion, const capture::SpectrumPeak& peak);

struct DynamicOutputs {
  bool report = true;
  bool json = true;
};
Experiment present(const DynamicMotion& motion, const report::Options& options, DynamicOutputs outputs);
json::Value to_json(const DynamicMotion& motion);

/// What a screen shows of the motion: "position", "velocity_per_s", "acceleration_per_s2" (lists "time_s" and "value"),
/// "straying" (of the longest stretches of even motion, in order of time: "begin_s", "position", "value") and
/// "spectrum" ("frequency_hz", "value"), each of at most some two thousand points among which the extremes are.
json::Value curves_to_json(const DynamicMotion& motion);

/// "time_s,position_mm,velocity_mm_per_s,acceleration_mm_per_s2", a row for every sample; and
/// "frequency_hz,amplitude_um". Fail when the file cannot be written.
Result<void> write_series(const DynamicMotion& motion, const std::string& file);
Result<void> write_spectrum(const DynamicMotion& motion, const std::string& file);
std::string series_csv(const DynamicMotion& motion);
std::string spectrum_csv(const DynamicMotion& motion);

}  // namespace axiometry::app
