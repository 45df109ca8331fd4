// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>
#include "cli/flags/verb.h"

#include "axiometry/app/files/source.h"
#include "axiometry/app/live/runs/length_run.h"
#include "axiometry/app/recordings/raw_log.h"
#include "axiometry/app/tracking/tracking_plan.h"
#include "axiometry/app/volumetric/plan_volume.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/report/drawing/utf8.h"
#include "cli/failure.h"
#include "cli/flags/capture_flags.h"
#include "cli/flags/stop_flags.h"
#include "cli/text/progress.h"
#include "cli/text/terminal.h"
#include "cli/verbs/capture_motion.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

constexpr std::size_t standstills_to_warn = 12;

struct CaptureArguments {
  app::CaptureOptions options;
  app::CaptureRun run;
  std::string give_up;
  bool quiet = false;
  StopFlags stops;
};

/// Readings and events as lines; on a terminal a last line says where the axis is.
class Display {
 public:
  /// Of lines no plan of one axis is needed: nothing but where the reflector is can be told before the end.
  Display(bool quiet, const Plan* plan)
      : quiet_(quiet),
        terminal_(ColourChoice::automatic),
        shows_now_(!quiet && ::isatty(STDOUT_FILENO) == 1),
        kind_(plan == nullptr ? AxisKind::linear : plan->axis.kind),
        plan_(plan) {}
  ~Display() { clear(); }

  void reading(const capture::CapturedReading& reading) {
    if (quiet_) return;
    clear();
    const double scale = deviation_per_position(kind_);
    const auto deviation_text = [&](double x) { return format_fixed(x, 2); };
    std::string line = fmt::format("{}  {} {}  {} {}  s {}  {}", left(capture::approach_name(reading.approach), 17),
                                   right(format_fixed(plan_->targets[reading.approach.target].in_native(), 4), 11),
                                   position_unit(kind_), right(deviation_text(reading.deviation.in_native()), 9),
                                   deviation_unit(kind_), deviation_text(reading.standstill.spread.in_native() * scale),
                                   counted(reading.standstill.count, "sample"));
    for (const std::string& remark : reading.remarks) line += terminal_.yellow("; " + in_language_asked(remark));
    fmt::print("{}\n", line);
    std::fflush(stdout);
  }

  void event(const capture::CaptureEvent& event) {
    if (quiet_) return;
    clear();
    fmt::print("{}  {} (at {} s)\n", terminal_.yellow(left(in_language_asked(capture::event_name(event.kind)), 17)),
               told_fault(event.message), format_fixed(event.time_s, 2));
    std::fflush(stdout);
  }

  void notice(const std::string& text) {
    clear();
    tell(text);
  }

  void now(const app::CaptureSession& session) {
    if (!shows_now_) return;
    const auto at = session.now();
    const auto due = session.stops() == nullptr ? session.matcher().due() : std::nullopt;
    const std::string line = fmt::format("{} of {}  {}{}", session.taken(), session.expected(),
                                         at ? fmt::format("{} {} {}", format_fixed(at->position.in_native(), 4),
                                                          position_unit(kind_), at->at_rest ? "at rest" : "moving")
                                            : std::string("waiting for samples"),
                                         due ? ", next " + capture::approach_name(*due) : "");
    fmt::print("\r{}", left(line, width_));
    std::fflush(stdout);
    width_ = display_width(line);
  }

  void clear() {
    if (width_ > 0) fmt::print("\r{}\r", std::string(width_, ' '));
    width_ = 0;
  }

 private:
  bool quiet_;
  Terminal terminal_;
  bool shows_now_;
  AxisKind kind_;
  const Plan* plan_;
  std::size_t width_ = 0;
};

int capture_failed(const Error& error) {
  return failed(error, InterruptGuard::interrupted() ? exit_interrupted : exit_bad_input);
}

/// A script must not take half a test for a whole one: 0 stands for every reading of the plan.
int capture_exit_code(std::size_t found, std::size_t planned) {
  if (InterruptGuard::interrupted()) return exit_interrupted;
  return found < planned ? exit_incomplete : exit_done;
}

void print_end(const app::CaptureOutcome& outcome, const app::CaptureRun& run) {
  fmt::print("{} of {} from {}{}{}\n", outcome.result.readings.size(), counted(outcome.result.approaches, "reading"),
             counted(outcome.samples, "sample"), outcome.lost > 0 ? fmt::format(", {} lost", outcome.lost) : "",
             run.out.empty() || run.out == "-" ? "" : fmt::format("; {}", report::printable(run.out)));
}

/// What is told while lengths come: which stop one belongs to is certain only at the end.
app::CaptureObserver length_observer(Display& display) {
  return {
      .reading = {},
      .event = {},
      .notice = [&display](const std::string& text) { display.notice(text); },
      .now = [&display](const auto& session) { display.now(session); },
      .stopped = [] { return InterruptGuard::interrupted(); },
      .abandoned = {},
  };
}

