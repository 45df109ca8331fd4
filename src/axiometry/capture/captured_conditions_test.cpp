// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/captured_conditions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "axiometry/capture/target_matcher.h"
#include "tests/support/made_up_recording.h"

namespace axiometry::capture {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing_support::made_up_plan;
using testing_support::MadeUpRun;

/// What is made of a recording by who holds that plan.
axiometry::Test test_of(const Plan& plan, const std::vector<Sample>& samples) {
  const StandstillOptions rest = standstill_options(plan);
  StandstillDetector detector(rest);
  MatcherOptions options;
  options.shortest = rest.shortest;
  auto matcher = TargetMatcher::make(plan, options);
  EXPECT_TRUE(matcher);
  for (const Standstill& s : detector.push(samples)) matcher->take(s);
  for (const Standstill& s : detector.interrupt()) matcher->take(s);
  EXPECT_TRUE(matcher->finish());
  auto test = captured_test(plan, matcher->result());
  EXPECT_TRUE(test) << test.error().message;
  return *std::move(test);
}

std::vector<std::string> remarks_of_test(const axiometry::Test& test) {
  std::vector<std::string> texts;
  for (const SourceRemark& remark : test.provenance.remarks) texts.push_back(remark.message);
  return texts;
}

/// The plan that is stated, and an axis that moved after it but for one thing.
struct Departure {
  Plan plan = made_up_plan(4, 3);
  MadeUpRun run;
  Departure() {
    plan.warm_up_runs = 2;
    run.plan = plan;
  }
  axiometry::Test test() const { return test_of(plan, run.record()); }
};

TEST(CapturedConditions, AreThoseOfThePlanWhereTheRecordingShowsThem) {
  const axiometry::Test test = Departure().test();
  EXPECT_EQ(test.metadata.conditions.feed, 1200.0);
  EXPECT_EQ(test.metadata.conditions.dwell, Duration::s(2.0));
  EXPECT_EQ(test.metadata.conditions.warm_up,
            "as recorded: 2 times there and back over all targets before the first reading");
  EXPECT_THAT(remarks_of_test(test), IsEmpty());
}

TEST(CapturedConditions, LeaveAWarmUpOpenThatWasNotRecorded) {
  Departure made;
  made.run.plan.warm_up_runs = 0;
  const axiometry::Test test = made.test();
  EXPECT_EQ(test.metadata.conditions.warm_up, "");
  EXPECT_THAT(remarks_of_test(test), Contains(HasSubstr("the plan has 2 runs: how the machine was warmed up is left")));
}

TEST(CapturedConditions, CountTheWarmUpFromWhereTheRecordingBegins) {
  Departure made;
  std::vector<Sample> samples = made.run.record();
  const double way_s =
      1.5 * (made.plan.targets.back().in_native() - made.plan.targets.front().in_native() + 10.0) / 20.0;
  std::erase_if(samples, [&](const Sample& s) { return s.time_s < 1.5 * way_s; });  // in the middle of the way back
  const axiometry::Test test = test_of(made.plan, samples);
  EXPECT_EQ(test.metadata.conditions.warm_up,
            "as recorded: once there and back over all targets before the first reading");
  EXPECT_THAT(remarks_of_test(test), Contains(HasSubstr("the recording shows 1 of 2 runs for warm-up")));
}

TEST(CapturedConditions, TellTheFeedAtWhichTheAxisMoved) {
  for (const double feed : {300.0, 1000.0, 1320.0, 3000.0}) {
    SCOPED_TRACE(feed);
    Departure made;
    made.run.plan.feed = feed;
    const axiometry::Test test = made.test();
    EXPECT_NEAR(*test.metadata.conditions.feed, feed, 0.02 * feed);
    EXPECT_THAT(remarks_of_test(test), Contains(HasSubstr("where the plan has 1200 mm/min: the feed is that of")));
  }
}

TEST(CapturedConditions, SayWhereTheWaysAreTooShortToShowTheFeed) {
  Departure made;
  made.run.rate_hz = 20.0;
  made.run.plan.feed = 9000.0;  // a way of 25 mm takes five samples
  made.plan.feed = 9000.0;
  EXPECT_THAT(remarks_of_test(made.test()), Contains(HasSubstr("to show the feed: the 9000 mm/min that are stated")));
}

TEST(CapturedConditions, TellHowLongTheAxisRested) {
  for (const double dwell_s : {1.3, 1.6, 2.5, 4.0}) {
    SCOPED_TRACE(dwell_s);
    Departure made;
    made.run.plan.dwell = Duration::s(dwell_s);
    const axiometry::Test test = made.test();
    EXPECT_NEAR(test.metadata.conditions.dwell->in_s(), dwell_s, 0.15);
    EXPECT_THAT(remarks_of_test(test), Contains(HasSubstr("where the plan has 2 s: the dwell is that of")));
  }
}

/// Turbulence of the air: noise of that standard deviation whose samples are alike over 0.3 s.
std::vector<Sample> with_turbulence(std::vector<Sample> samples, double deviation) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  double air = 0.0;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const double alike = std::exp(-(samples[k].time_s - samples[k - 1].time_s) / 0.3);
    air = alike * air + deviation * std::sqrt(1.0 - alike * alike) * normal(random);
    samples[k].position += air;
  }
  return samples;
}

TEST(CapturedConditions, TellNoiseThatDoesNotAverageAway) {
  Departure made;
  made.run.deviation = [](const Approach&) { return 0.0; };
  const std::vector<Sample> samples = made.run.record();
  EXPECT_THAT(remarks_of_test(test_of(made.plan, samples)), Each(Not(HasSubstr("samples at rest scatter"))));
  EXPECT_THAT(remarks_of_test(test_of(made.plan, with_turbulence(samples, 0.0004))),
              Contains(HasSubstr("samples at rest scatter")));
}

TEST(CapturedConditions, TellStepsThatDoNotAverageAway) {
  Departure made;
  made.run.quantum = 0.005;
  const auto remarks = remarks_of_test(made.test());
  EXPECT_THAT(remarks, Contains(AllOf(HasSubstr("come in steps of 5 µm, which leaves 1.4"),
                                      HasSubstr("R and A hold what was rounded"))));
  made.run.noise = 0.005;  // as much noise as a step: it averages away
  EXPECT_THAT(remarks_of_test(made.test()), Each(Not(HasSubstr("come in steps"))));
}

}  // namespace
}  // namespace axiometry::capture
