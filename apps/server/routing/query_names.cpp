// SPDX-License-Identifier: Apache-2.0
#include "server/routing/query_names.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/contract.h"
#include "axiometry/base/json/json.h"

namespace axiometry::server {
namespace {

/// The part itself, where "#/components/KIND/NAME" stands for it; of the kinds parameters and schemas.
const json::Value& resolved_part(const json::Value& description, std::string_view kind, const json::Value& part) {
  const json::Value* reference = part.find("$ref");
  if (reference == nullptr) return part;
  const std::string begin = fmt::format("#/components/{}/", kind);
  const std::string_view text = reference->text();
  AXIOMETRY_CONTRACT(text.starts_with(begin));
  const json::Value* found = description.find("components")->find(kind)->find(text.substr(begin.size()));
  AXIOMETRY_CONTRACT(found != nullptr);
  return *found;
}

std::vector<std::string> enumerated_words(const json::Value& description, const json::Value& parameter) {
  std::vector<std::string> words;
  const json::Value* schema = parameter.find("schema");
  if (schema == nullptr) return words;  // JSON, in a content
  if (const json::Value* given = resolved_part(description, "schemas", *schema).find("enum"))
    for (const json::Value& word : given->items()) words.emplace_back(word.text());
  return words;
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
      std::vector<QueryName>& names = names_[{in_capitals(method), path}];
      const json::Value* parameters = operation.find("parameters");
      if (parameters == nullptr) continue;
      for (const json::Value& given : parameters->items()) {
        const json::Value& parameter = resolved_part(*description, "parameters", given);
        if (parameter.find("in")->text() == "query")
          names.push_back({std::string(parameter.find("name")->text()), enumerated_words(*description, parameter)});
      }
    }
}

const std::vector<QueryName>* QueryNames::of(std::string_view method, std::string_view pattern) const {
  const auto found = names_.find(std::pair{std::string(method), std::string(pattern)});
  return found == names_.end() ? nullptr : &found->second;
}

}  // namespace axiometry::server
