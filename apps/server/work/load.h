// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace axiometry::server {

/// What a request asks of the machine. Each but the lone ones, which stand with the heavy ones, has a line of its own.
enum class Load {
  light,  ///< milliseconds of one processor
  edit,   ///< keeps what a person has entered, after one evaluation: waits for other edits, never for a report
  heavy,  ///< perhaps seconds of one processor: a report, an evaluation
  lone,   ///< perhaps minutes of all processors, so that two at once would gain nothing: the Monte Carlo method
};

}  // namespace axiometry::server
