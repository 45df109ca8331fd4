// SPDX-License-Identifier: Apache-2.0
// Tables that are made of tests of the archive, kept and proved, over an axis that is known.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "axiometry/app/workbench/kept_records.h"
#include "axiometry/app/workbench/workbench.h"
#include "server/routes/route_test_support.h"
#include "server/routes/routes.h"
#include "tests/support/archive.h"

namespace axiometry::server {
namespace {

using json::Value;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A test of axis X of one machine: deviations of `share` of 12 µm/m with a reversal of 5 µm, and a small scatter that
/// differs with `seed`.
std::string test_of_axis(double share, int seed, std::string_view axis = "X") {
  std::string text = fmt::format(
      "# axis.name: {}\n# machine.name: Mill 5\n# machine.serial_number: 7\n# report_number: run-{}\n"
      "# date: 2026-01-{:02d}\ntarget_mm,run,direction,deviation_um\n",
      axis, seed, seed);
  for (int target = 0; target <= 8; ++target)
    for (int run = 1; run <= 5; ++run)
      for (const bool up : {true, false}) {
        const double x = 50.0 * target + 3.0;
        const double scatter = 0.3 * std::sin(seed * 1.7 + target * 2.3 + run * 0.9 + (up ? 0.0 : 0.9));
        text += fmt::format("{},{},{},{:.4f}\n", x, run, up ? "up" : "down",
                            share * (0.012 * x + (up ? 0.0 : -5.0)) + scatter);
      }
  return text;
}

class CompensationRoutes : public RouteTest {
 protected:
  CompensationRoutes() : RouteTest("/api") {
    auto& captures = *reinterpret_cast<app::CaptureService*>(&workbench);  // these have nothing to do with captures
    add_compensation_routes(router, {archive.store(), workbench, captures});
  }

  store::Id receive(const std::string& bytes, const std::string& name) {
    const app::Upload upload{.name = name, .bytes = bytes};
    const auto received = workbench.receive(std::span(&upload, 1), {"A. Tester", ""});
    EXPECT_TRUE(received) << received.error().to_string();
    return received ? received->tests.front().id : 0;
  }

  Response send(std::string method, std::string_view path, std::string body = {}, Pairs query = {}) const {
    return ask(std::move(method), path, std::move(body), std::move(query), json_type, language_);
  }

  Response send_form(std::string_view path, const Pairs& texts, const Pairs& files = {}) const {
    return ask("POST", path, form_of(files, texts, ".comp"), {}, form_type, language_);
  }

  static std::vector<std::string> findings_of(const Value& kept) {
    std::vector<std::string> ids;
    for (const Value& finding : kept.find("result")->find("findings")->items())
      ids.push_back(finding.find("id")->text());
    return ids;
  }
  /// Those that are of record.
  static std::vector<std::string> counting(const Value& kept) {
    std::vector<std::string> ids;
    for (const Value& finding : kept.find("findings")->items()) ids.push_back(finding.find("id")->text());
    return ids;
  }
  static std::optional<double> figure(const Value& kept, std::string_view parameter, std::string_view state) {
    for (const Value& row : kept.find("figures")->items())
      if (row.find("parameter")->text() == parameter && row.find(state)->is(json::Kind::number))
        return row.find(state)->number();
    return std::nullopt;
  }

  Value keep(store::Id test, const std::string& options = R"({"control": "linuxcnc"})", const Pairs& files = {}) {
    return value_of(
        send_form(fmt::format("/tests/{}/compensations", test), {{"options", options}, {"notes", "new screw"}}, files),
        201);
  }

  Value link(store::Id retest, int base_version) {
    return value_of(send("POST", "/compensations/1/versions",
                         fmt::format(R"({{"base_version": {}, "retest": {}}})", base_version, retest)),
                    201);
  }

