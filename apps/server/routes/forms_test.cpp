// SPDX-License-Identifier: Apache-2.0
// What all routes that take a form have in common.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/routes/route_test_support.h"
#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

using testing::HasSubstr;

class RoutesWithForms : public RouteTest {
 protected:
  RoutesWithForms() : RouteTest("/api/") {
    add_tracking_routes(router);
    add_coordinates_routes(router);
    add_volumetric_routes(router);
  }

  std::string refused(std::string_view path, const Pairs& files, const Pairs& texts) const {
    return refusal(ask("POST", path, form_of(files, texts), {}, form_type));
  }
};

TEST_F(RoutesWithForms, refuse_options_that_stand_there_twice) {
  for (const char* path : {"tracking/evaluation", "tracking/multilateration", "tracking/polar",
                           "volumetric/identification", "volumetric/assembly"})
    EXPECT_THAT(refused(path, {}, {{"options", "{}"}, {"options", "{}"}}),
                HasSubstr("found the part \"options\" twice in the form, expected it once"))
        << path;
}

TEST_F(RoutesWithForms, refuse_a_file_under_the_name_of_a_text_and_a_text_under_that_of_a_file) {
  EXPECT_THAT(refused("tracking/evaluation", {{"options", "{}"}}, {}), HasSubstr("found the part \"options\""));
  EXPECT_THAT(refused("tracking/evaluation", {}, {{"plan", "{}"}}), HasSubstr("found the part \"plan\""));
}

}  // namespace
}  // namespace axiometry::server
