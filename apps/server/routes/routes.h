// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "axiometry/base/embedded_file.h"
#include "axiometry/store/store.h"
#include "server/access/token.h"
#include "server/routing/router.h"

namespace axiometry::app {
class Workbench;
class CaptureService;
}  // namespace axiometry::app

/// The API, one source for each kind of thing, as apps/server/openapi.json describes it.
namespace axiometry::server {

/// What routes work with. All of it may be used from many threads.
struct Context {
  store::Store& store;
  app::Workbench& workbench;
  app::CaptureService& captures;
};

/// What service routes need. `token` says who may see more of health than "ok".
struct ServiceContext {
  store::Store& store;
  TokenGate& token;
  std::size_t upload_bytes = 0;
};

void add_service_routes(Router& router, const ServiceContext& context);  ///< health, openapi.json, vocabulary
void add_session_routes(Router& router, TokenGate& token);               ///< signing in and out
void add_test_routes(Router& router, const Context& context);       ///< previews, tests, versions, reports, figures
void add_rule_routes(Router& router, const Context& context);       ///< kept tests by other rules; keep nothing
void add_periodic_routes(Router& router, const Context& context);   ///< periodic errors of kept tests; keep nothing
void add_equipment_routes(Router& router, const Context& context);  ///< machines, axes, instruments, trends
void add_audit_routes(Router& router, const Context& context);      ///< the audit trail
void add_plan_routes(Router& router, const Context& context);       ///< plans, their sheets and NC programs
void add_capture_routes(Router& router, const Context& context);    ///< live sources and captures
void add_tracking_routes(Router& router);  ///< station, lines and evaluation of a tracking interferometer; keep nothing
void add_coordinates_routes(Router& router);  ///< points from lengths, with angles or without; keep nothing
void add_dynamic_routes(Router& router);      ///< recordings without standstills; keep nothing
void add_motion_routes(Router& router);       ///< straightness, angles, squareness; keep nothing
void add_calibration_routes(Router& router, const Context& context);   ///< lines and the 21 errors that are kept
void add_compensation_routes(Router& router, const Context& context);  ///< tables by which controls correct an axis
void add_volumetric_routes(Router& router);  ///< plan, errors and field of a volumetric calibration; keep nothing
/// The page: each file by its name, and index.html for every path that is not of the API, since the page routes by
/// path; "/" says how to build it where there is none. Files NAME.gz are sent instead of NAME to who takes them.
void add_page_routes(Router& router, std::span<const EmbeddedFile> files);

std::span<const EmbeddedFile> page_files();     ///< web/bundle/, embedded (generated); empty where it was not built
std::span<const EmbeddedFile> openapi_files();  ///< openapi.json (generated)

}  // namespace axiometry::server
