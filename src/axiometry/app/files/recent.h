// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <utility>

namespace axiometry::app {

/// The values that were asked for last, of a bounded weight in all. May be used from many threads at once; a value
/// that is in use lives on when it is forgotten here.
template <typename Key, typename Value>
class Recent {
 public:
  explicit Recent(std::size_t weight_max) : weight_max_(weight_max) {}

  /// nullptr when it is not, or no longer, known.
  std::shared_ptr<const Value> find(const Key& key) {
    const std::scoped_lock lock(mutex_);
    const auto found = std::ranges::find(entries_, key, &Entry::key);
    if (found == entries_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, found);
    return entries_.front().value;
  }

  /// Forgets the oldest until there is room; a value that is heavier than all that may be kept is not kept.
  void remember(const Key& key, std::shared_ptr<const Value> value, std::size_t weight) {
    const std::scoped_lock lock(mutex_);
    const auto found = std::ranges::find(entries_, key, &Entry::key);
    if (found != entries_.end()) {
      weight_ -= found->weight;
      entries_.erase(found);
    }
    if (weight > weight_max_) return;
    entries_.push_front({key, std::move(value), weight});
    weight_ += weight;
    while (weight_ > weight_max_) {
      weight_ -= entries_.back().weight;
      entries_.pop_back();
    }
  }

 private:
  struct Entry {
    Key key;
    std::shared_ptr<const Value> value;
    std::size_t weight = 0;
  };
  std::mutex mutex_;
  std::list<Entry> entries_;  // some hundreds at most: looked through one by one
  std::size_t weight_ = 0;
  std::size_t weight_max_;
};

}  // namespace axiometry::app
