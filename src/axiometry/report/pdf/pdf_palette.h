// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/report/document.h"

/// The colours of the printed report; those of html_style.h.
namespace axiometry::report::pdf {

inline constexpr Colour ink{0.086, 0.098, 0.114};
inline constexpr Colour quiet{0.365, 0.400, 0.439};
inline constexpr Colour accent{0.114, 0.235, 0.369};
inline constexpr Colour rule{0.784, 0.804, 0.827};
inline constexpr Colour hairline{0.890, 0.902, 0.918};

struct ToneColours {
  Colour text;
  Colour ground;
};

constexpr ToneColours tone_colours(Tone tone) {
  switch (tone) {
    case Tone::normal: return {ink, {0.965, 0.969, 0.973}};
    case Tone::quiet: return {quiet, {0.965, 0.969, 0.973}};
    case Tone::good: return {{0.110, 0.384, 0.220}, {0.945, 0.969, 0.953}};
    case Tone::caution: return {{0.490, 0.322, 0.000}, {0.992, 0.973, 0.925}};
    case Tone::bad: return {{0.604, 0.106, 0.106}, {0.988, 0.953, 0.949}};
  }
  return {ink, {1, 1, 1}};
}

}  // namespace axiometry::report::pdf
