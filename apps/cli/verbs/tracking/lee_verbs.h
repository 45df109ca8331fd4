// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace axiometry::cli {

class Verb;

/// The experiments of Lee et al. as verbs below `axiometry tracking simulate`.
void add_lee_verbs(const Verb& simulate, int& exit_code);

}  // namespace axiometry::cli
