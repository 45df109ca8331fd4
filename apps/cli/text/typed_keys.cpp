// SPDX-License-Identifier: Apache-2.0
#include "cli/text/typed_keys.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <utility>

#include "axiometry/base/text/text.h"

namespace axiometry::cli {
namespace {

constexpr std::size_t longest_key = 1024;  // what is longer is no key

/// Whether a read would not wait, for bytes or for the end.
bool has_input() {
  pollfd wait{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  return ::poll(&wait, 1, 0) == 1;
}

}  // namespace

std::vector<capture::StopKey> TypedKeys::take() {
  std::vector<capture::StopKey> keys;
  std::array<char, longest_key> block;
  while (!closed_ && has_input()) {
    const ssize_t got = ::read(STDIN_FILENO, block.data(), block.size());
    if (got < 0) break;  // a signal
    closed_ = got == 0;
    begun_.append(block.data(), static_cast<std::size_t>(got));
    for (std::size_t end = begun_.find('\n'); end != begun_.npos; end = begun_.find('\n')) {
      take_line(begun_.substr(0, end), keys);
      begun_.erase(0, end + 1);
    }
    if (closed_ && !begun_.empty()) take_line(std::exchange(begun_, {}), keys);  // a last line without its end
    if (begun_.size() > longest_key) begun_.resize(longest_key + 1);             // as much as tells that it is no key
  }
  return keys;
}

void TypedKeys::take_line(std::string line, std::vector<capture::StopKey>& keys) {
  const std::string word(text::trim(line));
  if (line.size() > longest_key)
    unknown_.push_back(word);
  else if (word.empty() || word == "take")
    keys.push_back(capture::StopKey::take);
  else if (word == "s" || word == "skip")
    keys.push_back(capture::StopKey::skip);
  else if (word == "u" || word == "undo")
    keys.push_back(capture::StopKey::undo);
  else if (word == "e" || word == "end")
    ended_ = true;
  else
    unknown_.push_back(word);
}

std::vector<std::string> TypedKeys::take_unknown() { return std::exchange(unknown_, {}); }

}  // namespace axiometry::cli
