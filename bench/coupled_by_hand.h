/* SPDX-FileCopyrightText: 2026 The Fathom authors
 * SPDX-License-Identifier: BSD-3-Clause */

#pragma once

#ifdef __cplusplus
extern "C" {
#endif

/* What one would write by hand in C for one vehicle: docs/coupled.md (1) of six DOFs without fins,
 * by the classical Runge-Kutta scheme with a step for each sample of the command, and its
 * sensitivities by (5). The peer of bench/coupled_bench. */

enum { HAND_ENTRIES = 30, HAND_COLUMNS = HAND_ENTRIES + 6 + 3 };

typedef struct {
  double inertia[6][6], linear_damping[6][6], quadratic_damping[6][6];
  double offset[6];
  double net_buoyancy, righting_roll, righting_pitch;
} HandModel;

typedef enum {
  HAND_INERTIA,
  HAND_LINEAR_DAMPING,
  HAND_QUADRATIC_DAMPING,
  HAND_OFFSET,
  HAND_NET_BUOYANCY,
  HAND_RIGHTING_ROLL,
  HAND_RIGHTING_PITCH
} HandKind;

typedef struct {
  HandKind kind;
  int row, column;
} HandEntry;

/* Velocities, attitude x, y, z, w, position. */
typedef struct {
  double x[13];
} HandState;

/* What a state depends on. Rows: the velocities; a small turn in the body frame; the position in
 * the world. Columns: the entries, the velocities at the start, a turn at the start. */
typedef struct {
  double row[12][HAND_COLUMNS];
} HandTangent;

typedef struct {
  HandState state;
  HandTangent tangent;
} HandSample;

/* From rest, over `force`, each row held for `step` [s]. Returns 0 if the inertia has no inverse.
 */
int HandSimulate(const HandModel* model,
                 const HandEntry entries[HAND_ENTRIES],
                 const double (*force)[6],
                 int num_samples,
                 double step,
                 HandSample* samples);

#ifdef __cplusplus
}
#endif
