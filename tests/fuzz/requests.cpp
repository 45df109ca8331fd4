// SPDX-License-Identifier: Apache-2.0
//
// A request to the API: "POST /api/tests/1/versions" or the like on the first line, its Content-Type on the second, its
// body behind. Whatever comes, the answer is one that the API describes, a refusal says why, and nothing that was kept
// before is changed: the archive verifies.
#include <memory>
#include <optional>

#include "axiometry/app/workbench/examples/example_table2.h"
#include "axiometry/app/workbench/workbench.h"
#include "described.h"
#include "server/http/target.h"
#include "server/routes/routes.h"
#include "server/work/job.h"
#include "tests/support/archive.h"

using namespace axiometry;

namespace {

/// The routes over an archive that holds one test, number 1.
class Api {
 public:
  Api() {
    // Nothing here asks about captures: they listen to what is outside.
    auto& captures = *reinterpret_cast<app::CaptureService*>(&workbench_);
    const server::Context context{archive_.store(), workbench_, captures};
    add_test_routes(router_, context);
    add_equipment_routes(router_, context);
    add_audit_routes(router_, context);
    add_plan_routes(router_, context);
    server::Request first{.method = "POST", .path = "/api/tests", .body = std::string(app::example_table2)};
    AXIOMETRY_CONTRACT(answer(std::move(first)).value().status == 201);
  }

  /// Nothing where it takes seconds by its nature, which is left to the tests of the server.
  std::optional<server::Response> answer(server::Request request) {
    request.actor = "A. Tester";
    const bool only_read = request.method == "GET";
    const server::Job job = router_.read(std::make_shared<server::Request>(std::move(request)));
    if (job.load == server::Load::lone || (job.load == server::Load::heavy && only_read)) return std::nullopt;
    return job.answer({});
  }

  store::Store& store() { return archive_.store(); }

 private:
  testing_support::Archive archive_;
  app::Workbench workbench_{archive_.store()};
  server::Router router_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t requests_of_an_archive = 200;
  static std::unique_ptr<Api> api;
  static std::size_t asked = 0;
  if (!api || ++asked % requests_of_an_archive == 0) api = std::make_unique<Api>();

  const auto [line, rest] = fuzzing::parted(fuzzing::as_text(data, size));
  const auto [type, body] = fuzzing::parted(rest);
  const std::size_t blank = line.find(' ');
  if (blank == line.npos) return 0;
  const auto target = server::parse_target(line.substr(blank + 1));
  if (!target) return 0;
  server::Request request{.method = std::string(line.substr(0, blank)), .path = target->path, .query = target->query};
  if (!type.empty()) request.headers.emplace_back("content-type", std::string(type));
  request.body = std::string(body);
  const auto answered = api->answer(std::move(request));
  if (!answered) return 0;
  const server::Response& response = *answered;
  AXIOMETRY_CONTRACT(response.status >= 200 && response.status < 500);
  if (response.status >= 400) {
    const auto said = json::parse(response.body);
    AXIOMETRY_CONTRACT(said && said->find("error") != nullptr);
  } else if (response.content_type == "application/json") {
    AXIOMETRY_CONTRACT(response.body.empty() || json::parse(response.body).has_value());
  }
  return 0;
}
