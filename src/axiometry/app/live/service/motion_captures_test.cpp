// SPDX-License-Identifier: Apache-2.0
// Captures of a straightness that run while nobody waits for them, over an archive.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/files/output.h"
#include "axiometry/app/live/runs/motion_run.h"
#include "axiometry/app/live/service/piece_server_test_support.h"
#include "axiometry/app/live/service/table_captures_test_support.h"
#include "axiometry/formats/motions/motion_csv.h"
#include "axiometry/formats/plan/plan_json.h"
#include "tests/support/made_up_motion.h"

namespace axiometry::app {
namespace {

using capture::StopKey;
using testing::Contains;
using testing::HasSubstr;
using testing_support::DrivenAxis;
using testing_support::FedServer;
using testing_support::PieceServer;
using testing_support::straightness_plan;
using testing_support::true_straightness_um;
using Stage = CaptureState::Stage;
using OptionTexts = std::vector<std::pair<std::string, std::string>>;

/// Two targets, there and back.
Plan brief_plan() {
  Plan plan = straightness_plan();
  plan.targets.pop_back();
  plan.runs = 1;
  return plan;
}

/// Time, position, reading, trigger, of the samples from one time to before another.
std::string driven_lines(const DrivenAxis& axis, double from_s, double to_s) {
  std::string text;
  for (const auto& s : axis.samples())
    if (s.time_s >= from_s && s.time_s < to_s)
      text += fmt::format("{:.2f},{:.4f},{:.4f},{}\n", s.time_s, s.position_mm, s.value_um, s.trigger ? 1 : 0);
  return text;
}
constexpr const char* driven_head = "time_s,position_mm,straightness_um,trigger\n";
constexpr double for_ever_s = 1e9;
std::string driven_stream(const Plan& plan) { return driven_head + driven_lines(DrivenAxis(plan), 0.0, for_ever_s); }

OptionTexts told_by(const char* stops, OptionTexts more = {}) {
  more.insert(more.begin(), {{"stops", stops}, {"stream-axis", "2"}});
  return more;
}
const OptionTexts triggered = {{"stop-column", "3"}, {"give-up", "0"}};

std::string reading_rows(const std::string& table) {
  return table.substr(std::min(table.find("position_mm,run"), table.size()));
}

class MotionCaptures : public testing_support::TableCaptures {
 protected:
  static CaptureWish wish(const Plan& plan, OptionTexts options, const std::string& source = "laser") {
    return {.plan = 7, .whole = plan, .source = source, .layout = {}, .options = std::move(options), .actor = "me"};
  }

  /// What `axiometry capture` makes of the same bytes.
  std::string by_command_line(const Plan& plan, const std::string& bytes) const {
    const std::string folder = archive_folder(), table = folder + "/eyx.csv";
    EXPECT_TRUE(write_file(folder + "/plan.json", formats::write_plan(plan)));
    EXPECT_TRUE(write_file(folder + "/run.csv", bytes));
    CaptureOptions options;
    options.plan = folder + "/plan.json";
    options.recording.axis = 1;
    options.recording.axis_stated = true;
    options.motion.emplace();
    options.motion->sign = capture::StopSign::trigger;
    options.motion->stop_column = 2;
    const CaptureRun run{.from = folder + "/run.csv", .raw = {}, .resume = {}, .out = table};
    EXPECT_TRUE(run_motion_capture(run, options, {}));
    return file_bytes(table).value_or("");
  }
  std::string archive_folder() const { return std::filesystem::path(folder_).parent_path(); }

  /// Sends the samples up to a second behind the begin of a stop, says something there, and sends those to its end.
  CaptureState at_stop(CaptureService& service, store::Id id, std::size_t stop, StopKey key) {
    const auto place = axis_.stops()[stop];
    const double heard_um = send_until(place.begin_s + 1.0);
    const auto heard = wait_for(service, id, [&](const CaptureState& s) {
      return s.motion->now && std::abs(*s.motion->now - heard_um) < 1e-3;
    });
    EXPECT_TRUE(service.press(id, key));
    wait_for(service, id, [&](const CaptureState& s) { return s.motion->is_reading || s.due != heard.due; });
    if (key == StopKey::take) send_until(place.end_s);
    return wait_for(service, id, [&](const CaptureState& s) { return s.due != heard.due || has_ended(s.stage); });
  }
  /// What is heard then: the last reading waits for the time of the next.
  double send_until(double time_s) {
    server_.send(driven_lines(axis_, sent_s_, time_s));
    sent_s_ = time_s;
    double heard_um = 0.0, last_um = 0.0;
    for (const auto& s : axis_.samples())
      if (s.time_s < time_s) heard_um = std::exchange(last_um, s.value_um);
    return heard_um;
  }

