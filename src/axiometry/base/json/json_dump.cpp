// SPDX-License-Identifier: Apache-2.0
#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "axiometry/base/contract.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/json/json_place.h"
#include "axiometry/base/text/utf8.h"

namespace axiometry::json {
namespace {

/// ASCII that needs no escape.
bool stands_for_itself(char c) { return c >= 0x20 && c < 0x7F && c != '"' && c != '\\'; }

/// How one character is written that needs more room than it takes.
std::string escaped(char c) {
  constexpr std::string_view known = "\"\\\n\r\t", letters = "\"\\nrt";
  if (const std::size_t k = known.find(c); k != known.npos) return {'\\', letters[k]};
  return fmt::format("\\u{:04x}", static_cast<unsigned>(c));
}

/// Copies the bytes at the beginning that stand for themselves; how many. Eight at a time as long as all of them do: a
/// byte's highest bit is set by x − 0x20 below 0x20, by x itself from 0x80 on, and by (x − 1) & ~x where x is 0. What
/// one byte borrows from the next can only end the run of eights too early.
std::size_t copy_plain(std::string_view s, char* to) {
  constexpr std::uint64_t each = 0x0101'0101'0101'0101u, highest = 0x80 * each;
  const auto has = [](std::uint64_t word, char c) {
    const std::uint64_t x = word ^ (static_cast<unsigned char>(c) * each);
    return (x - each) & ~x;
  };
  std::size_t k = 0;
  for (std::uint64_t word = 0; k + sizeof word <= s.size(); k += sizeof word) {
    std::memcpy(&word, s.data() + k, sizeof word);
    if (((word - 0x20 * each) | word | has(word, '"') | has(word, '\\') | has(word, '\x7F')) & highest) break;
    std::memcpy(to + k, &word, sizeof word);
  }
  for (; k < s.size() && stands_for_itself(s[k]); ++k) to[k] = s[k];
  return k;
}

}  // namespace

void Text::grow(std::size_t bytes) {
  constexpr std::size_t first = 16384;  // a result of the usual size moves no more
  text_.resize_and_overwrite(std::max(2 * text_.size(), used_ + bytes + open_ + first),
                             [](char*, std::size_t size) { return size; });
}

void Text::append(std::string_view s) { end_at(std::ranges::copy(s, room(s.size())).out); }

void Text::append_quoted(std::string_view s) {
  char* to = room(s.size() + 2);
  *to++ = '"';
  while (true) {
    const std::size_t plain = copy_plain(s, to);
    s.remove_prefix(plain);
    to += plain;
    if (s.empty()) break;
    const bool ascii = static_cast<unsigned char>(s.front()) < 0x80;
    const Character character = ascii ? Character{} : character_at(s, 0);
    if (!ascii && character.valid()) {
      to = std::copy_n(s.data(), character.length, to);
    } else {
      end_at(to);
      append(ascii ? escaped(s.front()) : std::string("\uFFFD"));
      to = room(s.size() - character.length + 1);
    }
    s.remove_prefix(character.length);
  }
  *to++ = '"';
  end_at(to);
}

/// Nearly every name is plain, and goes in at once.
void Text::append_name(std::string_view name, bool behind_another) {
  char* to = room(name.size() + 4);
  if (behind_another) *to++ = ',';
  end_at(to);
  *to++ = '"';
  if (const std::size_t plain = copy_plain(name, to); plain < name.size()) {
    append_quoted(name);
    return append(':');
  }
  to += name.size();
  *to++ = '"';
  *to++ = ':';
  end_at(to);
}

/// Whole numbers as such: 1000000 and not 1e+06, which strict readers take for a fraction. Others by the shortest
/// digits that read back the same, without an exponent where that is no longer: from 0.001 on. There fmt writes what
/// to_chars() does, in two thirds of the time.
void Text::append_number(double x) {
  AXIOMETRY_CONTRACT(std::isfinite(x));
  constexpr std::ptrdiff_t longest = 32;
  const double size = std::abs(x);
  const bool whole = size < 1e15 && static_cast<double>(static_cast<long long>(size)) == size;
  char* at = room(longest);
  char* const end = at + longest;
  if (whole && std::signbit(x)) *at++ = '-';  // the sign of a zero is written too
  if (whole)
    end_at(std::to_chars(at, end, static_cast<long long>(size)).ptr);
  else if (size >= 1e-3 && size < 1e15)
    end_at(fmt::format_to(at, FMT_COMPILE("{}"), x));
  else
    end_at(std::to_chars(at, end, x).ptr);
}

std::string Text::take() {
  text_.resize(used_);
  return std::move(text_);
}

namespace {

bool is_container(const Value& value) { return value.is(Kind::array) || value.is(Kind::object); }

class Writer {
 public:
  Writer(Text& out, int indent) : out_(out), indent_(indent) {}

  void write(const Value& value, int level) {
    switch (value.kind()) {
      case Kind::null: out_.append("null"); break;
      case Kind::boolean: out_.append(value.boolean() ? std::string_view("true") : std::string_view("false")); break;
      case Kind::number: out_.append_number(value.number()); break;
      case Kind::text: out_.append_quoted(value.text()); break;
      case Kind::array: write_array(value.items(), level); break;
      case Kind::object: write_object(value.members(), level); break;
    }
  }

 private:
  void new_line(int level) {
    if (indent_ == 0) return;
    const auto blanks = static_cast<std::size_t>(indent_ * level);
    char* const at = out_.room(1 + blanks);
    *at = '\n';
    out_.end_at(std::fill_n(at + 1, blanks, ' '));
  }

  /// A list of plain values stays on one line: a run of readings is read across.
  void write_array(const std::vector<Value>& items, int level) {
    const bool broken = indent_ > 0 && std::ranges::any_of(items, is_container);
    out_.append('[');
    for (std::size_t k = 0; k < items.size(); ++k) {
      if (k > 0) out_.append(broken || indent_ == 0 ? "," : ", ");
      if (broken) new_line(level + 1);
      write(items[k], level + 1);
    }
    if (broken) new_line(level);
    out_.append(']');
  }

  void write_object(const std::vector<std::pair<std::string, Value>>& members, int level) {
    out_.append('{');
    for (std::size_t k = 0; k < members.size(); ++k) {
      if (k > 0) out_.append(',');
      new_line(level + 1);
      out_.append_name(members[k].first, false);
      if (indent_ > 0) out_.append(' ');
      write(members[k].second, level + 1);
    }
    if (!members.empty()) new_line(level);
    out_.append('}');
  }

  Text& out_;
  int indent_;
};

}  // namespace

std::string dump(const Value& value, int indent) {
  Text text;
  Writer(text, indent).write(value, 0);
  return text.take();
}

void Place::put(Value value) const {
  if (text_ != nullptr)
    Writer(*text_, 0).write(value, 0);
  else
    *tree_ = std::move(value);
}

}  // namespace axiometry::json
