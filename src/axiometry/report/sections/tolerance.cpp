// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "axiometry/report/sections/sections.h"

namespace axiometry::report {

namespace {

using iso230_2::Judgement;
using iso230_2::Verdict;

/// "A, E↑", of those with this verdict.
RichText symbols_with(std::span<const Judgement> judgements, Verdict verdict) {
  RichText symbols;
  for (const Judgement& judgement : judgements)
    if (judgement.verdict == verdict)
      symbols = joined({symbols, plain(symbols.empty() ? "" : ", "), symbol(judgement.tolerance.parameter->symbol)});
  return symbols;
}

}  // namespace

std::optional<Notice> tolerance_notice(std::span<const Judgement> judgements) {
  if (judgements.empty()) return std::nullopt;
  const RichText exceeded = symbols_with(judgements, Verdict::exceeded);
  const RichText within = symbols_with(judgements, Verdict::within);
  const RichText unjudged = symbols_with(judgements, Verdict::not_applicable);
  Notice notice;
  RichText others;
  if (!exceeded.empty()) {
    notice = {Tone::bad, joined({plain("Tolerance exceeded: "), exceeded}), {}};
    if (!within.empty()) others = joined({plain("Within tolerance: "), within, plain(".")});
  } else if (!within.empty()) {
    notice = {Tone::good, joined({plain("Within tolerance: "), within}), {}};
  } else {
    notice = {Tone::caution, plain("No verdict"), {}};
  }
  if (!unjudged.empty())
    others = joined({others, plain(others.empty() ? "No verdict on " : " No verdict on "), unjudged,
                     plain(": not applicable to this test.")});
  if (!others.empty()) notice.lines.push_back(std::move(others));
  return notice;
}

}  // namespace axiometry::report
