// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "axiometry/app/live/service/capture_keeping.h"
#include "axiometry/app/live/service/capture_service.h"
#include "axiometry/app/workbench/workbench.h"
#include "tests/support/archive.h"

namespace axiometry::testing_support {

/// Captures that become tables, over an archive.
class TableCaptures : public testing::Test {
 protected:
  std::unique_ptr<app::CaptureService> open(std::vector<app::CaptureSource> sources = {}) {
    app::CaptureSettings settings{.folder = folder_, .sources = std::move(sources)};
    settings.for_undo = for_undo_;
    auto service = app::CaptureService::open(std::move(settings), app::keeping_in(workbench_));
    EXPECT_TRUE(service);
    return *std::move(service);
  }

  static app::CaptureState wait_for(app::CaptureService& service, store::Id id,
                                    const std::function<bool(const app::CaptureState&)>& so) {
    for (int k = 0; k < 6000; ++k) {
      if (auto state = service.state(id); !state || so(*state)) return state.value_or(app::CaptureState());
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return *service.state(id);
  }
  static app::CaptureState end_of(app::CaptureService& service, const Result<app::CaptureState>& started) {
    EXPECT_TRUE(started) << started.error().to_string();
    if (!started) return {};
    return wait_for(service, started->id, [](const app::CaptureState& state) { return has_ended(state.stage); });
  }

  testing_support::Archive archive_;
  app::Workbench workbench_{archive_.store()};
  std::string folder_ = archive_.folder() + "/captures";
  Duration for_undo_ = Duration::s(0);
};

}  // namespace axiometry::testing_support