  FedServer server_;
  DrivenAxis axis_{brief_plan()};
  double sent_s_ = 0.0;
};

TEST_F(MotionCaptures, KeepsTheTableThatTheCommandLineWouldHaveWritten) {
  const Plan plan = straightness_plan();
  const std::string bytes = driven_stream(plan);
  const PieceServer server({bytes});
  const auto service = open({server.source()});
  const auto started = service->start(wish(plan, told_by("trigger", triggered)));
  ASSERT_TRUE(started) << started.error().to_string();
  EXPECT_EQ(started->approaches, 12u);
  EXPECT_EQ(started->motion->order.error.text(), "EYX");
  const CaptureState end = end_of(*service, started);
  EXPECT_EQ(end.stage, Stage::complete) << end.error;
  EXPECT_FALSE(end.test) << "no positions, so no test";
  ASSERT_TRUE(end.came_to);
  EXPECT_EQ(end.came_to->found, 12u);
  EXPECT_EQ(end.motion->unit, MotionUnit::um);
  ASSERT_TRUE(end.motion->values);
  ASSERT_EQ(end.motion->values->size(), 12u);
  for (const capture::PlannedValue& value : *end.motion->values)
    EXPECT_NEAR(value.still.value, true_straightness_um(plan, value.approach), 0.05);

  const std::string table = service->file_of(end.id, "readings").value_or("");
  EXPECT_EQ(reading_rows(table), reading_rows(by_command_line(plan, service->file_of(end.id, "raw").value_or(""))));
  EXPECT_THAT(table, HasSubstr("# raw recording has SHA-256 " + end.came_to->raw));
  EXPECT_THAT(table, HasSubstr("# error: EYX\n"));
  const auto read = formats::read_motion_csv(table);
  ASSERT_TRUE(read) << read.error().to_string();
  EXPECT_EQ(read->readings.size(), 12u);
  EXPECT_FALSE(service->file_of(end.id, "lengths"));
  EXPECT_FALSE(service->file_of(end.id, "keys")) << "nobody said anything";
}

TEST_F(MotionCaptures, TakesWhatIsSaidAtEachStopAndTakesItBack) {
  const auto service = open({server_.source()});
  const auto started = service->start(wish(brief_plan(), told_by("keys", {{"positive", "+Y"}})));
  ASSERT_TRUE(started) << started.error().to_string();
  const store::Id id = started->id;
  server_.send(driven_head);
  CaptureState state = at_stop(*service, id, 0, StopKey::take);
  ASSERT_EQ(state.motion->values->size(), 1u);
  EXPECT_EQ(state.due->target, 1u);
  const CaptureRevision known = state.revision;
  EXPECT_FALSE(service->state(id, known)->motion->values) << "they are known";

  ASSERT_TRUE(service->press(id, StopKey::undo));
  state = wait_for(*service, id, [](const CaptureState& s) { return s.due && s.due->target == 0; });
  EXPECT_EQ(state.taken, 0u);
  const auto after = service->state(id, known);
  EXPECT_TRUE(after->anew) << "those of before are forgotten";
  EXPECT_TRUE(after->motion->values->empty());
  EXPECT_THAT(state.events.back().message, HasSubstr("is due again"));

  // The target that was taken back is left without a reading, and the others follow.
  state = at_stop(*service, id, 1, StopKey::skip);
  EXPECT_EQ(state.due->target, 1u);
  ASSERT_TRUE(service->press(id, StopKey::take));
  wait_for(*service, id, [](const CaptureState& s) { return s.motion->is_reading; });
  send_until(axis_.stops()[1].end_s);
  wait_for(*service, id, [](const CaptureState& s) { return s.taken == 1; });
  for (const std::size_t stop : {2u, 3u}) state = at_stop(*service, id, stop, StopKey::take);
  state = wait_for(*service, id, [](const CaptureState& s) { return has_ended(s.stage); });
  EXPECT_EQ(state.stage, Stage::complete) << state.error;
  EXPECT_EQ(state.came_to->found, 3u);
  EXPECT_THAT(state.came_to->notes, Contains(HasSubstr("has no reading")));
  EXPECT_THAT(service->file_of(id, "keys").value_or(""), HasSubstr(",undo\n"));
  EXPECT_THAT(service->file_of(id, "readings").value_or(""), HasSubstr("# positive: +Y\n"));
  EXPECT_EQ(service->press(id, StopKey::take).error().kind, ErrorKind::conflict) << "it has ended";
}

TEST_F(MotionCaptures, TakesBackTheLastReadingToo) {
  for_undo_ = Duration::s(3600);
  const auto service = open({server_.source()});
  const store::Id id = service->start(wish(brief_plan(), told_by("keys")))->id;
  server_.send(driven_head);
  for (const std::size_t stop : {0u, 1u, 2u, 3u}) at_stop(*service, id, stop, StopKey::take);
  CaptureState state = wait_for(*service, id, [](const CaptureState& s) { return s.taken == 4; });
  EXPECT_FALSE(state.due);
  EXPECT_FALSE(has_ended(state.stage)) << "the last may have been taken too soon";
  ASSERT_TRUE(service->press(id, StopKey::undo));
  state = wait_for(*service, id, [](const CaptureState& s) { return s.due.has_value(); });
  EXPECT_EQ(state.taken, 3u);
  EXPECT_THAT(state.events.empty() ? "" : state.events.back().message, HasSubstr("is due again"));
  ASSERT_TRUE(service->press(id, StopKey::skip));
  wait_for(*service, id, [](const CaptureState& s) { return !s.due; });
  const auto end = service->stop(id);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->stage, Stage::complete) << end->error;
  EXPECT_EQ(end->came_to->found, 3u);
  EXPECT_EQ(service->press(id, StopKey::undo).error().kind, ErrorKind::conflict);
}

TEST_F(MotionCaptures, GoesOnWithWhatWasSaidBeforeTheProgramEnded) {
  store::Id id = 0;
  {
    const auto service = open({server_.source()});
    id = service->start(wish(brief_plan(), told_by("keys")))->id;
    server_.send(driven_head);
    EXPECT_EQ(at_stop(*service, id, 0, StopKey::take).taken, 1u);
    at_stop(*service, id, 1, StopKey::take);
  }
  server_.hang_up();
  const auto service = open({server_.source()});
  const auto left = service->state(id);
  ASSERT_TRUE(left) << left.error().to_string();
  EXPECT_EQ(left->stage, Stage::interrupted);
  EXPECT_EQ(left->motion->order.sign, capture::StopSign::keys);
  ASSERT_TRUE(service->resume(id));
  const CaptureState again = wait_for(*service, id, [](const CaptureState& s) { return s.taken == 2; });
  EXPECT_EQ(again.due->direction, Direction::down);
  for (const std::size_t stop : {2u, 3u}) at_stop(*service, id, stop, StopKey::take);
  const CaptureState end = wait_for(*service, id, [](const CaptureState& s) { return has_ended(s.stage); });
  EXPECT_EQ(end.stage, Stage::complete) << end.error;
  EXPECT_EQ(end.came_to->found, 4u);
  EXPECT_FALSE(std::filesystem::exists(fmt::format("{}/capture-{}.raw.keys", folder_, id))) << "the archive has them";
}

TEST_F(MotionCaptures, OneThatIsEndedEarlyKeepsWhatCameUntilItIsDiscarded) {
  store::Id id = 0;
  {
    const auto service = open({server_.source()});
    id = service->start(wish(brief_plan(), told_by("keys")))->id;
    server_.send(driven_head);
    at_stop(*service, id, 0, StopKey::take);
    const auto end = service->stop(id);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->stage, Stage::stopped);
    EXPECT_EQ(end->came_to->found, 1u);
    EXPECT_THAT(end->came_to->notes, Contains(HasSubstr("the recording ended before")));
  }
  folder_ = archive_folder() + "/elsewhere";
  const auto service = open();
  ASSERT_EQ(service->states().size(), 1u) << "the archive lists it";
  const CaptureState listed = service->states().front();
  EXPECT_EQ(listed.motion->order.error.text(), "EYX");
  EXPECT_EQ(listed.plan, 7);
  EXPECT_EQ(reading_rows(service->file_of(listed.id, "readings").value_or("")).substr(0, 11), "position_mm");
  EXPECT_EQ(service->task_of(listed).error().kind, ErrorKind::not_found) << "there are no lengths";
  ASSERT_TRUE(service->discard(listed.id, "me"));
  EXPECT_TRUE(service->states().empty());
  EXPECT_TRUE(open()->states().empty());
}

