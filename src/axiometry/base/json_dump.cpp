// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "axiometry/base/contract.h"
#include "axiometry/base/json.h"
#include "axiometry/base/utf8.h"

namespace axiometry::json {
namespace {

/// ASCII that needs no escape.
bool stands_for_itself(char c) { return c >= 0x20 && c < 0x7F && c != '"' && c != '\\'; }

/// One character that does not stand for itself; the bytes that it took.
std::size_t write_character(std::string& out, std::string_view s) {
  const auto first = static_cast<unsigned char>(s.front());
  if (first >= 0x80) {
    const Character character = character_at(s, 0);
    out += character.valid() ? s.substr(0, character.length) : "\uFFFD";
    return character.length;
  }
  constexpr std::string_view known = "\"\\\n\r\t", letters = "\"\\nrt";
  if (const std::size_t k = known.find(s.front()); k != known.npos)
    out.append({'\\', letters[k]});
  else
    fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<unsigned>(first));
  return 1;
}

/// How many bytes at the beginning stand for themselves. Eight at a time as long as all of them do: a byte's highest
/// bit is set by x − 0x20 below 0x20, by x itself from 0x80 on, and by (x − 1) & ~x where x is 0. What one byte borrows
/// from the next can only end the run of eights too early.
std::size_t plain_length(std::string_view s) {
  constexpr std::uint64_t each = 0x0101'0101'0101'0101u, highest = 0x80 * each;
  const auto has = [](std::uint64_t word, char c) {
    const std::uint64_t x = word ^ (static_cast<unsigned char>(c) * each);
    return (x - each) & ~x;
  };
  std::size_t k = 0;
  for (std::uint64_t word = 0; k + sizeof word <= s.size(); k += sizeof word) {
    std::memcpy(&word, s.data() + k, sizeof word);
    if (((word - 0x20 * each) | word | has(word, '"') | has(word, '\\') | has(word, '\x7F')) & highest) break;
  }
  while (k < s.size() && stands_for_itself(s[k])) ++k;
  return k;
}

void write_text(std::string& out, std::string_view s) {
  out += '"';
  while (!s.empty()) {
    const std::size_t plain = plain_length(s);
    out.append(s.data(), plain);
    s.remove_prefix(plain);
    if (!s.empty()) s.remove_prefix(write_character(out, s));
  }
  out += '"';
}

/// Whole numbers as such: 1000000 and not 1e+06, which strict readers take for a fraction.
void write_number(std::string& out, double x) {
  char buffer[32];
  const bool whole = x == std::floor(x) && std::abs(x) < 1e15;
  if (whole && std::signbit(x)) out += '-';  // of a zero too
  const auto done = whole ? std::to_chars(buffer, std::end(buffer), static_cast<long long>(std::abs(x)))
                          : std::to_chars(buffer, std::end(buffer), x);
  out.append(buffer, static_cast<std::size_t>(done.ptr - buffer));
}

bool is_container(const Value& value) { return value.is(Kind::array) || value.is(Kind::object); }

class Writer {
 public:
  explicit Writer(int indent) : indent_(indent) {}

  void write(const Value& value, int level) {
    switch (value.kind()) {
      case Kind::null: out_ += "null"; break;
      case Kind::boolean: out_ += value.boolean() ? "true" : "false"; break;
      case Kind::number:
        AXIOMETRY_CONTRACT(std::isfinite(value.number()));
        write_number(out_, value.number());
        break;
      case Kind::text: write_text(out_, value.text()); break;
      case Kind::array: write_array(value.items(), level); break;
      case Kind::object: write_object(value.members(), level); break;
    }
  }

  std::string take() { return std::move(out_); }

 private:
  void new_line(int level) {
    if (indent_ > 0) out_.append(1, '\n').append(static_cast<std::size_t>(indent_ * level), ' ');
  }

  /// A list of plain values stays on one line: a run of readings is read across.
  void write_array(const std::vector<Value>& items, int level) {
    const bool broken = std::ranges::any_of(items, is_container);
    out_ += '[';
    for (std::size_t k = 0; k < items.size(); ++k) {
      if (k > 0) out_ += broken || indent_ == 0 ? "," : ", ";
      if (broken) new_line(level + 1);
      write(items[k], level + 1);
    }
    if (broken) new_line(level);
    out_ += ']';
  }

  void write_object(const std::vector<std::pair<std::string, Value>>& members, int level) {
    out_ += '{';
    for (std::size_t k = 0; k < members.size(); ++k) {
      if (k > 0) out_ += ',';
      new_line(level + 1);
      write_text(out_, members[k].first);
      out_ += indent_ > 0 ? ": " : ":";
      write(members[k].second, level + 1);
    }
    if (!members.empty()) new_line(level);
    out_ += '}';
  }

  int indent_;
  std::string out_;
};

}  // namespace

std::string dump(const Value& value, int indent) {
  Writer writer(indent);
  writer.write(value, 0);
  return writer.take();
}

}  // namespace axiometry::json
