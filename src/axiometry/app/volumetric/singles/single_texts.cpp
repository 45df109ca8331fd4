// SPDX-License-Identifier: Apache-2.0
// What the command line and requests say of measurements of single errors, by the same words.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/app/volumetric/identify_options.h"
#include "axiometry/app/volumetric/singles/assemble_singles.h"
#include "axiometry/app/volumetric/singles/single_reading.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {

Result<SingleItem> parse_single(std::string_view text) {
  const std::size_t mark = text.find('=');
  const auto unknown = [&] {
    return fail(
        fmt::format("found {}, expected NAME=FILE such as EYX=straightness.csv, or squareness in µrad such as "
                    "C0Y=-12.5,1.2",
                    text::quoted(text)));
  };
  if (mark == std::string_view::npos || mark + 1 == text.size()) return unknown();
  SingleItem item;
  item.name = std::string(text.substr(0, mark));
  const std::string_view rest = text.substr(mark + 1);
  if (squareness_named(item.name)) {
    const std::size_t comma = rest.find(',');
    if (!parse_number(rest.substr(0, comma))) {
      item.file = std::string(rest);
      return item;
    }
    if (comma == std::string_view::npos) return unknown();
    const auto value = parse_number(rest.substr(0, comma)), U = parse_number(rest.substr(comma + 1));
    if (!value || !U || !(*U > 0.0) || !(std::abs(*value) <= 1e5) || !(*U <= 1e5)) return unknown();
    item.urad = *value;
    item.U_urad = *U;
    return item;
  }
  if (!volumetric::error_motion_named(item.name)) return unknown();
  item.file = std::string(rest);
  return item;
}

Result<std::pair<std::size_t, SingleStand>> parse_stand(std::string_view text) {
  const Error unknown{
      fmt::format("found {}, expected AXIS=X,Y,Z@TOOL such as X=0,300,-200@T1, and behind the others, where it is "
                  "known, in which direction they came to rest: X=0,300:up,-200:down@T1",
                  text::quoted(text)),
      {},
      {}};
  const std::size_t mark = text.find('@');
  const std::string_view axes = text.substr(0, mark);
  if (axes.size() <= 2 || axes[0] < 'X' || axes[0] > 'Z' || axes[1] != '=') return std::unexpected(unknown);
  const auto measured = static_cast<std::size_t>(axes[0] - 'X');
  SingleStand stand;
  if (mark != std::string_view::npos) stand.tool = std::string(text.substr(mark + 1));
  const auto parts = text::split(axes.substr(2), ',');
  if (parts.size() != stand.approaches.size()) return std::unexpected(unknown);
  for (std::size_t a = 0; a < parts.size(); ++a) {
    const std::size_t colon = parts[a].find(':');
    const auto at = parse_number(text::trim(parts[a].substr(0, colon)));
    if (!at) return std::unexpected(unknown);
    stand.axes_mm[a] = *at;
    if (colon == std::string_view::npos) continue;
    const std::string_view direction = text::trim(parts[a].substr(colon + 1));
    if (a == measured || (direction != "up" && direction != "down")) return std::unexpected(unknown);
    stand.approaches[a] = direction == "up" ? 1.0 : -1.0;
  }
  return std::pair(measured, std::move(stand));
}

Result<void> put_stand(std::string_view text, AssembleRequest& request) {
  AXIOMETRY_TRY(auto parsed, parse_stand(text));
  auto& stand = request.stands[parsed.first];
  if (stand) return fail(fmt::format("found {} twice, expected each axis once", text[0]));
  stand = std::move(parsed.second);
  return {};
}

Result<void> put_instrument(std::string_view text, AssembleRequest& request) {
  const std::size_t mark = std::min(text.find('='), text.size());
  const auto item = std::ranges::find(request.items, text.substr(0, mark), &SingleItem::name);
  if (item == request.items.end() || item->file.empty() || item->name[0] != 'E' || item->instrument)
    return fail(fmt::format("found an instrument of {}, expected one of an error that is given, and once",
                            text::quoted(text.substr(0, mark))));
  const std::string_view amount = text.substr(std::min(mark + 1, text.size()));
  const std::size_t comma = std::min(amount.find(','), amount.size());
  const auto a = parse_number(amount.substr(0, comma));
  const auto b = comma == amount.size() ? std::optional(0.0) : parse_number(amount.substr(comma + 1));
  if (!a || !b || !(*a >= 0.0 && *b >= 0.0 && *a + *b > 0.0 && *a <= 1e6 && *b <= 1e6))
    return fail(
        fmt::format("found {}, expected ERROR=A or ERROR=A,B: U = A + B·L, k = 2, above 0", text::quoted(text)));
  item->instrument = error_motions::InstrumentUncertainty{*a, *b};
  return {};
}

Result<volumetric::Reversal> parse_single_reversal(std::string_view word) {
  AXIOMETRY_TRY(const volumetric::Reversal reversal, parse_reversal(word));
  if (reversal != volumetric::Reversal::constant) return reversal;
  return fail("found constant, expected curves or none: readings have a difference at every position");
}

}  // namespace axiometry::app
