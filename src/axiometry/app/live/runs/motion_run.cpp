// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/runs/motion_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "axiometry/app/files/output.h"
#include "axiometry/app/live/runs/marks_of_run.h"
#include "axiometry/app/live/runs/recording_spared.h"
#include "axiometry/app/live/sources/own_options.h"
#include "axiometry/app/live/sources/simulated_motion.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

constexpr std::string_view told_in_address[] = {"preset", "size", "seed", "speed"};

/// What the simulator is told behind "simulator://?"; nothing of another source.
Result<std::optional<OwnOptions>> told_simulator(const std::string& from) {
  AXIOMETRY_TRY(const auto live, parse_live(from));
  if (!live || live->kind != LiveAddress::Kind::simulator) return std::optional<OwnOptions>();
  std::vector<std::pair<std::string, std::string>> options;
  for (const std::string_view option : text::split(live->host, '&')) {
    const std::size_t equals = std::min(option.find('='), option.size());
    if (option.empty()) continue;
    if (std::ranges::find(told_in_address, option.substr(0, equals)) == std::end(told_in_address))
      return fail(fmt::format("found {} in the source, expected preset, size, seed or speed", text::quoted(option)));
    options.emplace_back(option.substr(0, equals), option.substr(std::min(equals + 1, option.size())));
  }
  AXIOMETRY_TRY(OwnOptions own, own_options(options, CaptureSource::Kind::simulator));
  return std::optional(std::move(own));
}

/// Behind what was heard before, where a recording is gone on with.
Result<CaptureRun> played_by_simulator(CaptureRun run, const OwnOptions& own, const CaptureSession& session) {
  std::error_code none;
  const std::uintmax_t heard = run.resume.empty() ? 0 : std::filesystem::file_size(run.resume, none);
  const SimulatedMotionCapture wanted = simulated_motion_of(own, {own.speed, none ? 0 : heard});
  AXIOMETRY_TRY(SimulatedMotion source, simulated_motion_source(wanted, session));
  run.simulated = simulated_motion_note(wanted, session.motion()->error());
  run.connect = std::move(source.connect);
  run.beside = std::move(source.beside);
  return run;
}

}  // namespace

Result<MotionOutcome> run_motion_capture(const CaptureRun& run, CaptureOptions options,
                                         const CaptureObserver& observer) {
  AXIOMETRY_TRY_VOID(check_recording_spared(run, options.plan));
  AXIOMETRY_TRY_VOID(check_ending(run.out, {".csv", ".txt"}));
  AXIOMETRY_TRY(const auto simulator, told_simulator(run.from));
  if (simulator) AXIOMETRY_TRY_VOID(hear_simulated_motion(options));
  AXIOMETRY_TRY_VOID(take_marks(run, *options.motion));
  AXIOMETRY_TRY(Plan plan, load_any_plan(options.plan));
  AXIOMETRY_TRY(CaptureSession session, CaptureSession::open(std::move(plan), options));
  CaptureRun listened = run;
  if (simulator) {
    AXIOMETRY_TRY(listened, played_by_simulator(run, *simulator, session));
  }
  AXIOMETRY_TRY(const HeardSource heard, hear_source(listened, std::move(session), observer));
  return MotionOutcome{heard.complete,           heard.stopped,           heard.session.taken(),
                       heard.session.expected(), heard.session.samples(), heard.session.lost()};
}

}  // namespace axiometry::app
