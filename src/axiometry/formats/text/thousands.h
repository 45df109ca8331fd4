// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Whether a mark in the numbers of a table parts thousands: "1.000" below "500" is no 1. One mark serves a whole file.
namespace axiometry::formats {

class ThousandsDoubt {
 public:
  explicit ThousandsDoubt(std::size_t columns) : columns_(columns) {}

  /// A number as it is written.
  void look_at(std::size_t column, std::string_view number);

  /// Some number has the mark before another count of digits than three, or behind a 0: it is a decimal mark.
  bool settled() const { return settled_; }

  struct Found {
    std::string marked;  ///< "1.000"
    std::string whole;   ///< "500", of the same column
  };
  /// A column whose marks all stand before three digits, beside whole numbers without one; nothing where it is settled.
  /// A single one that does not end with 0 is no sign of it.
  std::optional<Found> found() const;

 private:
  struct Column {
    std::string marked, whole;  // the first of each kind
    std::size_t marks = 0;
    bool has_long_whole = false;  // "1250": thousands are not parted in this column
    bool ends_with_zero = false;  // which nobody writes who leaves decimals away elsewhere
  };

  std::vector<Column> columns_;
  bool settled_ = false;
};

/// What a reader says that cannot ask.
std::string thousands_fault(const ThousandsDoubt::Found& found);

}  // namespace axiometry::formats
