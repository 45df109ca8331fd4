// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/rules/message.h"

#include "axiometry/base/contract.h"

namespace axiometry::iso230_2::rules {

Message formatted_message(std::string_view format, fmt::format_args arguments,
                          std::span<const Message* const> messages) {
  Message result;
  for (std::size_t number = 0; number < messages.size(); ++number) {
    const std::size_t open = format.find('{');
    AXIOMETRY_CONTRACT(open != std::string_view::npos);
    const std::size_t close = format.find('}', open);
    const std::string_view spelling = format.substr(open + 1, close - open - 1);
    AXIOMETRY_CONTRACT(close != std::string_view::npos && (spelling.empty() || spelling.front() == ':'));
    result.text += format.substr(0, open);
    const Message* const inner = messages[number];
    if (inner != nullptr)
      for (MessageDeviation deviation : inner->deviations) {
        deviation.at += result.text.size();
        result.deviations.push_back(deviation);
      }
    if (inner != nullptr && spelling.empty())
      result.text += inner->text;
    else
      result.text += fmt::vformat(fmt::format("{{{}{}}}", number, spelling), arguments);
    format.remove_prefix(close + 1);
  }
  AXIOMETRY_CONTRACT(!format.contains('{'));
  result.text += format;
  return result;
}

}  // namespace axiometry::iso230_2::rules
