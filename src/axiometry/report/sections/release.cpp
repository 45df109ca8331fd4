// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/sections/sections.h"

namespace axiometry::report {

TableCell to_fill_in() { return quiet_cell("__________________"); }

Section release_section(const Metadata& metadata) {
  const auto or_to_fill_in = [](const std::string& text) { return text.empty() ? to_fill_in() : verbatim_cell(text); };
  const TestConditions& test = metadata.conditions;
  return {"release",
          "Release",
          false,
          {Paragraph{plain("The results hold for the machine tested, in the condition in which it was tested.")},
           Facts{"Tested by",
                 {{plain("Name"), or_to_fill_in(test.inspector)},
                  {plain("Date of test"), or_to_fill_in(test.date)},
                  {plain("Signature"), to_fill_in()}}},
           Facts{"Released by",
                 {{plain("Name"), to_fill_in()},
                  {plain("Date of issue"), to_fill_in()},
                  {plain("Signature"), to_fill_in()}}}}};
}

}  // namespace axiometry::report
