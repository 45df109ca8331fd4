// SPDX-License-Identifier: Apache-2.0
#include "captures.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "axiometry/app/files/source.h"
#include "axiometry/app/live/runs/capture_run.h"
#include "axiometry/app/live/service/capture_keeping.h"
#include "axiometry/app/recordings/raw_log.h"
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/store/database/clock.h"
#include "simulated_clock.h"
#include "tests/support/simulated_recording.h"

namespace axiometry::world {
namespace {

using testing_support::lines_of;
using testing_support::short_plan;
using testing_support::TimedLine;

constexpr const char* layouts[] = {"time-position", "camonitor-stream", "umd"};
constexpr std::uint64_t seeds = 4;  // of recordings, which take longer to make than to read
constexpr std::size_t largest_file = std::size_t{64} << 20;

const std::vector<TimedLine>& recording(const std::string& layout, std::uint64_t seed) {
  static std::map<std::pair<std::string, std::uint64_t>, std::vector<TimedLine>> made;
  auto& lines = made[{layout, seed}];
  if (lines.empty()) lines = lines_of(layout, 1, seed);
  return lines;
}

/// Sends lines from where the last one ended; what came while nobody listened is lost.
class SimulatedSource final : public app::LiveStream {
 public:
  SimulatedSource(const std::vector<TimedLine>& lines, std::size_t& sent, Chance& chance)
      : lines_(lines), sent_(sent), chance_(chance) {}

  Got read(std::span<char> buffer, std::chrono::milliseconds longest) override {
    if (chance_() % 40 == 0) {
      pass_ms(static_cast<int>(longest.count()));
      return {};
    }
    if (chance_() % 150 == 0) return {State::closed, 0, "closed by the other side"};
    std::string piece;
    if (std::exchange(is_new_, false)) {
      if (chance_() % 3 == 0) piece = "an instrument's greeting\n";
      if (chance_() % 12 == 0)
        for (int k = 0; k < 120; ++k) piece += "out of order\n";
    }
    const std::size_t most = 1 + chance_() % 60;
    for (std::size_t k = 0; k < most && sent_ < lines_.size(); ++k, ++sent_) {
      piece += lines_[sent_].text;
      pass_ms(10);
    }
    if (piece.empty()) return {State::over};
    if (chance_() % 30 == 0) piece.resize(piece.size() / 2 + 1);  // bytes are lost on the way
    std::ranges::copy(piece, buffer.begin());
    return {State::data, piece.size()};
  }

