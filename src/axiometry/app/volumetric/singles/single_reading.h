// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/volumetric/singles/assemble_singles.h"
#include "axiometry/volumetric/singles/measured_square.h"

/// Reading what a model of single measurements is made from.
namespace axiometry::app {

/// One error motion with the standard uncertainty of its means.
struct ReadSingle {
  volumetric::SingleMotion motion;  ///< motion in axes of the machine, positions ascending
  AssembledItem item;
  std::vector<std::string> remarks;
  bool is_sense_stated = true;  ///< whether anybody said which way its readings are positive
};

/// Positioning from a test in any format; the others from readings as CSV, or from what `axiometry straightness`,
/// `angles` or `squareness` wrote as JSON, where the item's error is looked for among several. Fails as
/// assemble_singles() says.
Result<ReadSingle> read_single(const SingleItem& item, volumetric::ErrorMotion error);

/// All of them, with `reversal` as in SingleErrors, squareness after the motions that it is counted over. Fails on an
/// error named twice.
struct ReadSingles {
  volumetric::SingleErrors errors;  ///< errors without places
  std::vector<AssembledItem> items;
  std::vector<std::string> remarks;
};
Result<ReadSingles> read_singles(const std::vector<SingleItem>& items, volumetric::Reversal reversal,
                                 const std::stop_token& stop);

/// C0Y, B0Z, A0Z.
std::optional<volumetric::Squareness> squareness_named(std::string_view name);

/// Of the JSON of `axiometry squareness`.
struct ReadSquare {
  volumetric::SquareMeasurement measured;
  AssembledItem item;  ///< u_largest is found later
  std::vector<std::string> remarks;
};

/// Fails on JSON of another result, without a location error (nothing states which way its readings are positive), with
/// another one than the item's, and without any uncertainty. Where few runs make its coverage factor k larger than 2,
/// the parts of its uncertainty are k/2 times as large: U = 2 u stays what was stated.
Result<ReadSquare> read_square(const SingleItem& item, volumetric::Squareness which);

}  // namespace axiometry::app
