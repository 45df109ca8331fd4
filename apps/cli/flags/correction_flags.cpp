// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/correction_flags.h"

#include <cstdint>
#include <string>
#include <vector>

#include "axiometry/app/evaluate/correction_text.h"
#include "cli/failure.h"

namespace axiometry::cli {

void add_correction_flags(const Verb& verb, CorrectionRequest& request) {
  constexpr const char* group = "Corrections of the readings, none unasked";
  verb.add_option_function<std::vector<std::string>>(
          "--correct",
          [&request](const std::vector<std::string>& lists) {
            for (const std::string& list : lists)
              if (auto chosen = app::choose_corrections(list, request); !chosen)
                throw UsageError("--correct", chosen.error().message);
          },
          "Correct the readings, by a list of: sign (the instrument's is reversed), gain (instrument.gain), air=ciddor "
          "or air=edlen (refractive index of air), dead-path (instrument.dead_path_mm), nde (expansion), drift (a "
          "straight line in time); made in this order, may be repeated")
      ->type_name("LIST")
      ->one_at_a_time()
      ->group(group);
  verb.add_flag_function(
          "--nde-correct", [&request](std::int64_t) { request.expansion = true; },
          "As --correct nde: correct the readings for nominal differential expansion, from the temperatures of the "
          "sensors and the expansion coefficients; refused where the instrument has done it")
      ->group(group);
}

}  // namespace axiometry::cli
