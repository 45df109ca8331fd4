// SPDX-License-Identifier: Apache-2.0
#include "option_text.h"

#include <fmt/format.h>

#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"

namespace axiometry::cli {

CLI::Option* add_read(CLI::App& verb, const OptionText& text, std::function<Result<void>(const std::string&)> read) {
  return verb
      .add_option_function<std::string>(
          text.name,
          [name = text.name, read](const std::string& value) {
            if (Result<void> done = read(value); !done) throw CLI::ValidationError(name, done.error().message);
          },
          text.description)
      ->type_name(text.type);
}

CLI::Option* add_number(CLI::App& verb, const OptionText& text, std::function<void(double)> put) {
  return add_read(verb, text, [put](const std::string& value) -> Result<void> {
    const auto x = parse_number(value);
    if (!x) return fail(fmt::format("found {}, expected a number", axiometry::text::quoted(value)));
    put(*x);
    return {};
  });
}

CLI::Option* add_count(CLI::App& verb, const OptionText& text, std::function<void(unsigned long long)> put) {
  return add_read(verb, text, [put](const std::string& value) -> Result<void> {
    const auto count = parse_count(value);
    if (!count) return fail(fmt::format("found {}, expected a whole number", axiometry::text::quoted(value)));
    put(*count);
    return {};
  });
}

}  // namespace axiometry::cli
