// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/withdrawn.h"

#include <string>
#include <utility>

namespace axiometry::app {
namespace {

void add_label(std::string& label, std::string_view separator) {
  if (!label.empty()) label += separator;
  label += withdrawn_label;
}

}  // namespace

std::string labelled_withdrawn(std::string label) {
  add_label(label, "; ");
  return label;
}

iso230_2::Assessment labelled_withdrawn(iso230_2::Assessment assessment) {
  assessment.label = labelled_withdrawn(std::move(assessment.label));
  return assessment;
}

report::Document labelled_withdrawn(report::Document document) {
  document.label = labelled_withdrawn(std::move(document.label));
  add_label(document.running_status, " · ");
  document.status.insert(document.status.begin(),
                         {report::Tone::bad, report::plain("Label: " + std::string(withdrawn_label)), {}});
  return document;
}

}  // namespace axiometry::app
