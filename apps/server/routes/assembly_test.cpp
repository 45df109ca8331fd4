// SPDX-License-Identifier: Apache-2.0
// Errors measured one by one as the page sends them: the model that the command line makes of them.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "axiometry/app/volumetric/singles/assemble_singles.h"
#include "server/routes/route_test_support.h"
#include "server/routes/routes.h"
#include "tests/support/repository_file.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::server {
namespace {

using json::Value;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string singles_file(const std::string& name) {
  return testing_support::repository_file("tests/transcripts/volumetric-assemble.files/" + name);
}

constexpr const char* usual_singles = R"({"errors": ["EXX=exx.csv", "EYX=eyx.csv", "ECX=ecx.csv", "EXY=exy.csv",
  "C0Y=-12.5,1.2"], "at": ["X=0,300,-200@short", "Y=500,0,-200@short"], "instruments": ["EYX=0.4,0.5"]})";
const std::vector<std::string> usual_files = {"exx.csv", "eyx.csv", "ecx.csv", "exy.csv"};

class AssemblyRoutes : public RouteTest {
 protected:
  AssemblyRoutes() : RouteTest("/api/volumetric/") { add_volumetric_routes(router); }

  static std::string form(const std::vector<std::string>& files, const std::string& options, bool with_machine = true) {
    std::string body;
    const auto part = [&](const std::string& head, const std::string& bytes) {
      body += fmt::format("--b\r\nContent-Disposition: form-data; {}\r\n\r\n{}\r\n", head, bytes);
    };
    for (const std::string& name : files)
      part(fmt::format("name=\"errors\"; filename=\"{}\"", name), singles_file(name));
    if (with_machine) part("name=\"machine\"; filename=\"machine.json\"", singles_file("machine.json"));
    if (!options.empty()) part("name=\"options\"", options);
    return body + "--b--\r\n";
  }
  Response send(const std::string& body, std::string_view path = "assembly",
                language::Language language = language::Language::english) const {
    return ask("POST", path, body, {}, form_type, language);
  }
  std::string refused(const std::vector<std::string>& files, const std::string& options) const {
    return refusal(send(form(files, options)));
  }
  Response look(std::string_view path, const std::string& body) const { return ask("POST", path, body); }
  Value usual() const { return value_of(send(form(usual_files, usual_singles))); }
};

TEST_F(AssemblyRoutes, end_when_nobody_waits_any_more) {
  std::stop_source gone;
  gone.request_stop();
  stop = gone.get_token();
  EXPECT_THAT(refusal(send(form(usual_files, usual_singles)), 503), HasSubstr("stopped before it was done"));
}

TEST_F(AssemblyRoutes, make_the_model_that_the_command_line_makes) {
  const Value made = usual();
  const testing_support::TemporaryFolder folder;
  app::AssembleRequest request;
  request.machine = folder.written("machine.json", singles_file("machine.json"));
  for (const std::string name : {"EXX", "EYX", "ECX", "EXY"}) {
    const std::string file = text::to_lower(name) + ".csv";
    request.items.push_back({.name = name, .file = folder.written(file, singles_file(file))});
  }
  request.items.push_back(*app::parse_single("C0Y=-12.5,1.2"));
  ASSERT_TRUE(app::put_stand("X=0,300,-200@short", request));
  ASSERT_TRUE(app::put_stand("Y=500,0,-200@short", request));
  ASSERT_TRUE(app::put_instrument("EYX=0.4,0.5", request));
  const auto direct = app::assemble_singles(request);
  ASSERT_TRUE(direct) << direct.error().message;
  const Value expected = app::present(*direct, {}).json;
  for (const char* member : {"at", "findings", "remarks", "curves", "model"})
    EXPECT_EQ(json::dump(*made.find(member)), json::dump(*expected.find(member))) << member;
  EXPECT_EQ(made.find("errors")->items().front().find("file")->text(), "exx.csv") << "a name, no path";
}

TEST_F(AssemblyRoutes, show_the_curves_of_the_model) {
  const Value curves = *usual().find("curves");
  EXPECT_FALSE(curves.find("EYX")->items().empty());
  EXPECT_FALSE(curves.find("EYX")->items().front().find("up")->find("value")->is(json::Kind::null));
  EXPECT_TRUE(curves.find("EZZ")->items().empty()) << "nobody measured it";
  EXPECT_TRUE(curves.find("B0Z")->find("value")->is(json::Kind::null));
  EXPECT_LT(curves.find("C0Y")->find("value")->number(), 0.0);
}

TEST_F(AssemblyRoutes, write_the_report_and_the_result_as_files) {
  const std::string body = form(usual_files, usual_singles);
  EXPECT_THAT(send(body, "assembly/report.pdf").body, StartsWith("%PDF-"));
  EXPECT_EQ(value_of(send(body, "assembly/report.json")).find("result")->text(), "volumetric-assembled");
}