void print_lengths(const CaptureArguments& arguments, const std::vector<std::string>& notes, std::size_t found,
                   std::size_t planned) {
  if (arguments.quiet || arguments.run.out == "-") return;
  for (const std::string& note : notes) fmt::print("{}\n", in_language_asked(note));
  if (!arguments.run.out.empty())
    fmt::print("{} of {}; {}\n", found, counted(planned, "length"), report::printable(arguments.run.out));
}

/// The lines of a tracking plan.
int capture_lengths(const CaptureArguments& arguments) {
  const InterruptGuard guard;
  Display display(arguments.quiet || arguments.run.out == "-", nullptr);
  const auto outcome = app::run_length_capture(arguments.run, arguments.options, length_observer(display));
  display.clear();
  if (!outcome) return capture_failed(outcome.error());
  const app::CapturedLengths& lengths = outcome->lengths;
  print_lengths(arguments, lengths.notes, lengths.readings.size(), lengths.approaches);
  return capture_exit_code(lengths.readings.size(), lengths.approaches);
}

/// A part of a volumetric plan.
int capture_part(const CaptureArguments& arguments) {
  const InterruptGuard guard;
  Display display(arguments.quiet || arguments.run.out == "-", nullptr);
  app::CaptureObserver observer = length_observer(display);
  bool warned = false;
  observer.now = [&](const app::CaptureSession& session) {
    const std::size_t standstills = session.stops()->matcher().standstills().size();
    if (!warned && standstills >= standstills_to_warn && 3 * session.taken() < standstills) {
      display.notice(
          fmt::format("{} standstills and {} at points of this part: is it the right part, and the lengths "
                      "in the right unit?",
                      standstills, session.taken()));
      warned = true;
    }
    display.now(session);
  };
  const auto outcome = app::run_part_capture(arguments.run, arguments.options, observer);
  display.clear();
  if (!outcome) return capture_failed(outcome.error());
  const app::PartLengths& lengths = outcome->lengths;
  print_lengths(arguments, lengths.notes, lengths.lengths.readings.size(), lengths.planned);
  return capture_exit_code(lengths.lengths.readings.size(), lengths.planned);
}

/// Whether what comes is in no file: of the standard input as it is, or a pipe that has a name.
bool is_piped(const std::string& from) {
  std::error_code unknown;
  return from == "-" ? app::standard_input_is_a_stream() : std::filesystem::is_fifo(from, unknown);
}

/// What a pipe brings is there once only. With the test on the standard output another program uses it at once.
void tell_of_pipe(const CaptureArguments& arguments) {
  const app::CaptureRun& run = arguments.run;
  if (!is_piped(run.from) || !run.raw.empty() || arguments.quiet || run.out == "-") return;
  if (run.from == "-")
    return tell(
        "what comes from the standard input is not kept as it came: --raw FILE keeps it, and --out FILE does, as "
        "FILE.raw");
  tell("what comes from a pipe is not kept as it came: --raw FILE keeps it, and --out FILE does, as FILE.raw");
}

int capture(const CaptureArguments& arguments) {
  tell_of_pipe(arguments);
  if (arguments.options.motion) return capture_motion(arguments.run, arguments.options, arguments.quiet);
  const auto of_lines = app::is_tracking_plan_file(arguments.options.plan);
  if (!of_lines) return capture_failed(of_lines.error());
  if (*of_lines) return capture_lengths(arguments);
  const auto of_volume = app::is_volumetric_plan_file(arguments.options.plan);
  if (!of_volume) return capture_failed(of_volume.error());
  if (*of_volume) return capture_part(arguments);
  const auto plan = app::load_plan(arguments.options.plan, arguments.options.part.value_or(1));
  if (!plan) return capture_failed(plan.error());
  const InterruptGuard guard;
  Display display(arguments.quiet || arguments.run.out == "-", &*plan);
  const app::CaptureObserver observer{
      .reading = [&](const auto& reading) { display.reading(reading); },
      .event = [&](const auto& event) { display.event(event); },
      .notice = [&](const std::string& text) { display.notice(text); },
      .now = [&](const auto& session) { display.now(session); },
      .stopped = [] { return InterruptGuard::interrupted(); },
      .abandoned = {},
  };
  const auto outcome = app::run_capture(arguments.run, arguments.options, observer);
  display.clear();
  if (!outcome) return capture_failed(outcome.error());
  if (!arguments.quiet && arguments.run.out != "-") print_end(*outcome, arguments.run);
  return capture_exit_code(outcome->result.readings.size(), outcome->result.approaches);
}

