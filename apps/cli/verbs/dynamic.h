// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace axiometry::cli {

class Verb;

void add_dynamic(const Verb& program, int& exit_code);

}  // namespace axiometry::cli
