// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/base/vector3.h"

/// Reading the members of a JSON object one by one, so that none is overlooked: those that nobody asked for are refused
/// with the nearest name that is known.
namespace axiometry::formats {

class JsonMembers {
 public:
  /// `what` names the object in messages: "setup". Fails when the value is no object.
  static Result<JsonMembers> of(const json::Value& value, std::string what);

  /// nullptr when absent or null.
  const json::Value* optional(std::string_view name);

  /// Fails when absent or null.
  Result<const json::Value*> required(std::string_view name);

  /// Replaces `target` when the member is there. Each fails when it is of another kind; numbers are finite.
  Result<void> take(std::string_view name, double& target);
  Result<void> take(std::string_view name, std::string& target);
  Result<void> take(std::string_view name, Vector3& target);

  /// Members that are known and have no meaning here.
  void pass_over(std::string_view name);

  /// Fails on the first member that was not asked for.
  Result<void> finish() const;

  /// For files that other programs write, with members of their own: the names that were not asked for. Fails on one
  /// that looks like a known name.
  Result<std::vector<std::string>> others() const;

 private:
  JsonMembers(const json::Value& value, std::string what) : value_(&value), what_(std::move(what)) {}

  const json::Value* value_;
  std::string what_;
  std::vector<std::string> known_;
};

/// Each fails, saying what stands there, when the value is of another kind; `what` names it.
Result<double> number_in(const json::Value& value, std::string_view what);
Result<std::string> text_in(const json::Value& value, std::string_view what);
Result<Vector3> vector_in(const json::Value& value, std::string_view what);  ///< [x, y, z]
Result<Matrix3> matrix_in(const json::Value& value, std::string_view what);  ///< three rows of three
/// matrix_in() of a covariance of X, Y, Z. Fails on one that no place can have: not symmetric, a variance below 0, a
/// covariance beyond what the variances allow, or not positive semidefinite, each but for numbers rounded to three
/// digits.
Result<Matrix3> covariance_in(const json::Value& value, std::string_view what);
Result<const std::vector<json::Value>*> items_in(const json::Value& value, std::string_view what);

/// The text of the member "format" of a JSON object; empty where there is none, or `bytes` is no such object.
std::string stated_format(std::string_view bytes);

json::Value vector_value(Vector3 v);
json::Value matrix_value(const Matrix3& m);

}  // namespace axiometry::formats
