// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/verb.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

namespace axiometry::cli {
namespace {

/// What a function of ours finds wrong, as CLI11 says it.
template <typename... Parts>
auto told(std::function<void(Parts...)> function) {
  return [function = std::move(function)](Parts... parts) {
    try {
      function(parts...);
    } catch (const UsageError& error) {
      throw CLI::ValidationError(std::string(error.what()));
    }
  };
}

}  // namespace

Flag Flag::type_name(const std::string& name) const { return option_->type_name(name); }
Flag Flag::group(const std::string& title) const { return option_->group(title); }
Flag Flag::required() const { return option_->required(); }
Flag Flag::check(const std::function<std::string(const std::string&)>& fault_of) const {
  return option_->check(fault_of);
}
Flag Flag::check_range(int lowest, int highest) const {
  return option_->check(CLI::Range(lowest, highest).description(""));
}
Flag Flag::check_among(const std::vector<std::string>& words) const { return option_->check(CLI::IsMember(words)); }
Flag Flag::expected(int values) const { return option_->expected(values); }
Flag Flag::expected(int least, int most) const { return option_->expected(least, most); }
Flag Flag::take_all() const { return option_->multi_option_policy(CLI::MultiOptionPolicy::TakeAll); }
Flag Flag::one_at_a_time() const { return option_->allow_extra_args(false); }
Flag Flag::trigger_on_parse() const { return option_->trigger_on_parse(); }
Flag Flag::excludes(Flag other) const { return option_->excludes(other.option_); }
Flag Flag::needs(Flag other) const { return option_->needs(other.option_); }
std::size_t Flag::count() const { return option_->count(); }
std::string Flag::get_name() const { return option_->get_name(); }
std::vector<std::string> Flag::results() const { return option_->results(); }

Verb Verb::add_subcommand(const std::string& name, const std::string& description) const {
  return *app_->add_subcommand(name, description);
}
Verb Verb::add_option_group(const std::string& title) const { return *app_->add_option_group(title); }

template <typename Target>
Flag Verb::add_option(const std::string& name, Target& target, const std::string& description) const {
  return app_->add_option(name, target, description);
}
template Flag Verb::add_option(const std::string&, int&, const std::string&) const;
template Flag Verb::add_option(const std::string&, unsigned&, const std::string&) const;
template Flag Verb::add_option(const std::string&, std::int64_t&, const std::string&) const;
template Flag Verb::add_option(const std::string&, std::size_t&, const std::string&) const;
template Flag Verb::add_option(const std::string&, std::optional<int>&, const std::string&) const;
template Flag Verb::add_option(const std::string&, std::string&, const std::string&) const;
template Flag Verb::add_option(const std::string&, std::optional<std::string>&, const std::string&) const;
template Flag Verb::add_option(const std::string&, std::vector<std::string>&, const std::string&) const;

template <typename Text>
Flag Verb::add_option_function(const std::string& name, const std::function<void(const Text&)>& take,
                               const std::string& description) const {
  return app_->add_option_function<Text>(name, told(take), description);
}
template Flag Verb::add_option_function(const std::string&, const std::function<void(const std::string&)>&,
                                        const std::string&) const;
template Flag Verb::add_option_function(const std::string&, const std::function<void(const std::vector<std::string>&)>&,
                                        const std::string&) const;

Flag Verb::add_flag(const std::string& name, bool& target, const std::string& description) const {
  return app_->add_flag(name, target, description);
}
Flag Verb::add_flag_function(const std::string& name, const std::function<void(std::int64_t)>& given,
                             const std::string& description) const {
  return app_->add_flag_function(name, told(given), description);
}
Flag Verb::add_flag_callback(const std::string& name, const std::function<void()>& given,
                             const std::string& description) const {
  return app_->add_flag_callback(name, told(given), description);
}

void Verb::callback(const std::function<void()>& run) const { app_->callback(told(run)); }
void Verb::footer(const std::string& text) const { app_->footer(text); }
void Verb::require_subcommand(int least, int most) const {
  app_->require_subcommand(static_cast<std::size_t>(least), static_cast<std::size_t>(most));
}
bool Verb::has_chosen_subcommand() const { return !app_->get_subcommands().empty(); }

Flag Verb::get_option(const std::string& name) const { return app_->get_option(name); }
std::optional<Flag> Verb::find_option(const std::string& name) const {
  CLI::Option* const option = app_->get_option_no_throw(name);
  return option == nullptr ? std::nullopt : std::optional<Flag>(option);
}
std::size_t Verb::count(const std::string& name) const { return app_->count(name); }
std::string Verb::get_name() const { return app_->get_name(); }

void check_alone(const Verb& verb, const std::string& name, const std::vector<std::string>& beside) {
  if (verb.count(name) == 0) return;
  for (const CLI::Option* option : verb.app().get_options()) {
    const std::string other = option->get_name();
    if (option->count() == 0 || other == name || std::ranges::find(beside, other) != beside.end()) continue;
    throw UsageError(name, "found " + other + " beside it, which it has no use for; expected it to be left out");
  }
}

std::vector<std::string> option_names(const Verb& verb) {
  std::vector<std::string> names;
  const auto add = [&](const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) names.push_back(option->get_name());
  };
  add(verb.app());
  for (const CLI::App* group : verb.app().get_subcommands({}))
    if (group->get_name().empty()) add(*group);
  return names;
}

}  // namespace axiometry::cli
