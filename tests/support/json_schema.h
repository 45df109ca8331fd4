// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "axiometry/base/json/json.h"
#include "axiometry/base/text/text.h"

namespace axiometry::testing_support {

/// The keywords of JSON Schema (2020-12) that apps/server/openapi.json needs. One that is not known here throws, so
/// that nothing is taken for checked that is not.
class JsonSchemas {
 public:
  using Value = json::Value;
  using Kind = json::Kind;
  using Faults = std::vector<std::string>;

  /// `root` is what references ("#/components/…") begin at; it must outlive this.
  explicit JsonSchemas(const Value& root) : root_(root) {}

  /// What is wrong with a value, each with its place: "/tests/0/id: found …".
  Faults faults(const Value& schema, const Value& value) const { return check(schema, value, "").faults; }

  const Value& resolved(const Value& schema) const {
    const Value* reference = schema.is(Kind::object) ? schema.find("$ref") : nullptr;
    if (reference == nullptr) return schema;
    const Value* at = &root_;
    for (const std::string_view part : text::split(std::string_view(reference->text()).substr(2), '/')) {
      at = at->find(part);
      if (at == nullptr) throw std::logic_error("no " + reference->text());
    }
    return *at;
  }

 private:
  struct Found {
    Faults faults{};
    std::set<std::string> known{};  // members that were described

    void add(Found more) {
      faults.insert(faults.end(), more.faults.begin(), more.faults.end());
      known.merge(more.known);
    }
    void fault(const std::string& place, const std::string& what) { faults.push_back(place + ": " + what); }
  };

  static std::string shown(const Value& value) { return json::dump(value, 0).substr(0, 60); }
  static bool same(const Value& a, const Value& b) { return json::dump(a, 0) == json::dump(b, 0); }
  static bool has_type(const Value& value, const std::string& type) {
    if (type == "integer") return value.is(Kind::number) && value.number() == std::floor(value.number());
    return json::kind_name(value.kind()) == type;
  }

  static bool fits_type(const Value& types, const Value& value) {
    if (types.is(Kind::text)) return has_type(value, types.text());
    return std::ranges::any_of(types.items(), [&](const Value& type) { return has_type(value, type.text()); });
  }

  /// Of what a keyword says about a value of any kind.
  Found check(const Value& schema, const Value& value, const std::string& place) const {
    Found found;
    if (schema.is(Kind::boolean)) {
      if (!schema.boolean()) found.fault(place, "found " + shown(value) + ", expected none");
      return found;
    }
    for (const auto& [keyword, said] : schema.members()) {
      if (keyword == "$ref") found.add(check(resolved(schema), value, place));
      if (keyword == "allOf")
        for (const Value& part : said.items()) found.add(check(part, value, place));
      if (keyword == "anyOf" || keyword == "oneOf")
        found.add(alternatives(said.items(), value, place, keyword == "oneOf"));
      if (keyword == "type" && !fits_type(said, value))
        found.fault(place, fmt::format("found {}, expected {}", shown(value), json::dump(said, 0)));
      if (keyword == "enum" && std::ranges::none_of(said.items(), [&](const Value& one) { return same(one, value); }))
        found.fault(place, fmt::format("found {}, expected one of {}", shown(value), json::dump(said, 0)));
      if (keyword == "const" && !same(said, value))
        found.fault(place, fmt::format("found {}, expected {}", shown(value), shown(said)));
      if (!is_known(keyword)) throw std::logic_error("the keyword " + keyword + " is not known to the tests");
    }
    if (const Value* content = schema.find("contentSchema"); content && value.is(Kind::text)) {
      const auto inner = json::parse(value.text());
      found.add(inner ? check(*content, *inner, place) : check(Value(false), value, place));
    }
    found.add(of_plain(schema, value, place));
    if (value.is(Kind::array)) found.add(of_items(schema, value.items(), place));
    if (value.is(Kind::object)) found.add(of_members(schema, value, place));
    if (value.is(Kind::object)) found.add(left_over(schema, value, place, found.known));
    return found;
  }

  static bool is_known(std::string_view keyword) {
    constexpr std::string_view known =
        " $ref allOf anyOf oneOf type enum const minimum maximum exclusiveMinimum exclusiveMaximum minLength pattern "
        "items prefixItems "
        "minItems maxItems uniqueItems properties required propertyNames additionalProperties unevaluatedProperties "
        "format contentMediaType contentSchema "
        "description default examples ";
    return known.find(fmt::format(" {} ", keyword)) != std::string_view::npos;
  }

