// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/store/store.h"
#include "router.h"

namespace axiometry::app {
class Workbench;
class CaptureService;
}  // namespace axiometry::app

/// The API, one source for each kind of thing; apps/server/openapi.json describes it and web/src/api/types.ts is its
/// shape for the page.
namespace axiometry::server {

/// What routes work with. All of it may be used from many threads.
struct Context {
  store::Store& store;
  app::Workbench& workbench;
  app::CaptureService& captures;
};

void add_service_routes(Router& router, const Context& context);    ///< health, openapi.json, vocabulary
void add_test_routes(Router& router, const Context& context);       ///< previews, tests, versions, reports, figures
void add_equipment_routes(Router& router, const Context& context);  ///< machines, axes, instruments, trends, audit
void add_plan_routes(Router& router, const Context& context);       ///< plans, their sheets and NC programs
void add_capture_routes(Router& router, const Context& context);    ///< live sources and captures
void add_page_routes(Router& router);                               ///< the page, embedded in the program

}  // namespace axiometry::server