TEST_F(MotionCaptures, WithoutReadingsTheRecordingAloneIsKept) {
  const PieceServer server({driven_stream(brief_plan())});
  const auto service = open({server.source()});
  const CaptureState end =
      end_of(*service, service->start(wish(brief_plan(), told_by("keys", {{"give-up", "0"}}))));
  EXPECT_EQ(end.stage, Stage::stopped);
  EXPECT_THAT(end.error, HasSubstr("found no reading for any of the 4 approaches"));
  EXPECT_FALSE(end.came_to->raw.empty());
  EXPECT_TRUE(end.came_to->table.empty());
}

TEST_F(MotionCaptures, HaveNoTableOfPositionsThatBelongToAnotherPlan) {
  const DrivenAxis axis(straightness_plan());
  std::string elsewhere = driven_head;
  for (const auto& s : axis.samples())
    elsewhere += fmt::format("{:.2f},{:.4f},{:.4f},0\n", s.time_s, s.position_mm + (s.position_mm > 50.0 ? 37.0 : 0.0),
                             s.value_um);
  const PieceServer server({elsewhere});
  const auto service = open({server.source()});
  const CaptureState end = end_of(
      *service,
      service->start(wish(straightness_plan(), told_by("position", {{"stop-column", "1"}, {"give-up", "0"}}))));
  EXPECT_EQ(end.stage, Stage::failed);
  EXPECT_THAT(end.error, HasSubstr("the recording belongs to another plan"));
  EXPECT_FALSE(end.came_to->raw.empty());
  EXPECT_TRUE(end.came_to->table.empty());
}

