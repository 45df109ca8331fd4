// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/json/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::json {

std::string_view kind_name(Kind kind) {
  constexpr std::string_view names[] = {"null", "boolean", "number", "string", "array", "object"};
  return names[static_cast<std::size_t>(kind)];
}

Value Value::array(std::vector<Value> items) { return Value(std::move(items)); }
Value Value::object() { return Value(Members{}); }

namespace {

template <typename T, typename Content>
auto& content_as(Content& content) {
  auto* held = std::get_if<T>(&content);
  AXIOMETRY_CONTRACT(held != nullptr);
  return *held;
}

}  // namespace

bool Value::boolean() const { return content_as<bool>(content_); }
double Value::number() const { return content_as<double>(content_); }
const std::string& Value::text() const { return content_as<std::string>(content_); }
const std::vector<Value>& Value::items() const { return content_as<Items>(content_); }
const std::vector<std::pair<std::string, Value>>& Value::members() const { return content_as<Members>(content_); }

const Value* Value::find(std::string_view name) const {
  for (const auto& [key, value] : members())
    if (key == name) return &value;
  return nullptr;
}

Value& Value::push(Value item) { return content_as<Items>(content_).emplace_back(std::move(item)); }

Value& Value::add(std::string_view name, Value value) {
  constexpr std::size_t usual = 8;  // members: fewer moves of those that are there, and little memory of a result
  Members& members = content_as<Members>(content_);
  if (members.size() == members.capacity()) members.reserve(std::max(usual, 2 * members.size()));
  return members.emplace_back(name, std::move(value)).second;
}

namespace {

/// Where tokens begin. The parser reports tokens in the order of the text but not their places; this
/// walks along. Line breaks stand only between tokens (a raw one inside a string is no JSON).
class TokenCursor {
 public:
  explicit TokenCursor(std::string_view text) : text_(text) {}

  /// Place of the next token; the cursor then stands behind it.
  TextPosition next() {
    while (offset_ < text_.size() && is_between(text_[offset_])) step();
    at_ = {line_, offset_ - line_start_ + 1};
    token_begin_ = offset_;
    skip_token();
    return at_;
  }

  /// Place of the token at this offset: the last one if it reaches so far (0 before the 1 in 01), else the next.
  TextPosition at(std::size_t offset) { return offset < offset_ ? at_ : next(); }

  std::string_view token() const { return text_.substr(token_begin_, offset_ - token_begin_); }

 private:
  static bool is_between(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ',' || c == ':'; }

  void step() {
    if (text_[offset_++] != '\n') return;
    ++line_;
    line_start_ = offset_;
  }

  void skip_token() {
    if (offset_ == text_.size()) return;
    const char first = text_[offset_++];
    if (first == '"') {
      while (offset_ < text_.size() && text_[offset_] != '"') offset_ += text_[offset_] == '\\' ? 2 : 1;
      offset_ = std::min(offset_ + 1, text_.size());
    } else if (first != '{' && first != '}' && first != '[' && first != ']') {
      constexpr std::string_view ends = " \t\r\n,:{}[]\"";
      offset_ = std::min(text_.find_first_of(ends, offset_), text_.size());
    }
  }

  std::string_view text_;
  std::size_t offset_ = 0;
  std::size_t token_begin_ = 0;
  std::size_t line_ = 1;
  std::size_t line_start_ = 0;
  TextPosition at_;
};

TextPosition position_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t last_break = before.rfind('\n');
  const auto breaks = static_cast<std::size_t>(std::ranges::count(before, '\n'));
  return {breaks + 1, offset - (last_break == std::string_view::npos ? 0 : last_break + 1) + 1};
}

/// What the parser's message says it expected, in words of our own where its words are for programmers.
std::string expected_instead(std::string_view what) {
  constexpr std::string_view value = "a JSON value";
  if (what.contains("number overflow")) return "a number up to 1.8e308";
  if (what.contains("; expected end of input")) return "the end of the text";
  if (what.contains("; expected string literal")) return "a member name in quotes";
  if (what.contains("invalid literal")) return std::string(value);
  if (what.contains("ill-formed UTF-8")) return "UTF-8";
  if (what.contains("missing closing quote")) return "a closing quote";
  if (what.contains("control character")) return "no line break or control character inside a string";
  if (what.contains("invalid string")) return "a string with the escapes of JSON";
  constexpr std::string_view mark = "; expected ";
  const std::size_t found = what.rfind(mark);
  if (found == std::string_view::npos) return "valid JSON";
  const std::string_view expected = what.substr(found + mark.size());
  if (expected.starts_with("'[', '{', or a literal")) return std::string(value);
  return std::string(expected.substr(0, expected.find("; last read")));
}

}  // namespace

/// Receives the parser's events and builds the tree.
class TreeBuilder {
 public:
  using number_integer_t = nlohmann::json::number_integer_t;
  using number_unsigned_t = nlohmann::json::number_unsigned_t;
  using number_float_t = nlohmann::json::number_float_t;
  using string_t = nlohmann::json::string_t;
  using binary_t = nlohmann::json::binary_t;

  TreeBuilder(std::string_view text, ParseLimits limits) : text_(text), limits_(limits), cursor_(text) {}