  /// Where none fits, what is wrong with the one that gets furthest.
  Found alternatives(const std::vector<Value>& schemas, const Value& value, const std::string& place, bool one) const {
    Found fitting;
    Found nearest;
    std::size_t fit = 0;
    for (const Value& schema : schemas) {
      Found found = check(schema, value, place);
      const auto reach = [](const Found& of) { return of.faults.empty() ? 0 : of.faults.front().find(": "); };
      if (found.faults.empty() && ++fit > 0)
        fitting.add(std::move(found));
      else if (nearest.faults.empty() || reach(found) > reach(nearest))
        nearest = std::move(found);
    }
    if (fit == 0) return nearest;
    if (one && fit > 1) fitting.fault(place, "found what fits several alternatives, expected one");
    return fitting;
  }

  static Found of_plain(const Value& schema, const Value& value, const std::string& place) {
    Found found;
    const Value *least = schema.find("minimum"), *most = schema.find("maximum"), *end = schema.find("exclusiveMaximum");
    const Value* above = schema.find("exclusiveMinimum");
    const double x = value.is(Kind::number) ? value.number() : std::nan("");
    if ((least && x < least->number()) || (most && x > most->number()) || (end && x >= end->number()) ||
        (above && x <= above->number()))
      found.fault(place, fmt::format("found {}, expected it within its bounds", x));
    const Value* length = schema.find("minLength");
    if (length && value.is(Kind::text) && static_cast<double>(value.text().size()) < length->number())
      found.fault(place, fmt::format("found {}, expected a longer text", shown(value)));
    const Value* pattern = schema.find("pattern");
    if (pattern && value.is(Kind::text) && !std::regex_search(value.text(), std::regex(pattern->text())))
      found.fault(place, fmt::format("found {}, expected {}", shown(value), pattern->text()));
    return found;
  }

  Found of_items(const Value& schema, const std::vector<Value>& items, const std::string& place) const {
    Found found;
    const Value *least = schema.find("minItems"), *most = schema.find("maxItems"), *rest = schema.find("items");
    const auto count = static_cast<double>(items.size());
    if ((least && count < least->number()) || (most && count > most->number()))
      found.fault(place, fmt::format("found {} items, expected as many as there must be", items.size()));
    const Value* first = schema.find("prefixItems");
    const std::size_t placed = first ? std::min(first->items().size(), items.size()) : 0;
    std::set<std::string> seen;
    for (std::size_t k = 0; k < items.size(); ++k) {
      const Value* item = k < placed ? &first->items()[k] : rest;
      if (item) found.add({check(*item, items[k], fmt::format("{}/{}", place, k)).faults});
      if (schema.find("uniqueItems") && !seen.insert(json::dump(items[k], 0)).second)
        found.fault(place, "found an item twice, expected each once");
    }
    return found;
  }

  Found of_members(const Value& schema, const Value& object, const std::string& place) const {
    Found found;
    const Value *own = schema.find("properties"), *further = schema.find("additionalProperties");
    const Value *names = schema.find("propertyNames"), *required = schema.find("required");
    if (required)
      for (const Value& name : required->items())
        if (!object.find(name.text())) found.fault(place, "found no " + name.text() + ", expected it");
    for (const auto& [name, value] : object.members()) {
      const std::string inner = place + "/" + name;
      if (names) found.add({check(*names, Value(name), inner).faults});
      const Value* member = own ? own->find(name) : nullptr;
      if (member == nullptr) member = further;
      if (member == nullptr) continue;
      found.add({check(*member, value, inner).faults});
      found.known.insert(name);
    }
    return found;
  }

  /// Of members that nothing beside "unevaluatedProperties" describes.
  Found left_over(const Value& schema, const Value& object, const std::string& place,
                  const std::set<std::string>& known) const {
    Found found;
    const Value* left = schema.find("unevaluatedProperties");
    if (left == nullptr) return found;
    for (const auto& [name, value] : object.members())
      if (!known.contains(name)) found.add({check(*left, value, place + "/" + name).faults});
    return found;
  }

  const Value& root_;
};

}  // namespace axiometry::testing_support
