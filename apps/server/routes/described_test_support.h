// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "axiometry/base/json/json.h"
#include "axiometry/base/text/text.h"
#include "server/routes/routes.h"
#include "tests/support/json_schema.h"

namespace axiometry::server {

inline const json::Value& api_description() {
  static const auto parsed = json::parse(openapi_files().front().bytes);
  return *parsed;
}

/// Holds what is asked and answered against apps/server/openapi.json.
class Described {
 public:
  using Faults = testing_support::JsonSchemas::Faults;

  static Faults faults(const Request& request, const Response& response) {
    Described described(request, response);
    described.hold();
    return std::move(described.found_);
  }

 private:
  using Value = json::Value;

  Described(const Request& request, const Response& response) : request_(request), response_(response) {}

  void hold() {
    const Value* path = path_of_request();
    const Value* operation = path == nullptr ? nullptr : path->find(method());
    if (operation == nullptr) {
      const int expected = path == nullptr ? 404 : 405;
      if (response_.status != expected && !befalls_any()) found_.push_back("this is not described");
      return check_content(failure().find("content"));
    }
    const Value* answer = operation->find("responses")->find(fmt::format("{}", response_.status));
    if (answer == nullptr && befalls_any()) answer = &failure();
    if (answer == nullptr)
      found_.push_back("a status that is not described");
    else
      check_content(schemas_.resolved(*answer).find("content"));
    if (response_.status < 300) check_request(*operation);
  }

  std::string method() const { return request_.method == "HEAD" ? "get" : text::to_lower(request_.method); }

  static std::regex expression_of(const std::string& pattern) {
    const std::string literal = std::regex_replace(pattern, std::regex(R"(\.)"), R"(\.)");
    return std::regex(std::regex_replace(literal, std::regex(R"(\{[a-z]+\})"), "[^/]+"));
  }

  /// The one with this method, and the fewest places for anything.
  const Value* path_of_request() const {
    const Value* best = nullptr;
    std::pair<bool, std::ptrdiff_t> least;
    for (const auto& [pattern, path] : api_description().find("paths")->members()) {
      if (!std::regex_match(request_.path, expression_of(pattern))) continue;
      const std::pair of{path.find(method()) == nullptr, std::ranges::count(pattern, '{')};
      if (best == nullptr || of < least) std::tie(best, least) = std::tuple(&path, of);
    }
    return best;
  }

  const Value& failure() const { return *api_description().find("components")->find("responses")->find("Failure"); }

  bool befalls_any() const {
    return std::ranges::any_of(failure().find("x-statuses")->items(),
                               [&](const Value& status) { return status.number() == response_.status; });
  }

  void check_content(const Value* described) {
    if (described == nullptr || request_.method == "HEAD") {
      if (!response_.body.empty()) found_.push_back("a body, expected none");
      return;
    }
    const std::string type = response_.content_type.substr(0, response_.content_type.find(';'));
    const Value* content = described->find(type);
    if (content == nullptr)
      found_.push_back("content of the type " + type + ", which is not described");
    else if (type == "application/json")
      check_json(*content, response_.body);
  }

  void check_json(const Value& content, std::string_view body) {
    const auto value = json::parse(body);
    if (!value) return found_.push_back(value.error().to_string());
    const Faults faults = schemas_.faults(*content.find("schema"), *value);
    found_.insert(found_.end(), faults.begin(), faults.end());
  }

  /// What was taken must be described as it was sent.
  void check_request(const Value& operation) {
    for (const auto& [name, text] : request_.query)
      if (!has_parameter(operation, name)) found_.push_back("the query " + name + " is not described");
    const Value* sent = operation.find("requestBody");
    if (request_.body.empty()) {
      if (sent && sent->find("required")->boolean()) found_.push_back("a request without a body, expected one");
      return;
    }
    const Value* content = sent ? sent->find("content") : nullptr;
    if (content == nullptr) return found_.push_back("a request with a body, expected none");
    if (const Value* json = content->find("application/json")) check_json(*json, request_.body);
  }

  bool has_parameter(const Value& operation, std::string_view name) const {
    const Value* parameters = operation.find("parameters");
    return parameters && std::ranges::any_of(parameters->items(), [&](const Value& one) {
             const Value& parameter = schemas_.resolved(one);
             return parameter.find("in")->text() == "query" && parameter.find("name")->text() == name;
           });
  }

  const Request& request_;
  const Response& response_;
  testing_support::JsonSchemas schemas_{api_description()};
  Faults found_;
};

/// Whatever it answers must be described.
class DescribedRouter : public Router {
 public:
  Response answer(const Request& request) const {
    Response response = Router::answer(request);
    for (const std::string& fault : Described::faults(request, response))
      ADD_FAILURE() << "openapi.json, " << request.method << " " << request.path << " with the status "
                    << response.status << ": " << fault;
    return response;
  }
};

}  // namespace axiometry::server
