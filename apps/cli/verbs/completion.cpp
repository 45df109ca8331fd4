// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "axiometry/formats/format.h"
#include "axiometry/language/language.h"
#include "cli/flags/verb.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

/// A long flag as the shells need it.
struct ShellFlag {
  std::string name;         ///< "--json"
  std::string description;  ///< first sentence, without quotes
  bool takes_value = false;
  std::vector<std::string> values;  ///< to offer; empty with a value means files
};

std::string plain(std::string text) {
  std::erase_if(text, [](char c) { return c == '\'' || c == '"' || c == '[' || c == ']' || c == '`' || c == '\\'; });
  std::ranges::replace(text, ':', ',');
  return text;
}

std::vector<std::string> values_of(const std::string& flag) {
  if (flag == "--unit") return {"um", "mm", "nm", "deg", "arcsec"};
  if (flag == "--decimal") return {"point", "comma"};
  if (flag == "--language") {
    std::vector<std::string> tags;
    for (const language::Language each : language::languages()) tags.emplace_back(language::tag(each));
    return tags;
  }
  if (flag == "--precision") return {"double", "single"};
  if (flag == "--color") return {"auto", "always", "never"};
  if (flag != "--format") return {};
  std::vector<std::string> ids;
  for (const formats::Format* format : formats::format_table()) ids.emplace_back(format->id);
  return ids;
}

std::vector<ShellFlag> flags_of(const CLI::App& app) {
  std::vector<ShellFlag> flags;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) {
      ShellFlag flag{"--" + name, plain(option->get_description()), option->get_items_expected_max() > 0, {}};
      flag.values = values_of(flag.name);
      flags.push_back(std::move(flag));
    }
  return flags;
}

std::vector<const CLI::App*> verbs_of(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

std::string bash(const CLI::App& program) {
  std::string verbs;
  std::string flags;
  std::string values;
  for (const CLI::App* verb : verbs_of(program)) {
    verbs += verb->get_name() + " ";
    std::string words;
    for (const ShellFlag& flag : flags_of(*verb)) {
      words += flag.name + " ";
      if (!flag.values.empty() && values.find(flag.name + ")") == std::string::npos)
        values += fmt::format("    {}) COMPREPLY=($(compgen -W \"{}\" -- \"$word\")); return ;;\n", flag.name,
                              fmt::join(flag.values, " "));
    }
    flags += fmt::format("    {}) flags=\"{}\" ;;\n", verb->get_name(), words);
  }
  return fmt::format(R"(# bash completion of axiometry: source <(axiometry completion bash)
_axiometry() {{
  local word="${{COMP_WORDS[COMP_CWORD]}}" flags=""
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W "{}--help --version" -- "$word")); return
  fi
  case "${{COMP_WORDS[COMP_CWORD-1]}}" in
{}  esac
  case "${{COMP_WORDS[1]}}" in
{}  esac
  case "$word" in
    -*) COMPREPLY=($(compgen -W "$flags" -- "$word")) ;;
    *) COMPREPLY=($(compgen -f -- "$word")) ;;
  esac
}}
complete -o filenames -F _axiometry axiometry
)",
                     verbs, values, flags);
}

std::string zsh(const CLI::App& program) {
  std::string verbs;
  std::string cases;
  for (const CLI::App* verb : verbs_of(program)) {
    verbs += fmt::format("    '{}:{}'\n", verb->get_name(), plain(verb->get_description()));
    std::string words;
    for (const ShellFlag& flag : flags_of(*verb)) {
      const std::string value = !flag.takes_value     ? ""
                                : flag.values.empty() ? ":value:_files"
                                                      : fmt::format(":value:({})", fmt::join(flag.values, " "));
      words += fmt::format(" \\\n      '*{}[{}]{}'", flag.name, flag.description, value);
    }
    cases += fmt::format("    {}) _arguments{} \\\n      '*:file:_files' ;;\n", verb->get_name(), words);
  }
  return fmt::format(R"(#compdef axiometry
# zsh completion of axiometry: axiometry completion zsh > "${{fpath[1]}}/_axiometry"
_axiometry() {{
  local -a verbs
  verbs=(
{}  )
  if (( CURRENT == 2 )); then _describe verb verbs; return; fi
  local verb=$words[2]
  shift words; (( CURRENT-- ))
  case $verb in
{}  esac
}}
compdef _axiometry axiometry
)",
                     verbs, cases);
}

std::string fish(const CLI::App& program) {
  std::string text =
      "# fish completion of axiometry: axiometry completion fish > ~/.config/fish/completions/axiometry.fish\n";
  for (const CLI::App* verb : verbs_of(program)) {
    text += fmt::format("complete -c axiometry -n __fish_use_subcommand -f -a {} -d '{}'\n", verb->get_name(),
                        plain(verb->get_description()));
    for (const ShellFlag& flag : flags_of(*verb)) {
      text += fmt::format("complete -c axiometry -n '__fish_seen_subcommand_from {}' -l {}{}", verb->get_name(),
                          flag.name.substr(2), flag.takes_value ? " -r" : "");
      if (!flag.values.empty()) text += fmt::format(" -f -a '{}'", fmt::join(flag.values, " "));
      text += fmt::format(" -d '{}'\n", flag.description);
    }
  }
  return text;
}

}  // namespace

void add_completion(const Verb& program, int& exit_code) {
  const Verb verb = program.add_subcommand("completion", "Print the shell completion for bash, zsh or fish");
  auto shell = std::make_shared<std::string>();
  verb->add_option("SHELL", *shell, "bash, zsh or fish")->required()->check_among({"bash", "zsh", "fish"});
  verb->callback([program, shell, &exit_code] {
    const CLI::App& app = program.app();
    fmt::print("{}", *shell == "bash" ? bash(app) : *shell == "zsh" ? zsh(app) : fish(app));
    exit_code = exit_done;
  });
}

}  // namespace axiometry::cli