  void revise_test(store::Id id, int base_version, std::string title, app::Changes changes) {
    app::Revision revision;
    revision.base_version = base_version;
    revision.title = std::move(title);
    revision.draft.changes = std::move(changes);
    const auto revised = workbench.revise(id, revision, {"A. Tester", ""});
    ASSERT_TRUE(revised) << revised.error().to_string();
  }

  std::vector<double> listed(Pairs query = {}) {
    const Value list = value_of(send("GET", "/compensations", {}, std::move(query)));
    std::vector<double> ids;
    for (const Value& row : list.find("compensations")->items()) ids.push_back(row.find("id")->number());
    return ids;
  }

  testing_support::Archive archive;
  app::Workbench workbench{archive.store()};
  language::Language language_ = language::Language::english;
};

TEST_F(CompensationRoutes, list_controls_with_what_they_use) {
  const Value controls = value_of(send("GET", "/controls"));
  const auto named = [&](std::string_view id) {
    return std::ranges::find_if(controls.items(), [&](const Value& c) { return c.find("id")->text() == id; });
  };
  EXPECT_EQ(json::dump(*named("linuxcnc")->find("options"), 0), R"(["inch"])");
  EXPECT_EQ(named("fanuc")->find("options")->items().size(), 4u);
  EXPECT_TRUE(named("fanuc")->find("read_step")->boolean());
  EXPECT_FALSE(named("fanuc-bidirectional")->find("read_step")->boolean());
  EXPECT_FALSE(named("linuxcnc")->find("read_step")->boolean());
  EXPECT_TRUE(named("siemens-cec")->find("cross")->boolean());
  EXPECT_FALSE(named("linuxcnc")->find("cross")->boolean());
  EXPECT_EQ(named("haas")->find("limits")->find("step")->number(), 12.7);
}

TEST_F(CompensationRoutes, make_a_table_and_keep_nothing) {
  const store::Id test = receive(test_of_axis(1.0, 1), "x.csv");
  const Value made =
      value_of(send_form(fmt::format("/tests/{}/compensation", test), {{"options", R"({"control": "linuxcnc"})"}}));
  EXPECT_EQ(made.find("file_name")->text(), "X-test-1-linuxcnc.comp");
  const Value& result = *made.find("result");
  EXPECT_GT(result.find("before")->find("E")->number(), 8.0);
  EXPECT_LT(result.find("predicted")->find("E")->number(), 0.1);
  EXPECT_THAT(listed(), IsEmpty());
}

TEST_F(CompensationRoutes, read_the_table_that_they_made) {
  const store::Id test = receive(test_of_axis(1.0, 1), "x.csv");
  const Value made =
      value_of(send_form(fmt::format("/tests/{}/compensation", test), {{"options", R"({"control": "linuxcnc"})"}}));
  const std::string table = made.find("table")->text();
  const Value read =
      value_of(send_form("/controls/linuxcnc/table", {{"options", R"({"kind": "linear"})"}}, {{"table", table}}));
  EXPECT_EQ(json::dump(*read.find("table")), json::dump(*made.find("result")->find("table")));
  const std::string of_y =
      value_of(
          send_form(
              fmt::format("/tests/{}/compensation", test),
              {{"options",
                R"({"control": "pmac", "axis": "Y", "curves": "both-ways", "resolution": 0.1, "start": 50, "end": 400,
                       "step": 50})"}}))
          .find("table")
          ->text();
  EXPECT_EQ(value_of(send_form("/controls/pmac/table", {}, {{"table", of_y}})).find("control")->text(), "pmac");
  EXPECT_THAT(refusal(send_form("/controls/pmac/table", {{"options", R"({"resolution": 1})"}}, {{"table", of_y}})),
              HasSubstr("counts of 0.1 µm"));
  EXPECT_THAT(refusal(send_form("/controls/linuxcnc/table", {}, {{"table", "1 2 3\nword\n"}})), HasSubstr("word"));
  EXPECT_THAT(refusal(send_form("/controls/linuxcnc/table", {{"options", "{}"}})), HasSubstr("no file"));
  EXPECT_THAT(refusal(send_form("/controls/nobody/table", {}, {{"table", table}}), 404), HasSubstr("nobody"));
}

TEST_F(CompensationRoutes, keep_the_table_with_its_test) {
  const store::Id test = receive(test_of_axis(1.0, 1), "x.csv");
  const Value kept = keep(test);
  EXPECT_EQ(kept.find("test")->find("id")->number(), static_cast<double>(test));
  EXPECT_EQ(kept.find("machine")->find("name")->text(), "Mill 5");
  EXPECT_EQ(kept.find("axis")->find("name")->text(), "X");
  EXPECT_EQ(kept.find("notes")->text(), "new screw");
  EXPECT_TRUE(kept.find("retest")->is(json::Kind::null));
  EXPECT_GT(*figure(kept, "E", "before"), 8.0);
  EXPECT_LT(*figure(kept, "E", "predicted"), 0.1);
  EXPECT_GT(*figure(kept, "E", "percent_95"), *figure(kept, "E", "predicted"));
  EXPECT_FALSE(figure(kept, "E", "retest"));
  const Response table = send("GET", "/compensations/1/files/table");
  EXPECT_EQ(table.body, kept.find("table")->text());
  EXPECT_THAT(refusal(send("GET", "/compensations/1/files/existing"), 404), HasSubstr("existing"));
  EXPECT_THAT(listed(), ElementsAre(1));
  EXPECT_THAT(listed({{"test", "1"}}), ElementsAre(1));
  EXPECT_THAT(listed({{"axis", "1"}}), ElementsAre(1));
  EXPECT_THAT(listed({{"axis", "2"}}), IsEmpty());
}

TEST_F(CompensationRoutes, link_the_retest_that_proves_the_table) {
  receive(test_of_axis(1.0, 1), "x.csv");
  const store::Id good = receive(test_of_axis(0.0, 2), "good.csv");
  keep(1);
  const Value proved = value_of(
      send("POST", "/compensations/1/versions", fmt::format(R"({{"base_version": 1, "retest": {}}})", good)), 201);
  EXPECT_EQ(proved.find("version")->number(), 2);
  EXPECT_EQ(proved.find("retest")->find("id")->number(), static_cast<double>(good));
  EXPECT_LT(*figure(proved, "E", "retest"), 1.0);
  EXPECT_THAT(findings_of(proved), testing::Contains("retest-as-predicted"));
  EXPECT_EQ(proved.find("serious")->number(), 0);
  EXPECT_THAT(listed({{"test", fmt::format("{}", good)}}), ElementsAre(1));
  const Value first = value_of(send("GET", "/compensations/1", {}, {{"version", "1"}}));
  EXPECT_TRUE(first.find("retest")->is(json::Kind::null)) << "the version of before stays";
  const Value without = value_of(
      send("POST", "/compensations/1/versions", R"({"base_version": 2, "retest": null, "reason": "wrong one"})"), 201);
  EXPECT_TRUE(without.find("retest")->is(json::Kind::null));
  EXPECT_FALSE(figure(without, "E", "retest"));
}

TEST_F(CompensationRoutes, name_a_sign_mistake) {
  receive(test_of_axis(1.0, 1), "x.csv");
  const store::Id doubled = receive(test_of_axis(2.0, 2), "doubled.csv");
  keep(1);
  const Value told = value_of(
      send("POST", "/compensations/1/versions", fmt::format(R"({{"base_version": 1, "retest": {}}})", doubled)), 201);
  EXPECT_THAT(findings_of(told), testing::Contains("retest-sign"));
  EXPECT_GE(told.find("serious")->number(), 1);
}

TEST_F(CompensationRoutes, refuse_what_is_no_retest) {
  receive(test_of_axis(1.0, 1), "x.csv");
  const store::Id other = receive(test_of_axis(0.0, 2, "Y"), "y.csv");
  const store::Id gone = receive(test_of_axis(0.0, 3), "gone.csv");
  ASSERT_TRUE(archive.store().withdraw(gone, true, {"A. Tester", ""}));
  keep(1);
  const auto linked = [&](store::Id id) {
    return send("POST", "/compensations/1/versions", fmt::format(R"({{"base_version": 1, "retest": {}}})", id));
  };
  EXPECT_THAT(refusal(linked(1)), HasSubstr("as its own re-test"));
  EXPECT_THAT(refusal(linked(other)), HasSubstr("of another axis"));
  EXPECT_THAT(refusal(linked(gone)), HasSubstr("withdrawn"));
  EXPECT_THAT(refusal(linked(99), 404), HasSubstr("99"));
  EXPECT_THAT(
      refusal(send_form(fmt::format("/tests/{}/compensation", gone), {{"options", R"({"control": "linuxcnc"})"}})),
      HasSubstr("withdrawn"));
}

TEST_F(CompensationRoutes, update_the_table_that_was_active) {
  receive(test_of_axis(1.0, 1), "x.csv");
  const std::string table = keep(1).find("table")->text();
  receive(test_of_axis(0.5, 2), "again.csv");
  const Value kept = keep(2, R"({"control": "linuxcnc"})", {{"existing", table}});
  EXPECT_EQ(kept.find("existing")->find("name")->text(), "existing.comp");
  EXPECT_EQ(send("GET", "/compensations/2/files/existing").body, table);
  const Value first = value_of(send("GET", "/compensations/1"));
  const auto& before = first.find("result")->find("table")->items();
  const auto& after = kept.find("result")->find("table")->items();
  ASSERT_EQ(before.size(), after.size());
  const double added = before.back().find("up")->number() - before.front().find("up")->number();
  const double updated = after.back().find("up")->number() - after.front().find("up")->number();
  EXPECT_NEAR(updated, 1.5 * added, 0.5);
}

TEST_F(CompensationRoutes, refuse_what_would_be_passed_over) {
  receive(test_of_axis(1.0, 1), "x.csv");
  const auto made = [&](const std::string& options, const Pairs& files = {}) {
    return send_form("/tests/1/compensation", {{"options", options}}, files);
  };
  EXPECT_THAT(refusal(made(R"({"control": "linuxcnc", "magnification": 4})")), HasSubstr("no use for it"));
  EXPECT_THAT(refusal(made(R"({"control": "linuxcnc", "stop": 4})")), HasSubstr("stop"));
  EXPECT_THAT(refusal(made(R"({"control": "linuxcnc", "points": 0})")), HasSubstr("points"));
  EXPECT_THAT(refusal(made(R"({"control": "linuxcnc", "method": "guess"})")), HasSubstr("least-squares"));
  EXPECT_THAT(refusal(made(R"({"control": "fanuc", "resolution": 0})")), HasSubstr("resolution"));
  EXPECT_THAT(refusal(made(R"({"control": "linuxcnc", "start": -500, "end": 400, "step": 10})")),
              HasSubstr("measured"));
  EXPECT_THAT(refusal(made(R"({"axis": "X"})")), HasSubstr("control"));
  EXPECT_THAT(refusal(made(R"({"control": "linuxcnc", "smooth": true, "method": "interpolation"})")),
              HasSubstr("smoothing"));
  EXPECT_THAT(refusal(made(R"({"control": "linuxcnc", "start": 300, "end": 100})")), HasSubstr("an end at 100"));
  EXPECT_THAT(refusal(send_form("/tests/1/compensation",
                                {{"options", R"({"control": "linuxcnc"})"}, {"options", R"({"control": "fanuc"})"}})),
              HasSubstr("twice"));
  EXPECT_THAT(refusal(made(R"({"control": "linuxcnc"})", {{"stray", "1"}})), HasSubstr("stray"));
  const Value refused = value_of(made(R"({"control": "linuxcnc"})", {{"existing", "1 2 x"}}), 422);
  EXPECT_EQ(refused.find("error")->find("file")->text(), "existing.comp");
}

TEST_F(CompensationRoutes, write_reports_of_what_was_kept) {
  receive(test_of_axis(1.0, 1), "x.csv");
  const Value kept = keep(1);
  const Response html = send("GET", "/compensations/1/report.html");
  EXPECT_EQ(html.status, 200);
  EXPECT_THAT(html.body, HasSubstr("LinuxCNC"));
  EXPECT_EQ(send("GET", "/compensations/1/report.pdf").body.substr(0, 5), "%PDF-");
  EXPECT_EQ(json::dump(value_of(send("GET", "/compensations/1/report.json"))), json::dump(*kept.find("result")));
  EXPECT_THAT(refusal(send("GET", "/compensations/1/report.docx")), HasSubstr("docx"));
}

TEST_F(CompensationRoutes, report_a_table_with_the_comments_of_an_earlier_program) {
  receive(test_of_axis(1.0, 1), "x.csv");
  std::string table =
      keep(1, R"({"control": "pmac", "curves": "both-ways", "resolution": 0.1, "start": 50, "end": 400, "step": 50})")
          .find("table")
          ->text();
  const auto keep_with = [&](const std::string& bytes) {
    return archive.store().write([&](store::Transaction& t) -> Result<store::Versioned<store::CompensationRecord>> {
      AXIOMETRY_TRY(auto kept, t.get<store::CompensationRecord>(1));
      const store::Content content = app::hashed_content("old.pmc", "compensation-table", bytes);
      AXIOMETRY_TRY_VOID(t.keep(content, {"A. Tester", ""}));
      kept.value.files.front().content = content.sha256;
      return t.add(kept.value, {"A. Tester", ""});
    });
  };
  const std::size_t count = table.find("; one count = ");
  ASSERT_NE(count, table.npos);
  table.erase(count, table.find('\n', count) + 1 - count);
  const auto of_earlier = keep_with(table);
  ASSERT_TRUE(of_earlier) << of_earlier.error().message;
  const Response html = send("GET", fmt::format("/compensations/{}/report.html", of_earlier->id));
  EXPECT_EQ(html.status, 200) << html.body;
  const std::size_t entry = table.find('\n', table.find("DEFINE COMP")) + 1;
  table.replace(entry, table.find('\n', entry) - entry, "1600");
  const auto of_another = keep_with(table);
  ASSERT_TRUE(of_another) << of_another.error().message;
  EXPECT_THAT(refusal(send("GET", fmt::format("/compensations/{}/report.html", of_another->id)), 409),
              HasSubstr("another table"));
}

/// BLCOMP held all of the reversal once, and Ix86 nothing of it.
TEST_F(CompensationRoutes, give_a_table_of_a_former_form_as_it_was_kept_and_say_so) {
  receive(test_of_axis(1.0, 1), "x.csv");
  const std::string options =
      R"({"control": "pmac", "curves": "both-ways", "resolution": 0.1, "start": 50, "end": 400, "step": 50})";
  std::string table = keep(1, options).find("table")->text();
  table.insert(table.find("I51=1"), "#1 DEFINE BLCOMP 1,500\n80\n");
  const auto former =
      archive.store().write([&](store::Transaction& t) -> Result<store::Versioned<store::CompensationRecord>> {
        AXIOMETRY_TRY(auto kept, t.get<store::CompensationRecord>(1));
        const store::Content content = app::hashed_content("old.pmc", "compensation-table", table);
        AXIOMETRY_TRY_VOID(t.keep(content, {"A. Tester", ""}));
        kept.value.files.front().content = content.sha256;
        return t.add(kept.value, {"A. Tester", ""});
      });
  ASSERT_TRUE(former) << former.error().message;
  const std::string path = fmt::format("/compensations/{}", former->id);
  const Value kept = value_of(send("GET", path));
  EXPECT_EQ(kept.find("table")->text(), table);
  EXPECT_THAT(counting(kept), testing::Contains("compensation-former-form"));
  const double serious = value_of(send("GET", "/compensations/1")).find("serious")->number();
  EXPECT_EQ(kept.find("serious")->number(), serious + 1);
  EXPECT_EQ(send("GET", path + "/report.json").status, 200);
  EXPECT_THAT(refusal(send("GET", path + "/report.html"), 409), HasSubstr("earlier versions of this program"));
}

TEST_F(CompensationRoutes, doubt_a_retest_that_is_older_than_the_table) {
  receive(test_of_axis(1.0, 9), "x.csv");
  const store::Id early = receive(test_of_axis(0.0, 2), "early.csv");
  keep(1);
  EXPECT_THAT(refusal(send("POST", "/compensations/1/versions", R"({"base_version": 1, "reason": "none"})")),
              HasSubstr("changes nothing"));
  const Value told = value_of(
      send("POST", "/compensations/1/versions", fmt::format(R"({{"base_version": 1, "retest": {}}})", early)), 201);
  EXPECT_THAT(findings_of(told), testing::Contains("retest-before-test"));
  EXPECT_GE(told.find("serious")->number(), 1);
}

TEST_F(CompensationRoutes, count_nothing_of_a_retest_that_was_withdrawn) {
  receive(test_of_axis(1.0, 1), "x.csv");
  const store::Id doubled = receive(test_of_axis(2.0, 2), "doubled.csv");
  keep(1);
  const Value told = link(doubled, 1);
  EXPECT_THAT(counting(told), testing::Contains("retest-sign"));
  EXPECT_TRUE(figure(told, "E", "retest"));
  ASSERT_TRUE(archive.store().withdraw(doubled, true, {"A. Tester", "wrong machine"}));
  const Value now = value_of(send("GET", "/compensations/1"));
  EXPECT_THAT(counting(now), ElementsAre("retest-withdrawn"));
  EXPECT_EQ(now.find("serious")->number(), 1) << "the sign mistake was concluded from what does not count";
  EXPECT_FALSE(figure(now, "E", "retest"));
  EXPECT_TRUE(now.find("retest")->find("withdrawn")->boolean());
  EXPECT_THAT(findings_of(now), testing::Contains("retest-sign")) << "what was kept stays";
  const Value list = value_of(send("GET", "/compensations"));
  EXPECT_EQ(list.find("compensations")->items()[0].find("serious")->number(), 1);
  const std::string report = send("GET", "/compensations/1/report.html").body;
  EXPECT_THAT(report, HasSubstr("is withdrawn"));
  EXPECT_THAT(report, testing::Not(HasSubstr("sign mistake")));
  EXPECT_THAT(report, HasSubstr("A prediction, not a measurement"));
  ASSERT_TRUE(archive.store().withdraw(doubled, false, {"A. Tester", "it was this one"}));
  EXPECT_EQ(json::dump(value_of(send("GET", "/compensations/1"))), json::dump(told)) << "reinstated it counts again";
}

TEST_F(CompensationRoutes, count_nothing_of_a_retest_that_was_revised) {
  receive(test_of_axis(1.0, 1), "x.csv");
  const store::Id good = receive(test_of_axis(0.0, 2), "good.csv");
  keep(1);
  link(good, 1);
  revise_test(good, 1, "another name", {});
  const Value renamed = value_of(send("GET", "/compensations/1"));
  EXPECT_THAT(counting(renamed), ElementsAre("retest-as-predicted")) << "a name changes no reading";
  EXPECT_EQ(renamed.find("retest")->find("latest")->number(), 2);
  EXPECT_FALSE(renamed.find("retest")->find("revised")->boolean());
  revise_test(good, 2, "", {{"tolerance.A", "20"}});
  const Value revised = value_of(send("GET", "/compensations/1"));
  EXPECT_THAT(counting(revised), ElementsAre("retest-revised"));
  EXPECT_FALSE(figure(revised, "E", "retest"));
  EXPECT_THAT(counting(link(good, 2)), ElementsAre("retest-as-predicted")) << "linked again it counts";
}

TEST_F(CompensationRoutes, doubt_a_table_whose_test_was_withdrawn_or_revised) {
  receive(test_of_axis(1.0, 1), "x.csv");
  EXPECT_EQ(keep(1).find("serious")->number(), 0);
  revise_test(1, 1, "", {{"tolerance.A", "20"}});
  EXPECT_THAT(counting(value_of(send("GET", "/compensations/1"))), ElementsAre("test-revised"));
  ASSERT_TRUE(archive.store().withdraw(1, true, {"A. Tester", ""}));
  const Value now = value_of(send("GET", "/compensations/1"));
  EXPECT_THAT(counting(now), ElementsAre("test-withdrawn", "test-revised"));
  EXPECT_EQ(now.find("serious")->number(), 2);
  language_ = language::Language::german;
  const Value said = value_of(send("GET", "/compensations/1"));
  for (const Value& finding : said.find("findings")->items())
    EXPECT_THAT(finding.find("message")->text(), HasSubstr("Prüfung 1"));
}

TEST_F(CompensationRoutes, refuse_to_revise_what_is_withdrawn) {
  receive(test_of_axis(1.0, 1), "x.csv");
  const store::Id good = receive(test_of_axis(0.0, 2), "good.csv");
  keep(1);
  EXPECT_EQ(send("POST", "/compensations/1/withdraw", "{}").status, 200);
  for (const std::string& change : {fmt::format(R"("retest": {})", good), std::string(R"("notes": "x")")})
    EXPECT_THAT(
        refusal(send("POST", "/compensations/1/versions", fmt::format(R"({{"base_version": 2, {}}})", change)), 409),
        HasSubstr("reinstate it first"));
  EXPECT_EQ(send("POST", "/compensations/1/reinstate", "{}").status, 200);
  EXPECT_THAT(counting(link(good, 3)), ElementsAre("retest-as-predicted"));
}

TEST_F(CompensationRoutes, print_their_notes_as_they_were_written) {
  receive(test_of_axis(1.0, 1), "x.csv");
  keep(1);
  const std::string notes = R"({"base_version": 1, "notes": "table & sign\n<second> line"})";
  EXPECT_EQ(send("POST", "/compensations/1/versions", notes).status, 201);
  const std::string report = send("GET", "/compensations/1/report.html").body;
  EXPECT_THAT(report, HasSubstr("Notes</h2>"));
  EXPECT_THAT(report, HasSubstr("table &amp; sign"));
  EXPECT_THAT(report, HasSubstr("&lt;second&gt; line"));
  EXPECT_THAT(send("GET", "/compensations/1/report.html", {}, {{"version", "1"}}).body, HasSubstr("new screw"));
}

TEST_F(CompensationRoutes, withdraw_and_reinstate) {
  receive(test_of_axis(1.0, 1), "x.csv");
  keep(1);
  EXPECT_TRUE(value_of(send("POST", "/compensations/1/withdraw", R"({"reason": "wrong control"})"))
                  .find("withdrawn")
                  ->boolean());
  EXPECT_THAT(listed(), IsEmpty());
  EXPECT_TRUE(value_of(send("GET", "/compensations/1/report.json")).find("withdrawn")->boolean());
  EXPECT_THAT(listed({{"withdrawn", "true"}}), ElementsAre(1));
  EXPECT_THAT(refusal(send("POST", "/compensations/1/withdraw", "{}"), 409), HasSubstr("withdrawn already"));
  EXPECT_FALSE(value_of(send("POST", "/compensations/1/reinstate", "{}")).find("withdrawn")->boolean());
  EXPECT_EQ(value_of(send("GET", "/compensations/1/report.json")).find("withdrawn"), nullptr);
}

}  // namespace
}  // namespace axiometry::server
