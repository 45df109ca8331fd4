// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "axiometry/app/recordings/recording_members.h"
#include "axiometry/app/tracking/tracking_evaluate.h"
#include "axiometry/app/volumetric/identify_options.h"
#include "axiometry/base/result.h"
#include "cli/flags/verb.h"

/// How measured lengths of a tracking interferometer are evaluated: the flags of `tracking evaluate` and `volumetric
/// identify`, which `store calibrate` has too.
namespace axiometry::cli {

/// --reversed, and --no-breaks: what both have.
void add_length_switches(const Verb& verb, const std::function<void()>& reversed,
                         const std::function<void()>& no_breaks);

/// Of lines: --set, --break-threshold, the tolerances with their table and rule; `table` is FILE[:NAME].
void add_lines_flags(const Verb& verb, app::TrackingEvaluateOptions& options, std::string& table);

/// Of the 21 errors: --curves, --spans, --reversal, --smoothness, --drift, --no-outliers, --no-part-scales and --parts.
void add_identify_flags(const Verb& verb, app::IdentifyChoices& choices);

/// What was said of a continuous recording (add_length_recording_flags()), in the order of the help.
app::RecordingTexts given_recording_texts(const Verb& verb);

}  // namespace axiometry::cli
