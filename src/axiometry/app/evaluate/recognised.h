// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/formats/format.h"
#include "axiometry/formats/recording.h"

/// Private to app/: what a file seems to be.
namespace axiometry::app {

/// What the beginning of a file tells. What is to be done with a recording is said by who was given it.
struct Recognised {
  Result<const formats::Format*> format;          ///< format of a measured test, or why it is none
  const formats::Recording* recording = nullptr;  ///< a continuous one; only where no format but any table fits
};

/// `bytes`: all of a file, or its first ones.
Recognised recognised(std::string_view bytes);

}  // namespace axiometry::app
