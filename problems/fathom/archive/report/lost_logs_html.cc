// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/report/lost_logs_html.h"

#include "fathom/archive/report/archive_sentences.h"
#include "fathom/archive/report/log_states.h"
#include "fathom/base/plural.h"
#include "fathom/report/html_text.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kPathsInSight = 3;
constexpr std::size_t kMessagesInSight = 40;

using Paths = std::vector<const std::string*>;
using ByMessage = std::map<std::string, Paths>;

std::string ListHtml(const Paths& paths) {
  std::string html = "<ul class=\"paths\">";
  for (const std::string* path : paths) html += "<li>" + HtmlText(*path) + "</li>";
  return html + "</ul>";
}

std::string MessageHtml(const std::string& message, const Paths& paths) {
  const std::string text = HtmlText(message.empty() ? "No message." : message);
  if (paths.size() <= kPathsInSight) {
    return fmt::format("<div class=\"reason\"><p>{}</p>{}</div>\n", text, ListHtml(paths));
  }
  return fmt::format("<details class=\"reason\"><summary>{} <b>{}</b></summary>{}</details>\n",
                     text,
                     Plural(paths.size(), "log"),
                     ListHtml(paths));
}

std::string StateHtml(const std::string& state, const ByMessage& by_message) {
  std::vector<std::pair<std::string, Paths>> messages(by_message.begin(), by_message.end());
  std::ranges::stable_sort(
      messages, std::greater<>(), [](const auto& entry) { return entry.second.size(); });
  std::size_t num_logs = 0;
  for (const auto& [message, paths] : messages) num_logs += paths.size();

  std::string html = fmt::format(
      "<h3>{} <span>{}</span></h3>\n", HtmlText(StateText(state)), Plural(num_logs, "log"));
  if (const auto meaning = StateMeaning(state); !meaning.empty()) {
    html += fmt::format("<p class=\"hint\">{}</p>\n", meaning);
  }
  const bool has_more = messages.size() > kMessagesInSight;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    if (has_more && i == kMessagesInSight) {
      html += fmt::format("<details class=\"more\"><summary>{}</summary>\n",
                          Plural(messages.size() - i, "more message"));
    }
    html += MessageHtml(messages[i].first, messages[i].second);
  }
  return html + (has_more ? "</details>\n" : "");
}

}  // namespace

std::string LostLogsHtml(const std::vector<LogRow>& logs) {
  std::map<std::string, ByMessage> by_state;
  std::vector<std::string> states = StatesInOrder();
  for (const LogRow& log : logs) {
    if (GivesModel(log.status)) continue;
    by_state[log.status][log.message].push_back(&log.path);
    if (std::ranges::find(states, log.status) == states.end()) states.push_back(log.status);
  }
  if (by_state.empty()) return "<p class=\"text\">Every log gave a model.</p>\n";
  std::string html;
  for (const std::string& state : states) {
    const auto found = by_state.find(state);
    if (found != by_state.end()) html += StateHtml(state, found->second);
  }
  return html;
}

}  // namespace fathom
