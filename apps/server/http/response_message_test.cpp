// SPDX-License-Identifier: Apache-2.0
#include "server/http/response_message.h"

#include <gtest/gtest.h>

#include <string>

namespace axiometry::server {
namespace {

std::string disposition(const Response& response, bool is_of_api) {
  const ResponseMessage message = message_of(response, {.is_of_api = is_of_api});
  return std::string(message[boost::beast::http::field::content_disposition]);
}

constexpr const char* api_file = "attachment; filename=\"api.json\"";

TEST(ResponseMessage, of_the_API_is_a_file_where_it_is_JSON) {
  EXPECT_EQ(disposition(json_response(json::Value::object()), true), api_file);
  EXPECT_EQ(disposition(refusal(404, "there is nothing of this name"), true), api_file);
  EXPECT_EQ(disposition(receipt_of(json_response(json::Value::object(), 201), {}), true), api_file);
  EXPECT_EQ(disposition({.content_type = "image/svg+xml", .body = "<svg/>"}, true), "") << "which is looked at";
}

TEST(ResponseMessage, keeps_the_name_that_a_download_has) {
  const std::string name = disposition(download("{}", "application/json", "mill.plan.json"), true);
  EXPECT_EQ(name, "attachment; filename=\"mill.plan.json\"; filename*=UTF-8''mill.plan.json");
}

TEST(ResponseMessage, that_refuses_a_page_is_read_by_who_asked_for_it) {
  EXPECT_EQ(disposition(refusal(421, "found the host \"a\", expected localhost"), false), "");
}

}  // namespace
}  // namespace axiometry::server
