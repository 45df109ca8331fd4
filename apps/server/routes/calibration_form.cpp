// SPDX-License-Identifier: Apache-2.0
#include "server/routes/calibration_form.h"

#include <array>

#include "server/forms/sent_form.h"

namespace axiometry::server {
namespace {

constexpr std::array calibration_parts = {KnownPart{"kind", PartContent::text}, KnownPart{"about", PartContent::json},
                                          KnownPart{"options", PartContent::json}, KnownPart{"", PartContent::files}};
constexpr KnownForm calibration_form{"one with kind and files", "kind, about, options and files", calibration_parts};

}  // namespace

Result<CalibrationForm> calibration_form_of(const Request& request) {
  AXIOMETRY_TRY(const SentForm sent, sent_form(request, calibration_form));
  CalibrationForm form{std::string(sent.text("kind")),
                       sent.value("about").value_or(json::Value::object()),
                       sent.value("options").value_or(json::Value::object()),
                       {}};
  for (const SentForm::File& file : sent.files) form.files.push_back({file.part, file.given.name, file.given.bytes});
  return form;
}

}  // namespace axiometry::server
