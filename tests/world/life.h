// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "axiometry/app/live/service/capture_service.h"
#include "axiometry/app/workbench/workbench.h"
#include "axiometry/base/json/json.h"
#include "axiometry/store/store.h"
#include "server/routes/routes.h"

namespace axiometry::world {

/// A program that runs on an archive, between its start and its end.
class Life {
 public:
  explicit Life(const std::string& file);

  bool began() const { return store_ != nullptr; }
  const std::string& refused() const { return refused_; }
  store::Store& store() { return *store_; }
  app::Workbench& workbench() { return *workbench_; }

  server::Response ask(std::string method, std::string path, std::string body = {}, server::Pairs query = {});

 private:
  std::unique_ptr<store::Store> store_;
  std::optional<app::Workbench> workbench_;
  std::unique_ptr<app::CaptureService> captures_;  // runs none: they would do so in threads of their own
  server::Router router_;
  std::string refused_;
};

/// An answer, and a whole number in one. Broken where there is none.
json::Value parsed(const server::Response& response);
int number_of(const json::Value& object, std::string_view name);

}  // namespace axiometry::world
