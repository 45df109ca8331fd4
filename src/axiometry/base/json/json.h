// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "axiometry/base/read_budget.h"
#include "axiometry/base/result.h"

/// JSON (RFC 8259) as a tree that remembers where each value stood, so that a wrong value in a test
/// file is reported with line and column.
namespace axiometry::json {

enum class Kind { null, boolean, number, text, array, object };

std::string_view kind_name(Kind kind);  ///< "null", "boolean", "number", "string", "array", "object"

class Value {
 public:
  Value() = default;
  Value(bool b) : content_(b) {}
  Value(double x) : content_(x) {}
  Value(int x) : Value(static_cast<double>(x)) {}
  Value(std::size_t x) : Value(static_cast<double>(x)) {}
  Value(std::string s) : content_(std::move(s)) {}
  Value(std::string_view s) : Value(std::string(s)) {}
  Value(const char* s) : Value(std::string(s)) {}
  static Value array(std::vector<Value> items = {});
  static Value object();

  Kind kind() const { return static_cast<Kind>(content_.index()); }
  bool is(Kind k) const { return kind() == k; }
  TextPosition at() const { return at_; }

  bool boolean() const;                                               ///< contract: kind is boolean
  double number() const;                                              ///< contract: kind is number
  const std::string& text() const;                                    ///< contract: kind is text
  const std::vector<Value>& items() const;                            ///< contract: kind is array
  const std::vector<std::pair<std::string, Value>>& members() const;  ///< contract: kind is object, in order

  const Value* find(std::string_view name) const;  ///< member of an object, or nullptr

  /// Appends to an array; appends a member to an object (the caller keeps names unique).
  Value& push(Value item);
  Value& add(std::string_view name, Value value);

 private:
  friend class TreeBuilder;
  using Items = std::vector<Value>;
  using Members = std::vector<std::pair<std::string, Value>>;
  explicit Value(Items items) : content_(std::move(items)) {}
  explicit Value(Members members) : content_(std::move(members)) {}

  std::variant<std::monostate, bool, double, std::string, Items, Members> content_;  // types in the order of Kind
  TextPosition at_;
};

struct ParseLimits {
  std::size_t bytes = read_budget::file_bytes;  ///< a test of a million readings has about 10 MB
  std::size_t depth = read_budget::nesting;
  std::size_t values = read_budget::json_values;
};

/// Fails, with line and column, on anything RFC 8259 does not allow, on a byte order mark other than
/// UTF-8's (which is skipped), on a member name given twice, a number that overflows, nesting deeper
/// or a text longer or of more values than the limits.
Result<Value> parse(std::string_view text, ParseLimits limits = {});

/// indent 0 writes one line. Numbers as the shortest text that reads back the same; a number that is
/// not finite breaks the contract. Bytes that are not UTF-8 are written as U+FFFD.
std::string dump(const Value& value, int indent = 2);

}  // namespace axiometry::json
