// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace axiometry::numeric {

/// A table with a column for every trial, the form in which kernels work on many trials at once: value t of row r
/// is values[r·stride + t].
template <typename Number>
struct Rows {
  std::span<Number> values;
  std::size_t stride = 0;  ///< distance between rows in numbers, at least the number of trials

  std::span<Number> row(std::size_t r, std::size_t trials) const { return values.subspan(r * stride, trials); }
  /// Whether the first `trials` values of this many rows are there.
  bool hold(std::size_t rows, std::size_t trials) const {
    return rows == 0 || trials == 0 || (trials <= stride && (rows - 1) * stride + trials <= values.size());
  }
  operator Rows<const Number>() const { return {values, stride}; }
};

/// Memory for numbers that are all set before they are read: nothing fills it with zeros first.
template <typename Number>
class UnsetNumbers {
 public:
  UnsetNumbers() = default;
  explicit UnsetNumbers(std::size_t size) : size_(size), memory_(std::make_unique_for_overwrite<Number[]>(size)) {}

  std::span<Number> all() const { return {memory_.get(), size_}; }

 private:
  std::size_t size_ = 0;
  std::unique_ptr<Number[]> memory_;
};

/// Memory for a table that begins where a register's worth of bytes does: kernels take any, but are faster by a
/// fifth when no load crosses a cache line, which holds for strides of a multiple of 64 bytes.
template <typename Number>
class RowBuffer {
 public:
  RowBuffer(std::size_t rows, std::size_t stride)
      : size_(rows * stride), stride_(stride), memory_(size_ + line / sizeof(Number)) {}

  Rows<Number> rows() {
    const auto address = reinterpret_cast<std::uintptr_t>(memory_.data());
    const std::size_t skipped = (line - address % line) % line / sizeof(Number);
    return {std::span(memory_).subspan(skipped, size_), stride_};
  }

 private:
  static constexpr std::size_t line = 64;
  std::size_t size_ = 0;
  std::size_t stride_ = 0;
  std::vector<Number> memory_;
};

}  // namespace axiometry::numeric
