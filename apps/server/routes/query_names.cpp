// SPDX-License-Identifier: Apache-2.0
#include "server/routes/query_names.h"

#include <algorithm>

#include "axiometry/base/contract.h"
#include "axiometry/base/json.h"

namespace axiometry::server {
namespace {

/// The parameter itself, where "#/components/parameters/NAME" stands for it.
const json::Value& resolved_parameter(const json::Value& description, const json::Value& parameter) {
  const json::Value* reference = parameter.find("$ref");
  if (reference == nullptr) return parameter;
  constexpr std::string_view begin = "#/components/parameters/";
  const std::string_view text = reference->text();
  AXIOMETRY_CONTRACT(text.starts_with(begin));
  const json::Value* found = description.find("components")->find("parameters")->find(text.substr(begin.size()));
  AXIOMETRY_CONTRACT(found != nullptr);
  return *found;
}

std::string in_capitals(std::string_view method) {
  std::string result(method);
  std::ranges::transform(result, result.begin(), [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
  return result;
}

}  // namespace

QueryNames::QueryNames(std::string_view openapi) {
  const auto description = json::parse(openapi);
  AXIOMETRY_CONTRACT(description);
  for (const auto& [path, operations] : description->find("paths")->members())
    for (const auto& [method, operation] : operations.members()) {
      std::vector<std::string>& names = names_[{in_capitals(method), path}];
      const json::Value* parameters = operation.find("parameters");
      if (parameters == nullptr) continue;
      for (const json::Value& given : parameters->items()) {
        const json::Value& parameter = resolved_parameter(*description, given);
        if (parameter.find("in")->text() == "query") names.emplace_back(parameter.find("name")->text());
      }
    }
}

const std::vector<std::string>* QueryNames::of(std::string_view method, std::string_view pattern) const {
  const auto found = names_.find(std::pair{std::string(method), std::string(pattern)});
  return found == names_.end() ? nullptr : &found->second;
}

}  // namespace axiometry::server
