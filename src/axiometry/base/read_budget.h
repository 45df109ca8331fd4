// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

/// What a file may cost who reads it, for every reader in one place. Within these bounds a file that is refused, or
/// read, takes at most memory_bytes and memory_per_byte times its bytes of memory, in time that grows as the file does;
/// tests/growth.py tries it with every reader. What lies beyond a bound is refused with the place, never cut.
namespace axiometry::read_budget {

inline constexpr std::size_t memory_bytes = std::size_t{64} << 20, memory_per_byte = 50;

/// Of a file that is read as a whole: a table of another layout, a document of JSON, a profile, a plan. Files of tests
/// in CSV are read piece by piece and may be larger.
inline constexpr std::size_t file_bytes = std::size_t{64} << 20;

/// Of the beginning by which a format is recognised.
inline constexpr std::size_t head_bytes = std::size_t{64} << 10;

/// Cells of one row. A wide table of 10 000 runs, both directions, has 20 001.
inline constexpr std::size_t row_cells = 32'768;

/// Columns of a table whose layout is guessed: every one is tried as everything.
inline constexpr std::size_t guessed_columns = 4096;

/// Bytes of a name that is taken apart for what it means: the head of a column, a word with a typing error.
inline constexpr std::size_t name_bytes = 200;

/// Of arrays and objects in one another.
inline constexpr std::size_t nesting = 64;

/// Values of one document of JSON; each takes about 60 bytes.
inline constexpr std::size_t json_values = 4'000'000;

/// Records of one list of the metadata: instruments, sensors. Each line that states one is put behind all before it.
inline constexpr std::size_t records = 256;

/// Points by which a station is located: each takes up to a tenth of a millisecond, of several solutions.
inline constexpr std::size_t location_points = 10'000;

/// The largest run number of any format.
inline constexpr std::size_t runs = 10'000;

/// Cells of a grid of targets, directions and runs for each reading that stands in the file: how far a run number may
/// spread it out.
inline constexpr std::size_t grid_cells_per_reading = 64;

}  // namespace axiometry::read_budget
