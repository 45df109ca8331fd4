// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/ranges/range_equations.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <thread>

namespace axiometry::tracking::detail {

RangeLayout lay_out(std::size_t points, std::size_t stations, std::span<const RangeReading> readings,
                    std::span<const std::size_t> segments, bool free_scales) {
  RangeLayout layout;
  layout.points = points;
  layout.stations = stations;
  layout.free_scales = free_scales;

  std::vector<std::size_t> counts(stations, 0);
  for (std::size_t k = 0; k < readings.size(); ++k)
    counts[readings[k].station] = std::max(counts[readings[k].station], segments[k] + 1);
  std::vector<std::size_t> offset(stations + 1, 0);
  for (std::size_t j = 0; j < stations; ++j) {
    offset[j + 1] = offset[j] + counts[j];
    for (std::size_t k = 0; k < counts[j]; ++k) {
      layout.owner.push_back(static_cast<std::uint32_t>(j));
      layout.segment_of.push_back(k);
    }
  }

  layout.first.assign(points + 1, 0);
  for (const RangeReading& r : readings) ++layout.first[r.point + 1];
  for (std::size_t i = 0; i < points; ++i) layout.first[i + 1] += layout.first[i];
  std::vector<std::size_t> next(layout.first.begin(), layout.first.end() - 1);
  layout.station.resize(readings.size());
  layout.segment.resize(readings.size());
  layout.reading.resize(readings.size());
  layout.length_mm.resize(readings.size());
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const std::size_t t = next[readings[k].point]++;
    layout.station[t] = static_cast<std::uint32_t>(readings[k].station);
    layout.segment[t] = static_cast<std::uint32_t>(offset[readings[k].station] + segments[k]);
    layout.reading[t] = static_cast<std::uint32_t>(k);
    layout.length_mm[t] = readings[k].length_mm;
  }
  return layout;
}

bool ColumnPattern::fits(const RangeLayout& layout, std::size_t begin, std::size_t end) const {
  const std::size_t n = end - begin;
  if (n != segment_.size()) return false;
  for (std::size_t k = 0; k < n; ++k)  // a segment belongs to one station
    if (layout.segment[begin + k] != segment_[k]) return false;
  return true;
}

void ColumnPattern::take(const RangeLayout& layout, std::size_t begin, std::size_t end) {
  station_.assign(layout.station.begin() + static_cast<std::ptrdiff_t>(begin),
                  layout.station.begin() + static_cast<std::ptrdiff_t>(end));
  segment_.assign(layout.segment.begin() + static_cast<std::ptrdiff_t>(begin),
                  layout.segment.begin() + static_cast<std::ptrdiff_t>(end));
  columns_.clear();
  station_at_.clear();
  segment_at_.clear();
  const auto at = [&](std::size_t column, std::size_t count) {
    const auto found = std::ranges::find(columns_, column);
    if (found != columns_.end()) return static_cast<std::size_t>(found - columns_.begin());
    for (std::size_t c = 0; c < count; ++c) columns_.push_back(column + c);
    return columns_.size() - count;
  };
  for (std::size_t k = 0; k < station_.size(); ++k) {
    station_at_.push_back(at(layout.station_column(station_[k]), layout.block()));
    segment_at_.push_back(at(layout.segment_column(segment_[k]), 1));
  }
}

PointChunks point_chunks(std::size_t points, std::size_t columns, std::size_t threads) {
  constexpr std::size_t points_of_chunk = 2048;
  const std::size_t most = columns > 256 ? 4 : 64;  // each chunk sums a matrix of its own
  const std::size_t count = std::clamp<std::size_t>(points / points_of_chunk, 1, most);
  const std::size_t cores = std::max<std::size_t>(1, std::thread::hardware_concurrency());
  return {points, count, std::min(count, threads != 0 ? threads : cores)};
}

void for_chunks(const PointChunks& chunks, const ChunkWork& work) {
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    for (std::size_t k = next++; k < chunks.count; k = next++)
      work(k, chunks.points * k / chunks.count, chunks.points * (k + 1) / chunks.count);
  };
  std::vector<std::jthread> helpers;
  for (std::size_t t = 1; t < chunks.threads; ++t) helpers.emplace_back(run);
  run();
}

}  // namespace axiometry::tracking::detail