  bool null() { return put(Value(), cursor_.next()); }
  bool boolean(bool b) { return put(Value(b), cursor_.next()); }
  bool number_integer(number_integer_t x) { return number(static_cast<double>(x)); }
  bool number_unsigned(number_unsigned_t x) { return number(static_cast<double>(x)); }
  bool number_float(number_float_t x, const string_t&) { return number(x); }
  bool string(string_t& s) { return put(Value(std::move(s)), cursor_.next()); }
  bool binary(binary_t&) { return false; }  // never sent for JSON text

  bool start_object(std::size_t) { return open(Value::object()); }
  bool start_array(std::size_t) { return open(Value::array()); }
  bool end_array() { return close(); }

  bool key(string_t& name) {
    Open& object = open_.back();
    object.name_places.push_back(cursor_.next());
    object.names.push_back(std::move(name));
    return true;
  }

  bool end_object() {
    const Open& object = open_.back();
    if (const auto second = first_repetition(object.names))
      return refuse(
          fmt::format("found a second member {}, expected each name once", text::quoted(object.names[*second])),
          object.name_places[*second]);
    return close();
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& exception) {
    const std::size_t offset = std::min(position == 0 ? 0 : position - 1, text_.size());
    if (offset < text_.size() && (text_[offset] == ',' || text_[offset] == ':'))
      return refuse(fmt::format("found '{}', expected {}", text_[offset], expected_instead(exception.what())),
                    position_of(text_, offset));
    const TextPosition at = cursor_.at(offset);
    const std::string_view token = cursor_.token();
    return refuse(fmt::format("found {}, expected {}", token.empty() ? "the end of the text" : text::quoted(token),
                              expected_instead(exception.what())),
                  at);
  }

  const std::optional<std::unexpected<Error>>& error() const { return error_; }
  Value take() { return std::move(root_); }

 private:
  struct Open {
    Value value;
    std::vector<std::string> names;  // of the members, until the object is closed
    std::vector<TextPosition> name_places;
  };

  static std::optional<std::size_t> first_repetition(const std::vector<std::string>& names) {
    if (names.size() <= 16) {  // looking at every pair is the fastest
      for (auto at = names.begin(); at != names.end(); ++at)
        if (std::find(names.begin(), at, *at) != at) return static_cast<std::size_t>(at - names.begin());
      return std::nullopt;
    }
    std::vector<std::size_t> order(names.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t k) -> const std::string& { return names[k]; });
    std::optional<std::size_t> first;
    for (std::size_t k = 1; k < order.size(); ++k)
      if (names[order[k]] == names[order[k - 1]]) first = std::min(first.value_or(order[k]), order[k]);
    return first;
  }

  bool refuse(std::string message, TextPosition at) {
    error_ = fail(std::move(message), at);
    return false;
  }

  /// The nearest double; nlohmann reads numbers by the C library, whose text is the same.
  bool number(double fallback) {
    const TextPosition at = cursor_.next();
    return put(Value(parse_number(cursor_.token()).value_or(fallback)), at);
  }

  bool put(Value value, TextPosition at) {
    value.at_ = at;
    if (++count_ > limits_.values)
      return refuse(fmt::format("found more than {} values, expected fewer", limits_.values), at);
    attach(std::move(value));
    return true;
  }

  void attach(Value value) {
    if (open_.empty()) {
      root_ = std::move(value);
    } else if (Open& parent = open_.back(); parent.value.is(Kind::array)) {
      parent.value.push(std::move(value));
    } else {
      std::get<Value::Members>(parent.value.content_).emplace_back(std::string(), std::move(value));  // no more memory
    }
  }

  bool open(Value container) {
    container.at_ = cursor_.next();
    const TextPosition at = container.at_;
    if (open_.size() >= limits_.depth)
      return refuse(fmt::format("found nesting deeper than {} levels, expected less", limits_.depth), at);
    if (++count_ > limits_.values)
      return refuse(fmt::format("found more than {} values, expected fewer", limits_.values), at);
    open_.push_back({std::move(container), {}, {}});
    return true;
  }

  bool close() {
    cursor_.next();
    Open done = std::move(open_.back());
    open_.pop_back();
    if (done.value.is(Kind::object)) {
      auto& members = std::get<Value::Members>(done.value.content_);
      for (std::size_t k = 0; k < members.size(); ++k) members[k].first = std::move(done.names[k]);
    }
    attach(std::move(done.value));
    return true;
  }

  std::string_view text_;
  ParseLimits limits_;
  TokenCursor cursor_;
  std::vector<Open> open_;
  Value root_;
  std::size_t count_ = 0;
  std::optional<std::unexpected<Error>> error_;
};

Result<Value> parse(std::string_view text, ParseLimits limits) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    return fail("found UTF-16 text, expected UTF-8", {1, 1});
  if (text.size() > limits.bytes)
    return fail(fmt::format("found {} bytes, expected at most {}", text.size(), limits.bytes));
  // nlohmann takes it for the end of the text, whatever stands behind it.
  if (const std::size_t zero = text.find('\0'); zero != text.npos)
    return fail(fmt::format("found a byte 0 behind {} bytes, expected JSON, which has none", zero));
  TreeBuilder builder(text, limits);
  const bool complete = nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  if (builder.error()) return *builder.error();
  AXIOMETRY_CONTRACT(complete);
  return builder.take();
}

}  // namespace axiometry::json
