// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}

namespace axiometry::cli {

/// The experiments of Lee et al. as verbs below `axiometry tracking simulate`.
void add_lee_verbs(CLI::App& simulate, int& exit_code);

}  // namespace axiometry::cli
