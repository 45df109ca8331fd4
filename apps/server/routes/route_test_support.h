// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

#include "axiometry/base/json/json.h"
#include "server/routes/described_test_support.h"

/// What tests of routes begin with: asking below a path, forms, answers and refusals as values.
namespace axiometry::server {

/// Files under the names of their parts, such as "plan.x", and texts.
inline std::string form_of(const Pairs& files, const Pairs& texts, std::string_view extension = ".x") {
  std::string body;
  for (const auto& [name, bytes] : files)
    body += fmt::format("--b\r\nContent-Disposition: form-data; name=\"{0}\"; filename=\"{0}{1}\"\r\n\r\n{2}\r\n", name,
                        extension, bytes);
  for (const auto& [name, text] : texts)
    body += fmt::format("--b\r\nContent-Disposition: form-data; name=\"{}\"\r\n\r\n{}\r\n", name, text);
  return body + "--b--\r\n";
}

inline constexpr const char* json_type = "application/json";
inline constexpr const char* form_type = "multipart/form-data; boundary=b";

class RouteTest : public testing::Test {
 protected:
  explicit RouteTest(std::string_view below) : below_(below) {}

  Response ask(std::string method, std::string_view path, std::string body = {}, Pairs query = {},
               std::string type = json_type, language::Language language = language::Language::english) const {
    Request request;
    request.method = std::move(method);
    request.path = below_ + std::string(path);
    request.query = std::move(query);
    if (!body.empty()) request.headers = {{"content-type", std::move(type)}};
    request.body = std::move(body);
    request.actor = "A. Tester";
    request.language = language;
    request.stop = stop;
    return router.answer(request);
  }

  static json::Value value_of(const Response& response, int status = 200) {
    EXPECT_EQ(response.status, status) << response.body.substr(0, 500);
    auto value = json::parse(response.body);
    EXPECT_TRUE(value) << response.body.substr(0, 500);
    return value ? *value : json::Value::object();
  }
  static std::string refusal(const Response& response, int status = 422) {
    return value_of(response, status).find("error")->find("message")->text();
  }

  DescribedRouter router;
  std::stop_token stop;  ///< of what asks

 private:
  std::string below_;
};

}  // namespace axiometry::server
