// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/reading_flags.h"

#include <fmt/format.h>

#include "axiometry/base/text/text.h"
#include "axiometry/model/fields.h"

namespace axiometry::cli {

void add_metadata(MetadataPairs& metadata, const std::string& key, const std::string& value) {
  Metadata trial;
  if (const auto set = set_field_text(trial, key, value); !set) throw UsageError(set.error().message);
  metadata.emplace_back(key, value);
}

void add_metadata_flag(const Verb& verb, MetadataPairs& metadata, const std::string& description) {
  verb.add_option_function<std::vector<std::string>>(
          "--set",
          [&metadata](const std::vector<std::string>& pairs) {
            for (const std::string& pair : pairs) {
              const std::size_t equals = pair.find('=');
              if (equals == std::string::npos)
                throw UsageError("--set", fmt::format("found {}, expected KEY=VALUE", text::quoted(pair)));
              add_metadata(metadata, pair.substr(0, equals), pair.substr(equals + 1));
            }
          },
          description + "; may be repeated")
      ->type_name("KEY=VALUE")
      ->one_at_a_time()
      ->group("Input");
}

void add_reading_flags(const Verb& verb, app::EvaluateOptions& reading, const std::string& example) {
  verb.add_option("--format", reading.format, "Read as this format instead of recognising it")
      ->type_name("ID")
      ->group("Input");
  add_metadata_flag(verb, reading.metadata, "Metadata over what the file says, such as " + example);
}

}  // namespace axiometry::cli