TEST_F(AssemblyRoutes, tell_of_what_is_made_of_it_what_its_remarks_say) {
  const Value made = usual();
  ASSERT_FALSE(made.find("remarks")->items().empty());
  const auto ids_of = [&](const std::string& more) {
    const Value line = value_of(
        look("prediction", fmt::format(R"({{"model": {}{}, "axis": "X", "at_mm": [0, 300, -200], "tool": "short"}})",
                                       json::dump(*made.find("model")), more)));
    return json::dump(*line.find("findings"));
  };
  EXPECT_THAT(ids_of(""), Not(HasSubstr("volumetric-singles-remark")));
  EXPECT_THAT(ids_of(", \"remarks\": " + json::dump(*made.find("remarks"))), HasSubstr("volumetric-singles-remark"));
  EXPECT_THAT(
      refusal(look("field", fmt::format(R"({{"model": {}, "remarks": "none"}})", json::dump(*made.find("model"))))),
      HasSubstr("remarks: found"));
}

TEST_F(AssemblyRoutes, read_a_result_file_again_and_make_its_curves_anew) {
  const Value made = usual();
  Value given = Value::object();
  Value curves = Value::object();
  for (const auto& [name, nodes] : made.find("curves")->members())
    curves.add(name, name == "EYX" ? Value::array() : nodes);
  for (const auto& [name, member] : made.members()) given.add(name, name == "curves" ? curves : member);
  const Value again = value_of(look("result", fmt::format(R"({{"result": {}}})", json::dump(given))));
  const auto &nodes = again.find("curves")->find("EYX")->items(), &before = made.find("curves")->find("EYX")->items();
  ASSERT_EQ(nodes.size(), before.size());
  for (std::size_t k = 0; k < nodes.size(); ++k)
    EXPECT_NEAR(nodes[k].find("value")->number(), before[k].find("value")->number(), 1e-9);
  std::string broken = json::dump(made);
  broken.replace(broken.find("\"remarks\""), 9, "\"remarkz\"");
  EXPECT_THAT(refusal(look("result", fmt::format(R"({{"result": {}}})", broken))), HasSubstr("found no remarks"));
}

TEST_F(AssemblyRoutes, speak_the_language_of_the_reader) {
  const Value made = value_of(send(form(usual_files, usual_singles), "assembly", language::Language::german));
  for (const Value& remark : made.find("remarks")->items()) EXPECT_THAT(remark.text(), Not(HasSubstr(" the ")));
}

TEST_F(AssemblyRoutes, refuse_what_is_missing_or_unknown) {
  EXPECT_THAT(refusal(look("assembly", "{}")), HasSubstr("found no form"));
  EXPECT_THAT(refusal(send(form(usual_files, usual_singles, false))), HasSubstr("found no file machine"));
  EXPECT_THAT(refused({"exx.csv"}, ""), HasSubstr("found no options"));
  EXPECT_THAT(refused({}, R"({"errors": []})"), HasSubstr("found no errors"));
  EXPECT_THAT(refused({"exx.csv"}, R"({"errors": ["EXX=other.csv"]})"), HasSubstr("found \"other.csv\" of EXX"));
  EXPECT_THAT(refused({}, R"({"errors": ["EXX=/etc/passwd"]})"), HasSubstr("expected the name of a file that is sent"));
  EXPECT_THAT(refused({"exx.csv", "eyx.csv"}, R"({"errors": ["EXX=exx.csv"]})"),
              HasSubstr("found the file \"eyx.csv\", expected files of errors that are named"));
  EXPECT_THAT(refused({"exx.csv", "exx.csv"}, R"({"errors": ["EXX=exx.csv"]})"), HasSubstr("found two files"));
  EXPECT_THAT(refused({"exx.csv"}, R"({"errors": ["EXX=exx.csv", "EXX=exx.csv"]})"), HasSubstr("found EXX twice"));
  EXPECT_THAT(refused({"eyx.csv"}, R"({"errors": ["EYX=eyx.csv"]})"), HasSubstr("not where the other axes stood"));
  EXPECT_THAT(refused({"eyx.csv"}, R"({"errors": ["EYX=eyx.csv"], "at": ["X=0,300,-200@other"]})"),
              HasSubstr("found the tool \"other\""));
  EXPECT_THAT(refused({"exx.csv"}, R"({"errors": ["EXX=exx.csv"], "instruments": ["EYX=1"]})"),
              HasSubstr("found an instrument of \"EYX\""));
  EXPECT_THAT(refused({"exx.csv"}, R"({"errors": ["EXX=exx.csv"], "reversal": "constant"})"), HasSubstr("constant"));
  EXPECT_THAT(refused({"exx.csv"}, R"({"errors": ["EXX=exx.csv"], "pionts": 5})"), HasSubstr("pionts"));
}

}  // namespace
}  // namespace axiometry::server
