// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "axiometry/base/contract.h"
#include "axiometry/base/json/json.h"

/// JSON that is told once, member by member, and becomes either a text in one line, as json::dump() would write it but
/// without a tree in between, or a tree. Of 100 000 results the tree would cost more than their text.
namespace axiometry::json {

/// A text that grows. What is written begins at room() and ends where end_at() says.
class Text {
 public:
  /// Where so many bytes have room at least, and behind them one for every object and list that is still open, so that
  /// closing them takes no memory that may be lacking.
  char* room(std::size_t bytes) {
    if (text_.size() - used_ < bytes + open_) grow(bytes);
    return text_.data() + used_;
  }
  void end_at(const char* end) { used_ = static_cast<std::size_t>(end - text_.data()); }

  void append(char c) {
    char* const at = room(1);
    *at = c;
    end_at(at + 1);
  }
  void append(std::string_view s);         ///< as it is
  void append_quoted(std::string_view s);  ///< quotes and escapes; bytes that are not UTF-8 as U+FFFD
  void append_name(std::string_view name, bool behind_another);  ///< name of a member
  void append_number(double x);                                  ///< contract: finite

  std::string take();

 private:
  friend class Object;
  friend class List;
  void grow(std::size_t bytes);
  void close(char mark) noexcept {
    text_[used_++] = mark;
    --open_;
  }

  std::string text_;
  std::size_t used_ = 0;
  std::size_t open_ = 0;
};

class Object;
class List;

/// Where one value goes, which is put there once.
class [[nodiscard]] Place {
 public:
  explicit Place(Text& text) : text_(&text) {}
  explicit Place(Value& tree) : tree_(&tree) {}

  void put(std::nullopt_t) const {
    if (text_ != nullptr)
      text_->append("null");
    else
      *tree_ = Value();
  }
  void put(bool b) const {
    if (text_ != nullptr)
      text_->append(b ? std::string_view("true") : std::string_view("false"));
    else
      *tree_ = Value(b);
  }
  void put(double x) const {
    if (text_ != nullptr)
      text_->append_number(x);
    else
      *tree_ = Value(x);
  }
  void put(int x) const { put(static_cast<double>(x)); }
  void put(std::size_t x) const { put(static_cast<double>(x)); }
  void put(std::string_view s) const {
    if (text_ != nullptr)
      text_->append_quoted(s);
    else
      *tree_ = Value(s);
  }
  void put(const char* s) const { put(std::string_view(s)); }
  void put(const std::string& s) const { put(std::string_view(s)); }
  void put(Value value) const;
  template <typename T>
  void put(const std::optional<T>& x) const {
    if (x)
      put(*x);
    else
      put(std::nullopt);
  }

 private:
  friend class Object;
  friend class List;
  Text* text_ = nullptr;
  Value* tree_ = nullptr;
};

/// Members in the order in which they are added; the caller keeps names unique. Closed when it goes. Contract: nothing
/// is added while a value inside is open.
class [[nodiscard]] Object {
 public:
  explicit Object(Place place) : place_(place) {
    if (place_.text_ == nullptr) {
      *place_.tree_ = Value::object();
      return;
    }
    level_ = ++place_.text_->open_;
    place_.text_->append('{');
  }
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;
  ~Object() {
    if (place_.text_ != nullptr) place_.text_->close('}');
  }

  Place at(std::string_view name) {
    if (place_.text_ == nullptr) return Place(place_.tree_->add(name, Value()));
    Text& text = *place_.text_;
    AXIOMETRY_CONTRACT(text.open_ == level_);
    text.append_name(name, std::exchange(any_, true));
    return place_;
  }
  template <typename T>
  void add(std::string_view name, const T& value) {
    at(name).put(value);
  }
  Object object(std::string_view name) { return Object(at(name)); }
  List list(std::string_view name);

 private:
  Place place_;
  std::size_t level_ = 0;
  bool any_ = false;
};

/// Values one after the other; otherwise as Object.
class [[nodiscard]] List {
 public:
  explicit List(Place place) : place_(place) {
    if (place_.text_ == nullptr) {
      *place_.tree_ = Value::array();
      return;
    }
    level_ = ++place_.text_->open_;
    place_.text_->append('[');
  }
  List(const List&) = delete;
  List& operator=(const List&) = delete;
  ~List() {
    if (place_.text_ != nullptr) place_.text_->close(']');
  }

  Place next() {
    if (place_.text_ == nullptr) return Place(place_.tree_->push(Value()));
    Text& text = *place_.text_;
    AXIOMETRY_CONTRACT(text.open_ == level_);
    if (std::exchange(any_, true)) text.append(',');
    return place_;
  }
  template <typename T>
  void push(const T& value) {
    next().put(value);
  }
  Object object() { return Object(next()); }

 private:
  Place place_;
  std::size_t level_ = 0;
  bool any_ = false;
};

inline List Object::list(std::string_view name) { return List(at(name)); }

/// What `write(place)` puts there.
template <typename Write>
std::string text_of(const Write& write) {
  Text text;
  write(Place(text));
  return text.take();
}
template <typename Write>
Value tree_of(const Write& write) {
  Value tree;
  write(Place(tree));
  return tree;
}

}  // namespace axiometry::json
