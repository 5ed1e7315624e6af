// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/store/known_log.h"
#include "fathom/archive/store/tables.h"

#include <string_view>

namespace fathom {

// The columns of each table, once for making, writing and reading it: visit(name, field) for each
// in order.

template <typename Row>
constexpr std::string_view TableName();
template <>
constexpr std::string_view TableName<LogRow>() {
  return "logs";
}
template <>
constexpr std::string_view TableName<FitRow>() {
  return "fits";
}
template <>
constexpr std::string_view TableName<DiveFitRow>() {
  return "dive_fits";
}
template <>
constexpr std::string_view TableName<ScoreRow>() {
  return "scores";
}
template <>
constexpr std::string_view TableName<VerdictRow>() {
  return "verdicts";
}
template <>
constexpr std::string_view TableName<CauseRow>() {
  return "causes";
}
template <>
constexpr std::string_view TableName<FindingRow>() {
  return "findings";
}
template <>
constexpr std::string_view TableName<PredictionRow>() {
  return "predictions";
}
template <>
constexpr std::string_view TableName<ChangeRow>() {
  return "changes";
}

template <>
constexpr std::string_view TableName<OutlierRow>() {
  return "outliers";
}

template <>
constexpr std::string_view TableName<KnownLogRow>() {
  return "known_logs";
}
template <>
constexpr std::string_view TableName<KnownDofRow>() {
  return "known_dofs";
}

template <typename Visit>
void VisitColumns(LogRow& row, Visit& visit) {
  visit("path", row.path);
  visit("dive", row.dive);
  visit("start", row.start);
  visit("duration", row.duration);
  visit("content", row.content);
  visit("status", row.status);
  visit("message", row.message);
  visit("seconds", row.seconds);
  visit("peak_mb", row.peak_mb);
  visit("version", row.version);
  visit("vehicle", row.vehicle);
}

template <typename Visit>
void VisitColumns(FitRow& row, Visit& visit) {
  visit("log", row.log);
  visit("dof", row.dof);
  visit("family", row.family);
  visit("source", row.source);
  visit("usable", row.usable);
  visit("parameter", row.parameter);
  visit("value", row.value);
  visit("std", row.std);
  visit("unit", row.unit);
  visit("message", row.message);
}

template <typename Visit>
void VisitColumns(DiveFitRow& row, Visit& visit) {
  visit("dive", row.dive);
  visit("dof", row.dof);
  visit("usable", row.usable);
  visit("parameter", row.parameter);
  visit("value", row.value);
  visit("std", row.std);
  visit("unit", row.unit);
  visit("logs", row.logs);
  visit("message", row.message);
  visit("vehicle", row.vehicle);
}

template <typename Visit>
void VisitColumns(ScoreRow& row, Visit& visit) {
  visit("log", row.log);
  visit("dof", row.dof);
  visit("family", row.family);
  visit("source", row.source);
  visit("mae", row.mae);
  visit("nmae", row.nmae);
  visit("heldout_mae", row.heldout_mae);
  visit("heldout_nmae", row.heldout_nmae);
}

template <typename Visit>
void VisitColumns(VerdictRow& row, Visit& visit) {
  visit("log", row.log);
  visit("dof", row.dof);
  visit("verdict", row.verdict);
  visit("sentence", row.sentence);
  visit("json", row.json);
}

template <typename Visit>
void VisitColumns(CauseRow& row, Visit& visit) {
  visit("log", row.log);
  visit("dof", row.dof);
  visit("effect", row.effect);
  visit("parameter", row.parameter);
  visit("value", row.value);
  visit("std", row.std);
  visit("unit", row.unit);
  visit("p_value", row.p_value);
  visit("heldout_gain", row.heldout_gain);
}

template <typename Visit>
void VisitColumns(FindingRow& row, Visit& visit) {
  visit("log", row.log);
  visit("dof", row.dof);
  visit("severity", row.severity);
  visit("id", row.id);
  visit("text", row.text);
}

template <typename Visit>
void VisitColumns(PredictionRow& row, Visit& visit) {
  visit("model_log", row.model_log);
  visit("log", row.log);
  visit("dof", row.dof);
  visit("nmae", row.nmae);
}

template <typename Visit>
void VisitColumns(ChangeRow& row, Visit& visit) {
  visit("dof", row.dof);
  visit("parameter", row.parameter);
  visit("kind", row.kind);
  visit("at", row.at);
  visit("before", row.before);
  visit("after", row.after);
  visit("before_std", row.before_std);
  visit("after_std", row.after_std);
  visit("p_value", row.p_value);
  visit("cause", row.cause);
  visit("text", row.text);
  visit("vehicle", row.vehicle);
}

template <typename Visit>
void VisitColumns(OutlierRow& row, Visit& visit) {
  visit("dive", row.dive);
  visit("dof", row.dof);
  visit("parameter", row.parameter);
  visit("vehicle", row.vehicle);
}

template <typename Visit>
void VisitColumns(KnownLogRow& row, Visit& visit) {
  visit("log", row.log);
  visit("status", row.status);
  visit("survey", row.survey);
  visit("made_by", row.made_by);
}

template <typename Visit>
void VisitColumns(KnownDofRow& row, Visit& visit) {
  visit("log", row.log);
  visit("dof", row.dof);
  visit("why_left_out", row.why_left_out);
  visit("own_nmae", row.own_nmae);
}

}  // namespace fathom
