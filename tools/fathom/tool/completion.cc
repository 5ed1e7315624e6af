// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/completion.h"

#include <cstddef>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// COMMANDS and PROGRAMS are filled in. Bash takes = for a word of its own where COMP_WORDBREAKS has
// it, which is so unless the user changed that.
constexpr std::string_view kBash =
    R"script(# Completion of Fathom for bash, by: fathom completion bash

_fathom() {
  local program=${COMP_WORDS[0]/#\~/$HOME}
  local word=${COMP_WORDS[COMP_CWORD]}
  local before=${COMP_WORDS[COMP_CWORD - 1]}
  local sub=()
  COMPREPLY=()
  if [[ ${program##*/} == fathom ]]; then
    case $COMP_CWORD,${COMP_WORDS[1]} in
      1,*)
        mapfile -t COMPREPLY < <(
          compgen -W "COMMANDS completion help --help --version" -- "$word")
        return ;;
      2,help) mapfile -t COMPREPLY < <(compgen -W "COMMANDS" -- "$word"); return ;;
      2,completion) mapfile -t COMPREPLY < <(compgen -W "bash zsh" -- "$word"); return ;;
    esac
    [[ " COMMANDS " == *" ${COMP_WORDS[1]} "* ]] || return
    sub=("${COMP_WORDS[1]}")
  fi
  local prefix=""
  if [[ $word == "=" ]]; then
    word=""
  elif [[ $word == --*=* ]]; then
    prefix=${word%%=*}=
    word=${word#*=}
  elif [[ $word == -* && $before != "=" ]]; then
    mapfile -t COMPREPLY < <(
      compgen -W "$("$program" "${sub[@]}" --flags 2>/dev/null)" -- "$word")
    [[ ${#COMPREPLY[@]} == 1 && ${COMPREPLY[0]} == *= ]] && compopt -o nospace 2>/dev/null
    return
  fi
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -f -P "$prefix" -- "$word")
}

complete -F _fathom fathom PROGRAMS
)script";

constexpr std::string_view kZsh = R"script(#compdef fathom PROGRAMS
# Completion of Fathom for zsh, by: fathom completion zsh

_fathom() {
  local program=${words[1]/#\~/$HOME}
  local -a sub flags commands
  commands=(COMMANDS)
  if [[ ${program:t} == fathom ]]; then
    if (( CURRENT == 2 )); then
      compadd -- $commands completion help --help --version
      return
    fi
    case $words[2] in
      help) compadd -- $commands; return ;;
      completion) compadd -- bash zsh; return ;;
    esac
    (( ${commands[(Ie)$words[2]]} )) || return
    sub=($words[2])
  fi
  if [[ $PREFIX == --*=* ]]; then
    compset -P '*='
    _files
  elif [[ $PREFIX == -* ]]; then
    flags=(${(f)"$($program $sub --flags 2>/dev/null)"})
    local missing=1
    compadd -S '' -- ${(M)flags:#*=} && missing=0
    compadd -- ${flags:#*=} && missing=0
    return missing
  else
    _files
  fi
}

if [[ $funcstack[1] == _fathom ]]; then
  _fathom "$@"
else
  compdef _fathom fathom PROGRAMS
fi
)script";

std::string FilledIn(std::string_view script, const std::vector<std::string>& commands) {
  std::vector<std::string> programs;
  for (const std::string& command : commands) programs.push_back("fathom_" + command);
  std::string text(script);
  const auto replace_all = [&](std::string_view mark, const std::vector<std::string>& words) {
    const std::string joined = fmt::format("{}", fmt::join(words, " "));
    for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos; at += joined.size()) {
      text.replace(at, mark.size(), joined);
    }
  };
  replace_all("COMMANDS", commands);
  replace_all("PROGRAMS", programs);
  return text;
}

}  // namespace

std::string BashCompletion(const std::vector<std::string>& commands) {
  return FilledIn(kBash, commands);
}

std::string ZshCompletion(const std::vector<std::string>& commands) {
  return FilledIn(kZsh, commands);
}

}  // namespace fathom
