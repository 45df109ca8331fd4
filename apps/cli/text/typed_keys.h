// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "axiometry/capture/values/value_listener.h"

namespace axiometry::cli {

/// What a person types while a capture runs, line by line: nothing or "take", "s" or "skip", "u" or "undo", "e" or
/// "end". Read from the standard input as it comes, without waiting.
class TypedKeys {
 public:
  std::vector<capture::StopKey> take();
  bool ended() const { return ended_; }     ///< "end" was said
  bool closed() const { return closed_; }   ///< no more can come
  std::vector<std::string> take_unknown();  ///< lines that say nothing known

 private:
  void take_line(std::string line, std::vector<capture::StopKey>& keys);

  std::string begun_;
  std::vector<std::string> unknown_;
  bool ended_ = false, closed_ = false;
};

}  // namespace axiometry::cli
