// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Where the items of a test's metadata come from, as far as that decides which of two statements counts.
namespace axiometry {

/// Who states an item of the metadata, in rising precedence.
enum class StatedBy {
  instrument,  ///< what the archive knows of an instrument; only what nobody else states
  file,        ///< the test's own file
  entered,     ///< a person who keeps the test, over what its file says
  flag,        ///< the command line
};

/// An item that the file does not state, or not alone.
struct StatedItem {
  std::string key;  ///< key of the vocabulary: "uncertainty.device_error_range_um_per_m"
  StatedBy by = StatedBy::flag;
  std::string name{};       ///< name of the instrument
  std::size_t records = 0;  ///< how many of a list's last records are stated so; the others are the file's
};

/// What is not named here is stated by the file.
struct StatedItems {
  std::vector<StatedItem> items;  ///< items, each key once

  const StatedItem* find(std::string_view key) const {
    const auto found = std::ranges::find(items, key, &StatedItem::key);
    return found == items.end() ? nullptr : &*found;
  }
  StatedBy by(std::string_view key) const {
    const StatedItem* item = find(key);
    return item == nullptr ? StatedBy::file : item->by;
  }
};

}  // namespace axiometry