TEST_F(MotionCaptures, AFailingWishBeginsNothing) {
  const auto service = open({server_.source()});
  const auto refusal = [&](const Plan& plan, const OptionTexts& options, const std::string& source = "laser") {
    const auto started = service->start(wish(plan, options, source));
    return started ? "" : started.error().message;
  };
  EXPECT_THAT(refusal(brief_plan(), told_by("keys"), "simulator"),
              HasSubstr("stream-axis: found 2 with the simulator, expected 1 or none"));
  EXPECT_THAT(refusal(brief_plan(), {}), HasSubstr("found a plan made for EYX, expected one of positions"));
  EXPECT_THAT(refusal(brief_plan(), {{"unit", "um"}}), HasSubstr("found what is said of stops without stops"));
  EXPECT_THAT(refusal(brief_plan(), told_by("bells")), HasSubstr("stops: found \"bells\""));
  EXPECT_THAT(refusal(brief_plan(), told_by("keys", {{"unit", "cubit"}})), HasSubstr("unit: found the unit \"cubit\""));
  EXPECT_THAT(refusal(brief_plan(), told_by("keys", {{"part", "1"}})), HasSubstr("found a part beside stops"));
  EXPECT_THAT(refusal(brief_plan(), told_by("position")), HasSubstr("found no column of the position"));
  Plan several = brief_plan();
  several.further = {brief_plan()};
  EXPECT_THAT(refusal(several, told_by("keys")), HasSubstr("found a plan with further plans"));
  EXPECT_TRUE(service->states().empty());
  EXPECT_EQ(service->press(1, StopKey::take).error().kind, ErrorKind::not_found);
}

TEST_F(MotionCaptures, NothingIsSaidWhereThePositionTellsTheStops) {
  const auto service = open({server_.source()});
  const auto started =
      service->start(wish(brief_plan(), told_by("position", {{"stop-column", "1"}, {"give-up", "0"}})));
  ASSERT_TRUE(started) << started.error().to_string();
  EXPECT_EQ(service->press(started->id, StopKey::take).error().kind, ErrorKind::conflict);
  server_.send(driven_head);
  send_until(for_ever_s);
  server_.hang_up();
  const CaptureState end = end_of(*service, started);
  EXPECT_EQ(end.stage, Stage::complete) << end.error;
  EXPECT_EQ(end.came_to->found, 4u);
}

}  // namespace
}  // namespace axiometry::app
