// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "axiometry/app/live/disk/table_order.h"
#include "axiometry/base/json/json.h"
#include "axiometry/model/plan.h"
#include "axiometry/store/records.h"

namespace axiometry::app {

/// What is captured and how, enough to go on after a crash.
struct CaptureOrder {
  store::Id plan = 0;
  std::size_t part = 1;                  ///< number of the part in the plan, from 1
  Plan walked;                           ///< plan of that part; none of lengths
  std::optional<LengthOrder> lengths{};  ///< what lengths are captured, in place of both plans
  std::optional<MotionOrder> motion{};   ///< for readings, where no positions are read at stops of `walked`
  std::string source;                    ///< id of the source
  std::string layout;                    ///< empty: recognised
  std::vector<std::pair<std::string, std::string>> options;  ///< options by name, as they were given
  std::string actor;
  std::string started;  ///< RFC 3339, UTC
};

/// Of lengths or a motion, which are evaluated on pages of their own: its files stay, and a note of what it came to.
inline bool becomes_table(const CaptureOrder& order) { return order.lengths || order.motion; }

json::Value to_json(const CaptureOrder& order);
/// Nothing where it is not what was written.
std::optional<CaptureOrder> capture_order_from(const json::Value& value);

/// Of one order, which says when it was begun: the same bytes wherever it is kept.
std::string identity_of(const CaptureOrder& order);

/// A capture that became a table.
struct EndedCapture {
  CaptureOrder order;
  TableEnd end;
};

/// As the archive keeps it, so that a copy of the archive lists it too: {"order", "end"}.
std::string text_of(const EndedCapture& capture);
/// The same with "discarded": true. Bytes of their own, since an archive keeps bytes once.
std::string discard_text_of(const EndedCapture& capture);
/// Of both.
std::optional<EndedCapture> ended_capture_from(std::string_view bytes);

}  // namespace axiometry::app
