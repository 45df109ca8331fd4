// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/report.h"

namespace axiometry::report {

/// The mean deviation at every target with its expanded uncertainty as a bar, after Fig. 3 of Lira & Cargill (2004): of
/// both directions x̄_i with U[x̄_i] (their eq. 10), of a test of one direction x̄_i↑ or x̄_i↓ (eq. 8). By the law of
/// propagation. Nothing where it was not run, where no source acts on any target, and of a single target. Of more than
/// a thousand targets those that the tables show.
std::optional<Figure> mean_deviation_figure(const Subject& subject, const Options& options);

/// The same composed of the contributors of Annex A, which itself states no U of mean deviations (k = 2; annex_a.h).
/// Where some that 8.2.1 asks for were not given, the legend says that the bars are too short.
std::optional<Figure> mean_annex_a_figure(const Subject& subject, const Options& options);

/// The same by the Monte Carlo method, the intervals of its trials as bars. Likewise nothing, and where it states none.
std::optional<Figure> mean_interval_figure(const Subject& subject, const Options& options);

}  // namespace axiometry::report
