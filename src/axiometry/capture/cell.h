// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/model/recording.h"

/// The first pass over a recording: some milliseconds of samples become one cell, and only cells that are not plain are
/// looked at sample by sample. mm or °, and s; derivations: docs/theory/capture.md.
namespace axiometry::capture {

/// Sums over samples in one pass of a few instructions each.
struct CellSums {
  double mean = 0.0;
  double standard_deviation = 0.0;  ///< divisor n − 1
  double lowest = 0.0;
  double highest = 0.0;
  double mean_time_s = 0.0;
  double longest_step_s = 0.0;  ///< longest time between two samples that follow each other, s
};

/// Needs at least one sample, all finite and in order of time (contract).
CellSums sums_of(std::span<const Sample> samples);

/// What is left of the samples of a cell: the core, without the outliers.
struct SampleCell {
  double begin_s = 0.0;  ///< time of the first sample, s
  double end_s = 0.0;    ///< time of the last sample, s
  double mean_time_s = 0.0;
  std::size_t count = 0;  ///< samples of the core
  std::size_t rejected = 0;
  double mean = 0.0;
  double standard_deviation = 0.0;
  double scale = 0.0;  ///< standard deviation of normal noise, after the MAD where the cell was searched
  double lowest = 0.0;
  double highest = 0.0;
};

/// Rejects samples farther from the median than 8 times the largest of: 1.4826 MAD of the cell (the standard deviation
/// of normal noise), `floor` and, in cells of less than 16 samples, whose MAD says little, `noise`: the scale of the
/// cells before. No more than one in ten (but one in any case), else none. Cells of 40 samples and more whose extremes
/// lie within 5 standard deviations are not searched: there is nothing to find.
class CellMaker {
 public:
  SampleCell make(std::span<const Sample> samples, const CellSums& sums, double noise, double floor);

 private:
  std::vector<double> positions_;
  std::vector<double> distances_;
};

/// What a window at rest may move by at least and at most.
struct RestLimits {
  double smallest = 0.0, greatest = 0.0;
};

/// T = min(greatest, max(smallest, 1.5 q, 6 s)): within it the means of four cells at rest lie; q the smallest step
/// between samples (the resolution, where noise is smaller), s the median of the standard deviations of the cells.
double rest_threshold(double quantum, std::vector<double> standard_deviations, const RestLimits& limits);

}  // namespace axiometry::capture
