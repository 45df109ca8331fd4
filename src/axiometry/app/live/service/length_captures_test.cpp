// SPDX-License-Identifier: Apache-2.0
// Captures of lengths that run while nobody waits for them, over an archive.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "axiometry/app/files/source.h"
#include "axiometry/app/live/lengths/length_plans_test_support.h"
#include "axiometry/app/live/service/piece_server_test_support.h"
#include "axiometry/app/live/service/table_captures_test_support.h"
#include "axiometry/app/live/sources/simulated_lengths.h"
#include "axiometry/app/recordings/length_capture.h"
#include "axiometry/app/volumetric/part_lengths.h"
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"

namespace axiometry::app {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using testing_support::lines_task;
using testing_support::PieceServer;
using testing_support::volume_points;
using testing_support::volume_task;
using Stage = CaptureState::Stage;
using namespace std::chrono_literals;

class LengthCaptures : public testing_support::TableCaptures {
 protected:
  static LengthWish wish(LengthTask task, std::vector<std::pair<std::string, std::string>> options = {},
                         const std::string& source = "simulator") {
    const bool has_speed = std::ranges::any_of(options, [](const auto& option) { return option.first == "speed"; });
    if (source == "simulator" && !has_speed) options.emplace_back("speed", "60");
    return {.task = std::move(task), .source = source, .layout = {}, .options = std::move(options), .actor = "me"};
  }

