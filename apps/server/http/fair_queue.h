// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <list>
#include <string>

namespace axiometry::server {

/// Lets in one after another, of each peer in turn, and between two of them whatever else there is to do: for steps
/// that take a millisecond of the I/O thread each, of which any number may come at once. What a step throws is logged
/// and ends that step alone.
class FairQueue {
 public:
  using Step = std::function<void()>;
  using Post = std::function<void(Step)>;  ///< calls it once, later, behind what is to be called already

  explicit FairQueue(Post post) : post_(std::move(post)) {}

  /// Calls that once, later; never where this throws.
  void enter(const std::string& peer, Step step);

 private:
  struct Line {
    std::string peer;
    std::deque<Step> steps;  // steps that wait, at least one
  };

  void turn();
  void let_in();
  Step first_in_turn();

  Post post_;
  std::list<Line> lines_;    // lines in the order of their turns
  bool is_turning_ = false;  // let_in() is to be called; so it is whenever somebody waits
};

}  // namespace axiometry::server
