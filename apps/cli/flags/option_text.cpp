// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/option_text.h"

#include <fmt/format.h>

#include "axiometry/app/files/given_text.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/language/language.h"
#include "axiometry/report/option_words.h"

namespace axiometry::cli {

Flag add_read(const Verb& verb, const OptionText& text, std::function<Result<void>(const std::string&)> read) {
  return verb
      .add_option_function<std::string>(
          text.name,
          [name = text.name, read](const std::string& value) {
            if (Result<void> done = read(value); !done) throw UsageError(name, done.error().message);
          },
          text.description)
      ->type_name(text.type);
}

Flag add_number(const Verb& verb, const OptionText& text, std::function<void(double)> put) {
  return add_read(verb, text, [put](const std::string& value) -> Result<void> {
    const auto x = parse_number(value);
    if (!x) return fail(fmt::format("found {}, expected a number", axiometry::text::quoted(value)));
    put(*x);
    return {};
  });
}

Flag add_count(const Verb& verb, const OptionText& text, std::function<void(unsigned long long)> put) {
  return add_read(verb, text, [put](const std::string& value) -> Result<void> {
    const auto count = parse_count(value);
    if (!count) return fail(fmt::format("found {}, expected a whole number", axiometry::text::quoted(value)));
    put(*count);
    return {};
  });
}

Flag add_seed(const Verb& verb, const std::string& description, std::function<void(unsigned long long)> put) {
  return add_read(verb, {"--seed", "N", description}, [put](const std::string& value) -> Result<void> {
    const auto seed = parse_count(value);
    if (!seed || *seed >= app::seed_limit)
      return fail(fmt::format("found {}, expected a whole number from 0 to {}", axiometry::text::quoted(value),
                              app::seed_limit - 1));
    put(*seed);
    return {};
  });
}

Flag add_decimal(const Verb& verb, char& mark, const std::string& description) {
  return add_read(verb, {"--decimal", "MARK", description}, [&mark](const std::string& word) -> Result<void> {
    AXIOMETRY_TRY(mark, report::decimal_mark_of(word));
    return {};
  });
}

Flag add_language(const Verb& verb, report::Options& options, Flag decimal) {
  return add_read(verb, {"--language", "LANGUAGE", "Language of reports and sheets: " + language::tags_of_languages()},
                  [&options, decimal](const std::string& word) -> Result<void> {
                    AXIOMETRY_TRY(options.language, language::chosen_language(word));
                    if (decimal->count() == 0) options.numbers = language::usual_numbers(options.language);
                    return {};
                  });
}

Flag add_language(const Verb& verb) {
  return add_read(verb, {"--language", "LANGUAGE", "Language of what is told: " + language::tags_of_languages()},
                  [](const std::string& word) -> Result<void> {
                    AXIOMETRY_TRY_VOID(language::chosen_language(word));
                    return {};
                  });
}

std::string fault_of_empty_name(const std::string& name) {
  return name.empty() ? std::string("found an empty name, expected a file") : std::string();
}

std::string fault_of_name(const std::string& name) {
  return name.empty() ? "found an empty name, expected a file or -" : "";
}

}  // namespace axiometry::cli
