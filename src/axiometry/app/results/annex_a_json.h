// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/json/json_place.h"
#include "axiometry/standards/iso230_2/uncertainty/annex_a.h"

namespace axiometry::app {

/// `uncertainty.annex_a_budget` of docs/results.md: contributors, what of them is missing, the means of every target.
void put_annex_a_budget(json::Place place, const iso230_2::AnnexA& annex);

}  // namespace axiometry::app
