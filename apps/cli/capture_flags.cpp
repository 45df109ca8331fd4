// SPDX-License-Identifier: Apache-2.0
#include "capture_flags.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <limits>
#include <string>

#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"

namespace axiometry::cli {
namespace {

/// Numbers that a flag may have, the bounds included.
struct Bounds {
  double lowest = -1e9;
  double highest = 1e9;
};
constexpr const char* capture_flags[] = {
    "--part",     "--stream",        "--units-per-count", "--wavelength",  "--counts-per-wavelength",
    "--rate",     "--stream-axis",   "--skip-damaged",    "--rest-window", "--rest-threshold",
    "--settling", "--shortest-rest", "--target-window",   "--reverse",     "--datum",
    "--zero"};
constexpr Bounds positive{1e-12, 1e12};
constexpr Bounds not_negative{0.0, 1e12};

CLI::Option* add_number(CLI::App& verb, const std::string& name, const std::string& type, Bounds bounds,
                        std::function<void(double)> put, const std::string& help) {
  return verb
      .add_option_function<std::string>(
          name,
          [name, bounds, put = std::move(put)](const std::string& word) {
            const auto number = parse_number(word);
            if (!number || *number < bounds.lowest || *number > bounds.highest)
              throw CLI::ValidationError(
                  name, fmt::format("found {}, expected a number{}", text::quoted(word),
                                    bounds.lowest >= 0.0 ? (bounds.lowest > 0.0 ? " above 0" : " of 0 or more") : ""));
            put(*number);
          },
          help)
      ->type_name(type);
}

void add_count(CLI::App& verb, const std::string& name, std::function<void(std::size_t)> put, const std::string& help) {
  add_number(
      verb, name, "N", {1, 1e6},
      [name, put = std::move(put)](double number) {
        const auto whole = static_cast<std::size_t>(number);
        if (static_cast<double>(whole) != number)
          throw CLI::ValidationError(name, fmt::format("found {}, expected a whole number", number));
        put(whole);
      },
      help);
}

void add_stream_flags(CLI::App& verb, app::CaptureOptions& o) {
  verb.add_option("--stream", o.stream,
                  "Layout of the stream instead of recognising it: umd, time-position, npy, camonitor")
      ->type_name("ID");
  add_number(
      verb, "--units-per-count", "MM", {}, [&](double x) { o.recording.units_per_count = x; },
      "mm or degrees per count, for streams of counts");
  add_number(
      verb, "--wavelength", "NM", positive, [&](double x) { o.wavelength_nm = x; },
      "Wavelength of the laser in the air of the test, nm, for streams of counts");
  add_number(
      verb, "--counts-per-wavelength", "N", positive, [&](double x) { o.counts_per_wavelength = x; },
      "Counts for a wavelength of travel: 2, 4 or 8 after the optics");
  add_number(
      verb, "--rate", "HZ", positive, [&](double x) { o.recording.rate_hz = x; },
      "Samples per second, for streams that do not tell it");
  add_count(
      verb, "--stream-axis", [&](std::size_t n) { o.recording.axis = n - 1; },
      "Which axis or column of a stream of several (1)");
  verb.add_flag(
      "--skip-damaged", o.recording.skip_damaged,
      "Count lines that are no samples as lost instead of refusing the recording; always so for live streams");
}

void add_rest_flags(CLI::App& verb, app::CaptureOptions& o) {
  add_number(
      verb, "--rest-window", "S", positive, [&](double x) { o.rest_window = Duration::s(x); },
      "Time over which rest is judged (a quarter of the plan's dwell, 0.1 to 1 s)");
  add_number(
      verb, "--rest-threshold", "MM", positive, [&](double x) { o.rest_threshold = Position::native(x); },
      "Range of the means in that time, mm or degrees, up to which the axis rests (follows the noise)");
  add_number(
      verb, "--settling", "S", not_negative, [&](double x) { o.settling = Duration::s(x); },
      "Time after a stop that is not averaged (the window)");
  add_number(
      verb, "--shortest-rest", "S", positive, [&](double x) { o.shortest_rest = Duration::s(x); },
      "Shorter standstills are not used (half the plan's dwell)");
}

void add_match_flags(CLI::App& verb, app::CaptureOptions& o) {
  add_number(
      verb, "--target-window", "MM", positive, [&](double x) { o.matcher.window = Position::native(x); },
      "Farthest from a target, mm or degrees (a quarter of the smallest interval, half the overrun at most)");
  verb.add_flag("--reverse", o.matcher.reversed, "The instrument counts up when the axis moves down");
  CLI::Option* datum = add_number(
      verb, "--datum", "POSITION", {}, [&](double x) { o.matcher.datum = Position::native(x); },
      "Where on the axis the instrument shows zero, mm or degrees (0)");
  verb.add_option_function<std::string>(
          "--zero",
          [&](const std::string& word) {
            if (word != "first-target")
              throw CLI::ValidationError("--zero", fmt::format("found {}, expected first-target", text::quoted(word)));
            o.matcher.zero_at_first_target = true;
          },
          "first-target: the first standstill at target 1 is its nominal position; the constant is reported")
      ->type_name("WHERE")
      ->excludes(datum);
}

}  // namespace

void add_capture_flags(CLI::App& verb, app::CaptureOptions& options) {
  CLI::Option_group* group = verb.add_option_group("Continuous recordings");
  group->add_option("--plan", options.plan, "The plan the axis moved after (see 'axiometry plan')")->type_name("FILE");
  add_count(
      *group, "--part", [&](std::size_t n) { options.part = n; },
      "Of a plan with further ones: 1 is the plan itself (1)");
  add_stream_flags(*group, options);
  add_rest_flags(*group, options);
  add_match_flags(*group, options);
}

void check_capture_flags(const CLI::App& verb) {
  if (verb.count("--plan") > 0) return;
  for (const char* flag : capture_flags)
    if (verb.count(flag) > 0)
      throw CLI::ValidationError(flag, "found without --plan, expected with a continuous recording and its plan");
}

}  // namespace axiometry::cli
