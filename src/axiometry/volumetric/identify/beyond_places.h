// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "axiometry/volumetric/identify/identifier.h"

/// Curves finer than the places of a grid carry. Internal to identify().
///
/// Of so many functions as half of the places of an axis, the rest shows what lies between (places_for_function).
/// Errors that bend more are not followed by these, and what is left goes with the places: as breaks of the beam,
/// drifts and stations that moved, none of which there were. Where that is suspected, and four functions for five
/// places leave less, they are taken; that nothing shows what lies between is told then (volumetric-few-places).
namespace axiometry::volumetric::detail {

/// With four functions for five places of the axes whose places hold the automatic sizes down; nothing where none does,
/// or where nothing is left to be explained.
std::optional<IdentifyOptions> options_beyond_places(const Identifier& done, const VolumetricLengths& lengths,
                                                     const IdentifyOptions& options);

/// Whether finer curves leave a twentieth less of χ²/ν, with no more breaks, readings set aside and errors untold.
bool leaves_less(const Identifier& finer, const Identifier& done);

}  // namespace axiometry::volumetric::detail