  /// All that the simulator says of a part.
  static std::string recording_of(const LengthTask& task) {
    const auto connect = simulated_lengths_source({.task = task, .seed = 3, .pace = {.speed = 1e9}});
    auto stream = (*connect)();
    std::string bytes(std::size_t{1} << 20, '\0');
    std::string whole;
    while (true) {
      const LiveStream::Got got = (*stream)->read(bytes, 100ms);
      if (got.state == LiveStream::State::over) return whole;
      whole.append(bytes, 0, got.count);
    }
  }
};

TEST_F(LengthCaptures, KeepsAPartOfAVolumeAsItsRecordingAndTheTableThatItGives) {
  const auto service = open();
  const auto started = service->start(wish(volume_task(2)));
  ASSERT_TRUE(started) << started.error().to_string();
  EXPECT_EQ(started->approaches, volume_points);
  EXPECT_EQ(started->lengths->due, 0u);
  const CaptureState end = end_of(*service, started);
  EXPECT_EQ(end.stage, Stage::complete) << end.error;
  EXPECT_FALSE(end.test);
  ASSERT_TRUE(end.came_to);
  EXPECT_EQ(end.came_to->found, volume_points);
  ASSERT_TRUE(end.lengths->caught);
  EXPECT_EQ(end.lengths->caught->size(), volume_points);
  EXPECT_EQ(end.taken, volume_points);

  const std::string raw = service->file_of(end.id, "raw").value_or("");
  const std::string table = service->file_of(end.id, "lengths").value_or("");
  Source source = Source::of_bytes("run.csv", raw);
  const auto again = read_part_recording(source, *volume_task(2).volume(), PartRange{2, 2}, false, {});
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_THAT(table, HasSubstr(formats::write_volumetric_lengths(again->lengths))) << "as from the file";
  EXPECT_THAT(table, HasSubstr("Simulated, not measured"));
  EXPECT_THAT(table, HasSubstr("raw recording: SHA-256 " + end.came_to->raw));
  for (std::size_t k = 0; k < volume_points; ++k)
    EXPECT_NEAR((*end.lengths->caught)[k].length_mm, again->lengths.readings[k].length_mm, 1e-9);
  EXPECT_FALSE(service->file_of(end.id, "plan"));
}

/// The last two points are equally far from the station but for 0.2 mm.
TEST_F(LengthCaptures, DoesNotEndAtAPointThatOnlyLooksLikeTheLast) {
  volumetric::CalibrationPlan plan = testing_support::volume_plan();
  plan.machine.tools[0].offset_mm = {0.0, 0.0, -120.0};
  plan.machine.stations[0].at_mm = {-100.0, -50.0, -700.0};
  plan.runs[0].stops.clear();
  for (const Vector3 q : {Vector3{655.338, 335.522, -225.15},
                          {587.366, 348.653, -76.048},
                          {732.028, 13.131, -350.899},
                          {510.676, 171.044, -450.3},
                          {442.704, 184.174, -301.198},
                          {366.014, 6.565, -175.449},
                          {76.69, 177.609, -125.749},
                          {221.352, 342.087, -400.599}})
    plan.runs[0].stops.push_back({q});
  const auto service = open();
  const CaptureState end = end_of(*service, service->start(wish(volume_task(1, plan))));
  EXPECT_EQ(end.stage, Stage::complete) << end.error;
  EXPECT_EQ(end.came_to->found, 8u) << testing::PrintToString(end.came_to->notes);
}

TEST_F(LengthCaptures, KeepsALineAndAllLinesOfATrackingPlan) {
  const auto service = open();
  const CaptureState one = end_of(*service, service->start(wish(lines_task(2))));
  const CaptureState all = end_of(*service, service->start(wish(lines_task(0))));
  EXPECT_EQ(one.stage, Stage::complete) << one.error;
  EXPECT_EQ(all.stage, Stage::complete) << all.error;
  EXPECT_EQ(one.lengths->order.plan_id, all.lengths->order.plan_id);
  const auto joined = joined_tables(lines_task(0), {{"capture 1", *service->file_of(one.id, "lengths")},
                                                    {"capture 2", *service->file_of(all.id, "lengths")}});
  ASSERT_TRUE(joined) << joined.error().message;
  EXPECT_THAT(*joined, HasSubstr("line xz: the lengths of capture 1 are left out"));
  EXPECT_EQ(one.came_to->found, lines_task(2).stop_count());
  EXPECT_EQ(all.came_to->found, lines_task(0).stop_count());
}

TEST_F(LengthCaptures, TellsWhereTheBeamWasBroken) {
  const auto service = open();
  const CaptureState end = end_of(*service, service->start(wish(volume_task(1), {{"preset", "broken-beam"}})));
  EXPECT_EQ(end.stage, Stage::complete) << end.error;
  ASSERT_EQ(end.lengths->broken_before.size(), 1u) << testing::PrintToString(end.came_to->notes);
  EXPECT_THAT(end.came_to->notes, Contains(HasSubstr("have another dead path")));
  const std::size_t broken = end.lengths->broken_before.front();
  EXPECT_THAT(end.came_to->notes, Contains(HasSubstr(fmt::format("before point {} ", broken + 1))));
  const CaptureState good = end_of(*service, service->start(wish(volume_task(1))));
  EXPECT_TRUE(good.lengths->broken_before.empty());
}

TEST_F(LengthCaptures, TheBeamIsBrokenWhateverTheSeed) {
  const auto service = open();
  std::vector<Result<CaptureState>> begun;
  for (const char* seed : {"1", "2", "3", "4", "5", "6"})
    begun.push_back(service->start(wish(volume_task(1), {{"preset", "broken-beam"}, {"seed", seed}})));
  begun.push_back(service->start(wish(lines_task(0), {{"preset", "broken-beam"}})));
  begun.push_back(service->start(wish(lines_task(2), {{"preset", "broken-beam"}})));
  for (const auto& one : begun) {
    const CaptureState end = end_of(*service, one);
    EXPECT_EQ(end.lengths->broken_before.size(), 1u) << testing::PrintToString(end.came_to->notes);
    EXPECT_EQ(end.came_to->found, end.approaches);
  }
}

TEST_F(LengthCaptures, TellsLengthsOnlyWhereTheyChanged) {
  const auto service = open();
  const CaptureState end = end_of(*service, service->start(wish(volume_task(1))));
  EXPECT_TRUE(service->state(end.id, end.lengths->caught_at - 1)->lengths->caught);
  EXPECT_FALSE(service->state(end.id, end.lengths->caught_at)->lengths->caught);
  EXPECT_TRUE(service->state(end.id, end.revision + 5)->lengths->caught) << "of another life of the program";
  EXPECT_FALSE(service->states().front().lengths->caught);
}

TEST_F(LengthCaptures, GoesOnAfterTheProgramEndedAsIfNothingHadBeen) {
  store::Id id = 0;
  std::size_t caught_before = 0;
  {
    const auto service = open();
    const auto started = service->start(wish(volume_task(1), {{"speed", "10"}}));
    ASSERT_TRUE(started) << started.error().to_string();
    id = started->id;
    caught_before = wait_for(*service, id, [](const CaptureState& state) { return state.taken >= 3; }).taken;
  }
  const auto service = open();
  const auto left = service->state(id);
  ASSERT_TRUE(left) << left.error().to_string();
  EXPECT_EQ(left->stage, Stage::interrupted);
  EXPECT_EQ(left->lengths->order.title, "part 1 (station A, tool T1)");
  EXPECT_GE(caught_before, 3u);
  EXPECT_EQ(service->discard(id, "me").error().kind, ErrorKind::conflict) << "not before it has ended";
  const CaptureState end = end_of(*service, service->resume(id));
  EXPECT_EQ(end.stage, Stage::complete) << end.error;
  EXPECT_EQ(end.came_to->found, volume_points);
}

TEST_F(LengthCaptures, EndsAnInterruptedOneWithWhatCame) {
  store::Id id = 0;
  {
    const auto service = open();
    id = service->start(wish(volume_task(1), {{"speed", "10"}}))->id;
    wait_for(*service, id, [](const CaptureState& state) { return state.taken >= 5; });
  }
  const auto service = open();
  ASSERT_TRUE(service->stop(id));
  const CaptureState end = wait_for(*service, id, [](const CaptureState& state) { return has_ended(state.stage); });
  EXPECT_EQ(end.stage, Stage::stopped) << end.error;
  ASSERT_TRUE(end.came_to);
  EXPECT_GE(end.came_to->found, 4u);
  EXPECT_LT(end.came_to->found, volume_points);
  EXPECT_THAT(end.came_to->notes, Contains(HasSubstr("the recording ended before")));
}

TEST_F(LengthCaptures, IsFoundByLaterProgramsUntilItIsDiscarded) {
  CaptureState end;
  {
    const auto service = open();
    end = end_of(*service, service->start(wish(volume_task(1))));
  }
  const auto service = open();
  const auto found = service->state(end.id);
  ASSERT_TRUE(found) << found.error().to_string();
  EXPECT_EQ(found->stage, Stage::complete);
  EXPECT_EQ(found->came_to->table, end.came_to->table);
  EXPECT_EQ(found->came_to->notes, end.came_to->notes);
  EXPECT_EQ(service->task_of(*found)->plan_id(), volume_task(1).plan_id());
  EXPECT_EQ(service->states().size(), 1u);
  EXPECT_EQ(service->resume(end.id).error().kind, ErrorKind::not_found) << "nothing is to be gone on with";
  EXPECT_FALSE(std::filesystem::exists(fmt::format("{}/capture-{}.raw", folder_, end.id))) << "it is in the archive";

  ASSERT_TRUE(service->discard(end.id, "me"));
  EXPECT_TRUE(service->states().empty());
  EXPECT_EQ(service->discard(end.id, "me").error().kind, ErrorKind::not_found);
  EXPECT_TRUE(archive_.store().content(end.came_to->raw)) << "the archive only grows";
}

TEST_F(LengthCaptures, ANoteThatAPowerFailureCutOffIsNone) {
  CaptureState end;
  {
    const auto service = open();
    end = end_of(*service, service->start(wish(volume_task(1))));
  }
  const std::string order = fmt::format("{}/capture-{}.json", folder_, end.id);
  std::filesystem::resize_file(order, std::filesystem::file_size(order) - 10);
  std::ofstream(fmt::format("{}/capture-{}.raw", folder_, end.id))
      << archive_.store().content(end.came_to->raw)->bytes;
  const auto service = open();
  EXPECT_EQ(service->state(end.id)->stage, Stage::interrupted) << "its files are all there then";
  ASSERT_TRUE(service->stop(end.id));
  const CaptureState again =
      wait_for(*service, end.id, [](const CaptureState& state) { return has_ended(state.stage); });
  EXPECT_EQ(again.came_to->raw, end.came_to->raw);
}

TEST_F(LengthCaptures, ListensToAnInstrumentWhoseConnectionBreaks) {
  const std::string simulated = recording_of(lines_task(2));
  const std::string bytes = simulated.substr(simulated.find('\n') + 1);  // without the line that says so
  const std::size_t half = bytes.find('\n', bytes.size() / 2) + 1;
  const PieceServer server({bytes.substr(0, half + 5), bytes.substr(half + 5)});
  const auto service = open({server.source()});
  const CaptureState end = end_of(*service, service->start(wish(lines_task(2), {{"give-up", "5"}}, "laser")));
  EXPECT_THAT(end.notices, Contains(HasSubstr("connected again")));
  EXPECT_GE(end.came_to->found + 1, lines_task(2).stop_count()) << "all but the one that was cut";
  const std::string raw = service->file_of(end.id, "raw").value_or("");
  EXPECT_TRUE(bytes.starts_with(raw)) << "what it showed behind the last stop need not have come yet";
  EXPECT_GE(raw.size(), end.stage == Stage::complete ? bytes.size() * 9 / 10 : bytes.size());
  EXPECT_THAT(service->file_of(end.id, "lengths").value_or("Simulated"), testing::Not(HasSubstr("Simulated")));
}

TEST_F(LengthCaptures, SaysThatAnotherPartWasMeasuredAndKeepsTheRecording) {
  const std::string bytes = recording_of(volume_task(2));
  const PieceServer server({bytes});
  const auto service = open({server.source()});
  const CaptureState end = end_of(*service, service->start(wish(volume_task(1), {{"give-up", "0"}}, "laser")));
  EXPECT_EQ(end.stage, Stage::stopped);
  EXPECT_THAT(end.error, HasSubstr("fit part 2 (station B, tool T1) far better"));
  ASSERT_TRUE(end.came_to);
  EXPECT_TRUE(end.came_to->table.empty());
  EXPECT_EQ(service->file_of(end.id, "raw"), bytes);
  EXPECT_FALSE(service->file_of(end.id, "lengths"));
}

TEST_F(LengthCaptures, WhatIsNoRecordingIsKeptAsItCame) {
  const std::string bytes = std::string(70'000, 'x') + "\nno numbers\nat all\nin here\n";
  const PieceServer server({bytes});
  const auto service = open({server.source()});
  const CaptureState end = end_of(*service, service->start(wish(lines_task(0), {{"give-up", "0"}}, "laser")));
  EXPECT_EQ(end.stage, Stage::failed);
  EXPECT_FALSE(end.error.empty());
  const std::string raw = service->file_of(end.id, "raw").value_or("");
  EXPECT_GT(raw.size(), 60'000u);
  EXPECT_THAT(bytes, StartsWith(raw)) << "all that came until it was given up";
}

TEST_F(LengthCaptures, AllPartsOfAPlanAreSimulatedAtOneMachine) {
  const auto service = open();
  const auto seed_of = [&](std::size_t part) {
    const auto started = service->start(wish(volume_task(part)));
    std::ifstream order(fmt::format("{}/capture-{}.json", folder_, started->id));
    const std::string text{std::istreambuf_iterator<char>(order), {}};
    const std::size_t at = text.find("\"seed\"");
    return text.substr(at, text.find('\n', at) - at);
  };
  const std::string first = seed_of(1);
  EXPECT_THAT(first, HasSubstr("\"seed\": \""));
  EXPECT_EQ(seed_of(2), first);
}

TEST_F(LengthCaptures, AFailingWishBeginsNothing) {
  const auto service = open();
  EXPECT_THAT(service->start(wish(volume_task(1), {{"preset", "backlash"}})).error().message,
              HasSubstr("expected one of good, broken-beam"));
  EXPECT_THAT(service->start(wish(volume_task(1), {{"part", "2"}})).error().message, HasSubstr("part"));
  EXPECT_THAT(service->start(wish(lines_task(0), {{"zero", "first-target"}})).error().message, HasSubstr("zero"));
  EXPECT_EQ(service->start(wish(lines_task(0), {}, "nobody")).error().kind, ErrorKind::not_found);
  EXPECT_TRUE(service->states().empty());
  EXPECT_EQ(archive_.store().counts()->content_bytes, 0);
}

TEST_F(LengthCaptures, OneThatIsStoppedBeforeAnythingCameLeavesNothing) {
  const PieceServer server({std::string()});
  const auto service = open({server.source()});
  const CaptureState end = end_of(*service, service->start(wish(lines_task(0), {{"give-up", "0"}}, "laser")));
  EXPECT_TRUE(has_ended(end.stage));
  EXPECT_TRUE(end.came_to->raw.empty());
  EXPECT_FALSE(std::filesystem::exists(fmt::format("{}/capture-{}.json", folder_, end.id)));
}

/// What an archive lists goes with it: to a folder that has never seen the capture, and not after it was discarded.
TEST_F(LengthCaptures, are_listed_where_the_archive_is) {
  CaptureState end;
  {
    const auto service = open();
    end = end_of(*service, service->start(wish(lines_task(0))));
    ASSERT_EQ(end.stage, Stage::complete) << end.error;
  }
  folder_ = archive_.folder() + "/elsewhere";
  const auto elsewhere = [&] {
    std::vector<CaptureState> states = open()->states();
    return states.size() == 1 ? std::optional(states.front()) : std::nullopt;
  };
  const auto listed = elsewhere();
  ASSERT_TRUE(listed);
  EXPECT_EQ(listed->lengths->order.title, end.lengths->order.title);
  EXPECT_EQ(listed->came_to->table, end.came_to->table);
  EXPECT_EQ(listed->taken, end.taken);
  EXPECT_TRUE(elsewhere()) << "once, however often the program begins";
  {
    const auto service = open();
    EXPECT_THAT(service->file_of(listed->id, "lengths").value_or(""), HasSubstr("# captured on"));
    ASSERT_TRUE(service->task_of(*listed));
    ASSERT_TRUE(service->discard(listed->id, "you"));
  }
  EXPECT_FALSE(elsewhere());
  folder_ = archive_.folder() + "/captures";
  EXPECT_FALSE(elsewhere()) << "nor where it was made";
}

/// The program was killed after the archive had the note of the end and before the folder had it.
TEST_F(LengthCaptures, are_not_listed_twice_where_the_folder_has_the_order_already) {
  CaptureState end;
  {
    const auto service = open();
    end = end_of(*service, service->start(wish(lines_task(0))));
    ASSERT_EQ(end.stage, Stage::complete) << end.error;
  }
  CaptureFolder folder(folder_);
  const auto ended = folder.ended();
  ASSERT_EQ(ended.size(), 1u);
  const CaptureOrder& order = ended[0].capture.order;
  ASSERT_TRUE(folder.discard(end.id));
  {
    const auto interrupted = folder.add(order);
    ASSERT_TRUE(interrupted);
    std::ofstream(interrupted->raw()) << "what had come";
  }
  const auto states = open()->states();
  ASSERT_EQ(states.size(), 1u);
  EXPECT_EQ(states[0].stage, Stage::interrupted);
}

}  // namespace
}  // namespace axiometry::app