 private:
  const std::vector<TimedLine>& lines_;
  std::size_t& sent_;
  Chance& chance_;
  bool is_new_ = true;
};

Result<app::CaptureSession> session_of(const app::CaptureOrder& order, const std::string& layout) {
  app::CaptureOptions options;
  options.stream = layout;
  options.recording.skip_damaged = true;
  if (layout == "umd") options.recording.units_per_count = 1e-4;
  return app::CaptureSession::open(order.walked, options);
}

bool same(const capture::CapturedReading& a, const capture::CapturedReading& b) {
  return a.approach == b.approach && a.deviation == b.deviation && a.standstill.count == b.standstill.count;
}

std::string text_of(const capture::CapturedReading& reading) {
  return fmt::format("run {} target {} deviation {} of {} samples{}", reading.approach.run + 1,
                     reading.approach.target + 1, reading.deviation.in_native(), reading.standstill.count,
                     reading.standstill.cut_off ? ", cut off" : "");
}

/// What people saw first is what is there first.
template <typename Readings>
void expect_begins_with(const Readings& found, const Readings& told, std::string_view where) {
  for (std::size_t k = 0; k < told.size(); ++k)
    if (k >= found.size() || !same(found[k], told[k]))
      broken(fmt::format("{}: reading {} of {} is not as it was told: {}, told {}", where, k + 1, told.size(),
                         k < found.size() ? text_of(found[k]) : "none", text_of(told[k])));
}

/// What may end a capture on a disk in good order.
void expect_good_reason(std::string_view message) {
  for (const std::string_view reason :
       {"nobody answers", "lines in a row", "found no ", "found 0 ", "found 1 of ", "found readings at "})
    if (message.contains(reason)) return;
  broken(fmt::format("a capture failed without trouble: {}", message));
}

}  // namespace

void Captures::wish(Life& life, const std::string& folder, const SimulatedDisk& disk) {
  app::CaptureFolder captures(folder);
  const auto left = captures.left_behind();
  if (left.empty() || chance_() % 3 == 0) return begin(life, folder, disk);
  const store::Id id = left[chance_() % left.size()].id;
  auto held = captures.take(id);
  if (!held) return expect(disk.was_troubled(), "a capture cannot be gone on with: " + held.error().to_string());
  const std::string raw = app::file_bytes(held->raw(), largest_file).value_or("");
  const auto kept = app::keeping_in(life.workbench()).kept(*held);
  if (!kept) return expect(disk.was_troubled(), "a capture cannot be looked for: " + kept.error().to_string());
  if (!*kept) return run(life, *std::move(held), captures_.at(id), true, disk);
  note_kept(captures_.at(id), *kept, raw);
  held->remove();
}

std::optional<store::Id> Captures::plan(Life& life, const SimulatedDisk& disk) {
  if (plan_) return plan_;
  json::Value body = json::Value::object();
  body.add("plan", formats::write_plan(short_plan()));
  const server::Response response = life.ask("POST", "/api/plans", json::dump(body));
  if (response.status < 400) return plan_ = number_of(parsed(response), "id");
  expect(disk.was_troubled(), "a plan cannot be kept: " + response.body);
  return {};
}

void Captures::begin(Life& life, const std::string& folder, const SimulatedDisk& disk) {
  const auto after = plan(life, disk);
  if (!after) return;
  app::CaptureFolder captures(folder);
  const std::string layout = layouts[chance_() % std::size(layouts)];
  auto held = captures.add({.plan = *after,
                            .part = 1,
                            .walked = short_plan(),
                            .source = "the instrument",
                            .layout = layout,
                            .options = {},
                            .actor = "A. Tester",
                            .started = store::now_text()});
  if (!held) return expect(disk.was_troubled(), "a capture cannot begin: " + held.error().to_string());
  const auto [capture, is_new] = captures_.try_emplace(held->id());
  expect(is_new, "two captures have one number");
  capture->second.layout = layout;
  capture->second.seed = chance_() % seeds;
  run(life, *std::move(held), capture->second, false, disk);
}

void Captures::run(Life& life, app::HeldCapture held, Capture& capture, bool resumes, const SimulatedDisk& disk) {
  const auto& lines = recording(capture.layout, capture.seed);
  app::LiveCapture live{.name = "run.raw",
                        .connect = [&]() -> Result<std::unique_ptr<app::LiveStream>> {
                          if (chance_() % 8 == 0) return fail("nobody answers");
                          return std::make_unique<SimulatedSource>(lines, capture.sent, chance_);
                        },
                        .raw = resumes ? "" : held.raw(),
                        .resume = resumes ? held.raw() : "",
                        .give_up = Duration::s(20),
                        .free = [](const std::string&) { return std::optional(std::uint64_t{1} << 40); }};
  Readings told;
  std::optional<Test> test;
  std::size_t until_killed = chance_() % 3 == 0 ? chance_() % 200 : SIZE_MAX;
  std::size_t until_stopped = chance_() % 4 == 0 ? chance_() % 200 : SIZE_MAX;
  const app::CaptureObserver observer{.reading =
                                          [&](const capture::CapturedReading& reading) {
                                            if (!disk.has_power())
                                              broken("a reading was told that cannot be on the disk");
                                            told.push_back(reading);
                                          },
                                      .event = {},
                                      .notice = {},
                                      .now =
                                          [&](const app::CaptureSession& session) {
                                            if (auto made = session.test()) test = *std::move(made);
                                          },
                                      .stopped = [&] { return until_stopped == 0 || until_stopped-- == 0; },
                                      .abandoned = [&] { return until_killed == 0 || until_killed-- == 0; }};
  auto session = session_of(held.order(), capture.layout);
  expect(session.has_value(), "a capture that was begun cannot be opened");
  const auto outcome = app::run_live_capture(*std::move(session), live, observer);
  if (!outcome && until_killed > 0 && !disk.was_troubled()) expect_good_reason(outcome.error().message);
  const bool nobody_answers = !outcome && outcome.error().message.contains("nobody answers");
  if (told.size() < capture.told.size() && (until_killed == 0 || nobody_answers || disk.was_troubled())) {
    if (!told.empty() && told.back().standstill.cut_off) told.pop_back();  // by that end, in the middle of the playing
    expect_begins_with(capture.told, told, "played until it ended");
  } else {
    expect_begins_with(told, capture.told, "gone on with");
    capture.told = std::move(told);
  }
  if (!disk.has_power() || until_killed == 0) return;
  if (outcome) test = outcome->test;
  keep(life, held, capture, std::move(test), &disk);
}

void Captures::keep(Life& life, app::HeldCapture& held, Capture& capture, std::optional<Test> test,
                    const SimulatedDisk* disk) {
  const bool is_test = test.has_value();
  const std::string raw = app::file_bytes(held.raw(), largest_file).value_or("");
  const auto kept = app::keeping_in(life.workbench()).keep({held, std::move(test)});
  if (!kept)
    return expect(disk != nullptr && disk->was_troubled(), "a capture cannot be kept: " + kept.error().to_string());
  expect(!is_test || kept->has_value(), "a capture was kept without its test");
  note_kept(capture, *kept, raw);
  held.remove();
}

void Captures::note_kept(Capture& capture, std::optional<store::Id> test, const std::string& raw) {
  expect(!capture.test || test == capture.test, "a capture was kept twice");
  capture.kept = true;
  capture.test = test;
  capture.raw = raw;
}

/// Nothing where the disk is in trouble again: what cannot be brought onto it is not played to be kept.
std::optional<Captures::Readings> Captures::played(const app::CaptureOrder& order, const std::string& raw,
                                                   const std::string& layout) {
  Readings readings;
  const app::CaptureObserver observer{
      .reading = [&](const capture::CapturedReading& reading) { readings.push_back(reading); },
      .event = {},
      .notice = {},
      .now = {},
      .stopped = {},
      .abandoned = {}};
  const auto outcome = app::run_live_capture(*session_of(order, layout),
                                             {.name = "run.raw", .connect = {}, .raw = {}, .resume = raw}, observer);
  if (!outcome && outcome.error().message.contains("cannot write")) return {};
  return outcome ? outcome->result.readings : readings;
}

void Captures::check(Life& life, const std::string& folder, const SimulatedDisk* disk) {
  app::CaptureFolder captures(folder);
  const auto left = captures.left_behind();
  for (const auto& [id, capture] : captures_) {
    if (capture.kept) {
      check_kept(life, capture, disk);
      continue;
    }
    if (capture.told.empty()) continue;
    const auto found = std::ranges::find(left, id, &app::CaptureFolder::Left::id);
    if (found == left.end()) broken(fmt::format("capture {} with {} readings is gone", id, capture.told.size()));
    const std::string raw = fmt::format("{}/capture-{}.raw", folder, id);
    const auto once = played(found->order, raw, capture.layout);
    const auto twice = played(found->order, raw, capture.layout);
    expect((once && twice) || (disk != nullptr && disk->was_troubled()), "a recording cannot be played");
    if (once) expect_begins_with(*once, capture.told, "played again");
    if (!once || !twice) continue;
    expect(once->size() == twice->size(), "a recording gives other readings when it is played twice");
    expect_begins_with(*twice, *once, "played twice");
  }
}

void Captures::check_kept(Life& life, const Capture& capture, const SimulatedDisk* disk) {
  if (!capture.test) return;
  const auto documents = life.store().documents(*capture.test);
  if (!documents && disk != nullptr && disk->was_troubled()) return;
  expect(documents.has_value(), "a captured test is not there");
  const auto raw = std::ranges::find_if(*documents, [](const auto& d) { return d.name.ends_with(".raw"); });
  expect(raw != documents->end(), "a captured test is without its recording");
  const server::Response response = life.ask("GET", fmt::format("/api/documents/{}", raw->id));
  if (response.status >= 500 && disk != nullptr && disk->was_troubled()) return;
  expect(response.body == capture.raw, "a recording is not in the archive as it was");
}

std::size_t Captures::readings() const {
  std::size_t sum = 0;
  for (const auto& [id, capture] : captures_) sum += capture.told.size();
  return sum;
}

void Captures::conclude_all(Life& life, const std::string& folder) {
  check(life, folder, nullptr);
  app::CaptureFolder captures(folder);
  for (const app::CaptureFolder::Left& left : captures.left_behind()) {
    auto held = captures.take(left.id);
    expect(held.has_value(), "a capture that is left cannot be taken");
    Capture& capture = captures_.at(left.id);
    std::optional<Test> test;
    const auto outcome =
        app::run_live_capture(*session_of(left.order, capture.layout),
                              {.name = "run.raw", .connect = {}, .raw = {}, .resume = held->raw()}, {});
    if (outcome) test = outcome->test;
    keep(life, *held, capture, std::move(test), nullptr);
    check_kept(life, capture, nullptr);
  }
  expect(captures.left_behind().empty(), "a capture that was kept is still there");
}

}  // namespace axiometry::world
