// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace axiometry::server {

/// What a request asks of the machine.
enum class Load {
  light,  ///< milliseconds of one processor
  heavy,  ///< perhaps seconds of one processor: a report, an evaluation
  lone,   ///< perhaps minutes of all processors, so that two at once would gain nothing: the Monte Carlo method
};

}  // namespace axiometry::server