/// What only the whole command line can tell.
void check(CaptureArguments& arguments) {
  auto& [options, run, give_up, quiet, stops] = arguments;
  if (options.plan.empty()) throw MissingOption("--plan");
  check_stop_flags(stops, options);
  auto live = app::parse_live(run.from);
  if (!live) throw UsageError("--from", live.error().message);
  if (!*live && !run.resume.empty())
    throw UsageError("--resume", "found with a file or - as source, expected with tcp:// or serial://");
  const bool piped = is_piped(run.from);
  if (!*live && run.from != "-" && !piped && !run.raw.empty())
    throw UsageError("--raw", "found with a file as source, expected with tcp://, serial:// or -");
  if (!*live && !give_up.empty())
    throw UsageError("--give-up", "found with a file or - as source, expected with tcp:// or serial://");
  if (*live && run.raw.empty() && run.resume.empty()) {
    if (run.out.empty() || run.out == "-")
      throw UsageError("--raw", "found neither --raw nor --out FILE, expected a place to keep what arrives");
    run.raw = run.out + ".raw";
  }
  if (piped && run.raw.empty() && !run.out.empty() && run.out != "-") run.raw = run.out + ".raw";
  if (*live || app::is_raw(run.from) || !run.raw.empty()) options.recording.skip_damaged = true;
  if (give_up.empty()) return;
  const auto seconds = parse_number(give_up);
  if (!seconds || *seconds < 0.0 || *seconds > 1e6)
    throw UsageError("--give-up", fmt::format("found {}, expected seconds", text::quoted(give_up)));
  run.give_up = Duration::s(*seconds);
}

}  // namespace

void add_capture(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand("capture", "Wait for the targets of a plan in a stream of positions or lengths");
  auto arguments = std::make_shared<CaptureArguments>();
  app::CaptureRun& run = arguments->run;
  verb->add_option("--from", run.from,
                   "Where positions come from: a file, - for the standard input, "
                   "tcp://host:port or serial:///dev/ttyACM0?baud=2000000; with --stops also simulator://?seed=7, with "
                   "preset=good or drift, size=5 (of the bow, µm or µrad) and speed=1, 10 or 60")
      ->type_name("SOURCE")
      ->required();
  verb->add_option("--out", run.out,
                   "Test as JSON, a whole file after every reading; - writes it once, at the end ('axiometry convert' "
                   "makes CSV of it). Of the lines of a tracking plan, or a part of a volumetric plan, the table of "
                   "lengths as CSV, at the end")
      ->type_name("FILE");
  Flag raw = verb->add_option("--raw", run.raw,
                              "File for every byte of a live stream, or of a pipe at -, as it came (the name of "
                              "--out and .raw); never overwritten")
                 ->type_name("FILE");
  verb->add_option("--resume", run.resume, "Play such a file first, then go on with the stream and the file")
      ->type_name("FILE")
      ->excludes(raw);
  verb->add_option("--give-up", arguments->give_up,
                   "How long a source that is not there yet, or away, or closes at once, is tried again (60)")
      ->type_name("S");
  verb->add_flag("--quiet,-q", arguments->quiet, "No lines in the terminal");
  add_capture_flags(*verb, arguments->options);
  add_stop_flags(*verb, arguments->stops, run.keys);
  verb->callback([arguments, &exit_code] {
    check(*arguments);
    exit_code = capture(*arguments);
  });
  verb->footer(R"(Examples:
  axiometry capture --plan x.plan.json --from run.csv --out x.json
  axiometry capture --plan x.plan.json --from tcp://192.168.1.20:5000 --out x.json
  axiometry capture --plan x.plan.json --from serial:///dev/ttyACM0?baud=2000000 --wavelength 632.820 \
    --counts-per-wavelength 8 --out x.json
  axiometry capture --plan x.plan.json --from tcp://192.168.1.20:5000 --resume x.json.raw --out x.json
  axiometry capture --plan x.plan.json --from x.json.raw --out again.json
  axiometry capture --plan lines.json --from tcp://192.168.1.20:5000 --out lengths.csv    lines of a tracking plan
  axiometry capture --plan plan.json --part 2 --from tcp://192.168.1.20:5000 --out S1_T2.csv  part of a volumetric plan
  axiometry capture --plan EYX.json --from tcp://192.168.1.20:5000 --stops keys --unit um --out EYX.csv   a straightness
  axiometry capture --plan EYX.json --from 'simulator://?seed=7&speed=10' --stops keys --out EYX.csv      to try that

Ends when every approach has come, when the stream ends, or with Ctrl-C; what has come is kept.
Of a rotary axis an instrument may show the same again after each turn: its angles are counted on.

Exit codes: 0 every reading of the plan has come, 1 usage, 2 bad input, 5 ended before, or readings are missing,
130 Ctrl-C.)");
}

}  // namespace axiometry::cli
