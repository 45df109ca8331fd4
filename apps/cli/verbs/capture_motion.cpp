// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/capture_motion.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <optional>
#include <string>

#include "axiometry/app/live/runs/motion_run.h"
#include "axiometry/app/recordings/motion_table.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/report/drawing/utf8.h"
#include "cli/failure.h"
#include "cli/text/progress.h"
#include "cli/text/terminal.h"
#include "cli/text/typed_keys.h"

namespace axiometry::cli {
namespace {

using capture::StopSign;

constexpr std::size_t kind_width = 17;  // width of "target 12↑ run 10"

class MotionDisplay {
 public:
  explicit MotionDisplay(bool quiet)
      : quiet_(quiet), terminal_(ColourChoice::automatic), shows_now_(!quiet && ::isatty(STDOUT_FILENO) == 1) {}
  ~MotionDisplay() { clear(); }

  void value(const capture::PlannedValue& value, const app::MotionListener& motion) {
    if (quiet_) return;
    clear();
    std::string line =
        fmt::format("{}  {}", left(capture::approach_name(value.approach), kind_width), app::value_text(value, motion));
    for (const std::string& remark : value.remarks) line += terminal_.yellow("; " + in_language_asked(remark));
    fmt::print("{}\n", line);
    tell_due(motion.values());
    std::fflush(stdout);
  }

  void event(const capture::CaptureEvent& event) {
    if (quiet_) return;
    clear();
    fmt::print("{}  {} (at {} s)\n",
               terminal_.yellow(left(in_language_asked(capture::event_name(event.kind)), kind_width)),
               told_fault(event.message), format_fixed(event.time_s, 2));
    std::fflush(stdout);
  }

  void notice(const std::string& text) {
    clear();
    tell(text);
  }

  void now(const app::CaptureSession& session) {
    if (quiet_) return;
    const capture::ValueListener& values = session.motion()->values();
    tell_due(values);
    const auto due = values.due();
    const bool by_keys = values.options().sign == StopSign::keys;
    if (!shows_now_) return;
    std::string line = fmt::format("{} of {}", session.taken(), session.expected());
    line += values.now()
                ? fmt::format("  {} {}", format_fixed(*values.now(), 2), motion_unit_symbol(session.motion()->unit()))
                : std::string("  waiting for readings");
    if (due) line += ", next " + place(*due, values.plan());
    if (const auto axis = session.now()) line += axis->at_rest ? ", the axis stands" : ", the axis moves";
    line += values.is_reading()      ? "  reading …"
            : values.waits_for_key() ? "  Enter: it is this one, s: this one is missing"
            : by_keys                ? "  Enter when it stands, s skip, u undo, e end"
                                     : "";
    fmt::print("\r{}", left(line, width_));
    std::fflush(stdout);
    width_ = display_width(line);
  }

  void clear() {
    if (width_ > 0) fmt::print("\r{}\r", std::string(width_, ' '));
    width_ = 0;
  }

 private:
  static std::string place(const Approach& due, const Plan& plan) {
    return fmt::format("{} at {} mm", capture::approach_name(due),
                       format_fixed(plan.targets[due.target].in_native(), 4));
  }

  /// With keys the target that is due is told once, also where no line can be written over.
  void tell_due(const capture::ValueListener& values) {
    const auto due = values.due();
    if (!due || values.options().sign != StopSign::keys || due_told_ == due) return;
    due_told_ = due;
    clear();
    fmt::print("{}  {}\n", left("next", kind_width), place(*due, values.plan()));
    std::fflush(stdout);
  }

  bool quiet_;
  Terminal terminal_;
  bool shows_now_;
  std::optional<Approach> due_told_;
  std::size_t width_ = 0;
};

/// 0 stands for every reading of the plan, as of positions.
int motion_exit_code(const app::MotionOutcome& outcome) {
  if (InterruptGuard::interrupted()) return exit_interrupted;
  return outcome.found < outcome.planned ? exit_incomplete : exit_done;
}

}  // namespace

int capture_motion(const app::CaptureRun& run, const app::CaptureOptions& options, bool quiet) {
  const InterruptGuard guard;
  const bool silent = quiet || run.out == "-";
  MotionDisplay display(silent);
  TypedKeys typed;
  const bool by_keys = options.motion->sign == StopSign::keys;
  bool nothing_can_come = false;
  const app::CaptureObserver observer{
      .reading = {},
      .event = [&](const auto& event) { display.event(event); },
      .notice = [&](const std::string& text) { display.notice(text); },
      .now =
          [&](const app::CaptureSession& session) {
            // What was said last is read to its end before the capture is over.
            nothing_can_come = by_keys && typed.closed() && !session.motion()->values().is_reading();
            display.now(session);
          },
      .stopped = [&] { return InterruptGuard::interrupted() || typed.ended() || nothing_can_come; },
      .abandoned = {},
      .value = [&](const auto& value, const auto& motion) { display.value(value, motion); },
      .keys =
          [&] {
            auto keys = typed.take();
            for (const std::string& line : typed.take_unknown())
              display.notice(
                  fmt::format("found {}, expected Enter, s (skip), u (undo) or e (end)", text::quoted(line)));
            return keys;
          },
  };
  const auto outcome = app::run_motion_capture(run, options, observer);
  display.clear();
  if (!outcome) return failed(outcome.error(), InterruptGuard::interrupted() ? exit_interrupted : exit_bad_input);
  if (!silent)
    fmt::print("{} of {} from {}{}{}\n", outcome->found, counted(outcome->planned, "reading"),
               counted(outcome->samples, "sample"), outcome->lost > 0 ? fmt::format(", {} lost", outcome->lost) : "",
               run.out.empty() || outcome->found == 0 ? "" : fmt::format("; {}", report::printable(run.out)));
  return motion_exit_code(*outcome);
}

}  // namespace axiometry::cli
