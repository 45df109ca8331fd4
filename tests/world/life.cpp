// SPDX-License-Identifier: Apache-2.0
#include "life.h"

#include <fmt/format.h>

#include "axiometry/app/live/service/capture_keeping.h"
#include "expect.h"

namespace axiometry::world {

Life::Life(const std::string& file) {
  auto opened = store::Store::open(file);
  if (!opened) {
    refused_ = opened.error().to_string();
    return;
  }
  store_ = *std::move(opened);
  workbench_.emplace(*store_);
  auto captures =
      app::CaptureService::open({.folder = file + ".captures", .sources = {}}, app::keeping_in(*workbench_));
  if (!captures) broken("captures cannot be opened: " + captures.error().to_string());
  captures_ = *std::move(captures);
  const server::Context context{*store_, *workbench_, *captures_};
  add_test_routes(router_, context);
  add_equipment_routes(router_, context);
  add_audit_routes(router_, context);
  add_plan_routes(router_, context);
}

server::Response Life::ask(std::string method, std::string path, std::string body, server::Pairs query) {
  server::Request request;
  request.method = std::move(method);
  request.path = std::move(path);
  request.query = std::move(query);
  request.body = std::move(body);
  request.actor = "A. Tester";
  request.headers = {{"x-file-name", "run.csv"}};
  return router_.answer(std::move(request));
}

json::Value parsed(const server::Response& response) {
  auto value = json::parse(response.body);
  if (!value) broken(fmt::format("answer {} is no JSON: {}", response.status, response.body.substr(0, 200)));
  return *std::move(value);
}

int number_of(const json::Value& object, std::string_view name) {
  const json::Value* const member = object.find(name);
  if (member == nullptr || !member->is(json::Kind::number)) broken(fmt::format("the answer has no {}", name));
  return static_cast<int>(member->number());
}

}  // namespace axiometry::world
