// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

namespace axiometry {

/// Does something when the scope ends, however it ends: what was reserved for a while is free again after a fault too.
template <typename Action>
class [[nodiscard]] AtScopeEnd {
 public:
  explicit AtScopeEnd(Action action) : action_(std::move(action)) {}
  AtScopeEnd(const AtScopeEnd&) = delete;
  AtScopeEnd& operator=(const AtScopeEnd&) = delete;
  ~AtScopeEnd() { action_(); }

 private:
  Action action_;
};

}  // namespace axiometry
