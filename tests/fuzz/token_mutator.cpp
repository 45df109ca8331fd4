// SPDX-License-Identifier: Apache-2.0
//
// Mutations that know what text is made of: words, numbers, signs, lines and what stands between brackets. Bytes alone
// hardly ever turn one valid table or document into another. Half of all mutations stay those of libFuzzer.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t largest);

namespace {

constexpr std::string_view numbers[] = {"0",
                                        "-0",
                                        "1",
                                        "-1",
                                        "2",
                                        "0.1",
                                        "1e-9",
                                        "1e9",
                                        "1e308",
                                        "-1e9",
                                        "65536",
                                        "10000",
                                        "1e-320",
                                        "2147483648",
                                        "9007199254740993",
                                        "NaN",
                                        "null",
                                        "00",
                                        "99999999999999999999"};

struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t size() const { return end - begin; }
};

bool in_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}
bool in_number(char c) { return (c >= '0' && c <= '9') || c == '.'; }

class Mutation {
 public:
  Mutation(std::string_view text, unsigned seed) : text_(text), chance_(seed) {
    for (std::size_t k = 0; k < text.size();) {
      std::size_t end = k + 1;
      if (in_word(text[k]))
        while (end < text.size() && in_word(text[end])) ++end;
      else if (in_number(text[k]))
        while (end < text.size() && in_number(text[end])) ++end;
      tokens_.push_back({k, end});
      k = end;
    }
  }

  std::string once() {
    if (tokens_.empty()) return std::string(numbers[below(std::size(numbers))]);
    switch (below(7)) {
      case 0: return put(any_run(), text_of(any_run()));                     // one piece in place of another
      case 1: return inserted(any_place(), text_of(any_run()));              // a piece again, elsewhere
      case 2: return put(any_run(), "");                                     // a piece less
      case 3: return inserted(any_line().end, text_of(any_line()));          // a line again
      case 4: return put(any_number(), numbers[below(std::size(numbers))]);  // an extreme number
      case 5: return put(any_group(), text_of(any_group()));                 // one group of brackets for another
      default: return twice(any_group());                                    // a group again, behind a comma
    }
  }

 private:
  std::size_t below(std::size_t count) { return chance_() % count; }
  std::string_view text_of(Span span) const { return text_.substr(span.begin, span.size()); }
  std::size_t any_place() { return tokens_[below(tokens_.size())].begin; }

  Span any_run() {
    const std::size_t first = below(tokens_.size());
    const std::size_t last = std::min(tokens_.size() - 1, first + below(1 + below(12)));
    return {tokens_[first].begin, tokens_[last].end};
  }

  Span any_line() {
    const std::size_t at = any_place();
    const std::size_t before = at == 0 ? std::string_view::npos : text_.rfind('\n', at - 1);
    const std::size_t end = text_.find('\n', at);
    return {before == std::string_view::npos ? 0 : before + 1, end == std::string_view::npos ? text_.size() : end + 1};
  }

  Span any_number() {
    for (int attempt = 0; attempt < 20; ++attempt)
      if (const Span token = tokens_[below(tokens_.size())]; in_number(text_[token.begin])) return token;
    return any_run();
  }

  /// From a bracket to the one that closes it.
  Span any_group() {
    for (int attempt = 0; attempt < 20; ++attempt) {
      const std::size_t begin = any_place();
      const char open = text_[begin];
      if (open != '{' && open != '[' && open != '(') continue;
      const char close = open == '(' ? ')' : static_cast<char>(open + 2);
      std::size_t depth = 0;
      for (std::size_t k = begin; k < text_.size(); ++k) {
        depth += text_[k] == open;
        depth -= text_[k] == close;
        if (depth == 0) return {begin, k + 1};
      }
    }
    return any_run();
  }

  std::string put(Span place, std::string_view piece) const {
    return std::string(text_.substr(0, place.begin)).append(piece).append(text_.substr(place.end));
  }
  std::string inserted(std::size_t at, std::string_view piece) const { return put({at, at}, piece); }
  std::string twice(Span group) const { return inserted(group.end, "," + std::string(text_of(group))); }

  std::string_view text_;
  std::minstd_rand chance_;
  std::vector<Span> tokens_;
};

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t largest,
                                               unsigned seed) {
  if (seed % 2 == 0) return LLVMFuzzerMutate(data, size, largest);
  const std::string changed =
      Mutation({reinterpret_cast<const char*>(data), size}, seed / 2 + 1).once().substr(0, largest);
  std::memcpy(data, changed.data(), changed.size());
  return changed.size();
}
