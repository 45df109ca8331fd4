// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/documents/compose.h"

#include "axiometry/report/figures/figures.h"
#include "axiometry/report/finding_text.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/temperatures/temperatures.h"

namespace axiometry::report {

Section figure_section(const Subject& subject, const Options& options) {
  Section section{"figures", "Figures", true, {}};
  for (Figure& figure : figures(subject, options)) section.blocks.push_back(std::move(figure));
  return section;
}

Document compose(const Subject& subject, const Options& asked) {
  const Options options = fitted(asked, subject.assessment.evaluation.parameters);
  Document document = title_page(subject, options);
  auto& sections = document.sections;
  sections.push_back(parameter_section(subject, options));
  if (!subject.judgements.empty()) sections.push_back(conformity_section(subject, options));
  const bool beyond_annex_a = subject.assessment.gum || subject.assessment.monte_carlo;
  if (beyond_annex_a) {
    sections.push_back(method_section(subject, options));
    sections.push_back(contribution_section(subject, options));
  }
  sections.push_back(figure_section(subject, options));
  if (auto surroundings = surroundings_section(subject, options)) sections.push_back(*std::move(surroundings));
  const AxisKind kind = subject.test.metadata.axis.kind;
  sections.push_back(claim_section(subject, options));
  sections.push_back(finding_section(shown_findings(subject.assessment.findings, subject.assessment, kind, options)));
  sections.push_back(identification_section(subject, !subject.assessment.evaluation.positions.empty(), options));
  sections.push_back(position_section(subject, options));
  sections.push_back(uncertainty_section(subject, options));
  if (subject.assessment.gum) sections.push_back(gum_section(subject, options));
  sections.push_back(information_section(subject, options));
  sections.push_back(provenance_section(subject, options));
  sections.push_back(release_section(subject.test.metadata));
  return document;
}

}  // namespace axiometry::report
