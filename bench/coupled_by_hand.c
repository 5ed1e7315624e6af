/* SPDX-FileCopyrightText: 2026 The Fathom authors
 * SPDX-License-Identifier: BSD-3-Clause */

#include "coupled_by_hand.h"

#include <math.h>
#include <string.h>

static int Invert(const double m[6][6], double inverse[6][6]) {
  double a[6][12];
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      a[i][j] = m[i][j];
      a[i][6 + j] = i == j;
    }
  }
  for (int k = 0; k < 6; ++k) {
    if (!(a[k][k] > 0.0)) return 0;
    const double scale = 1.0 / a[k][k];
    for (int j = 0; j < 12; ++j) a[k][j] *= scale;
    for (int i = 0; i < 6; ++i) {
      if (i == k) continue;
      const double factor = a[i][k];
      for (int j = 0; j < 12; ++j) a[i][j] -= factor * a[k][j];
    }
  }
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) inverse[i][j] = a[i][6 + j];
  }
  return 1;
}

static void Cross(const double a[3], const double b[3], double c[3]) {
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

/* (2), of a momentum. */
static void Coriolis(const double momentum[6], const double nu[6], double force[6]) {
  double a[3], b[3];
  Cross(nu + 3, momentum, force);
  Cross(nu, momentum, a);
  Cross(nu + 3, momentum + 3, b);
  for (int i = 0; i < 3; ++i) force[3 + i] = a[i] + b[i];
}

static void Times(const double m[6][6], const double x[6], double y[6]) {
  for (int i = 0; i < 6; ++i) {
    y[i] = 0.0;
    for (int j = 0; j < 6; ++j) y[i] += m[i][j] * x[j];
  }
}

static void Rotation(const double q[4], double r[3][3]) {
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  r[0][0] = 1.0 - 2.0 * (y * y + z * z);
  r[0][1] = 2.0 * (x * y - w * z);
  r[0][2] = 2.0 * (x * z + w * y);
  r[1][0] = 2.0 * (x * y + w * z);
  r[1][1] = 1.0 - 2.0 * (x * x + z * z);
  r[1][2] = 2.0 * (y * z - w * x);
  r[2][0] = 2.0 * (x * z - w * y);
  r[2][1] = 2.0 * (y * z + w * x);
  r[2][2] = 1.0 - 2.0 * (x * x + y * y);
}

/* The world's down, seen in the body. */
static void Down(const double q[4], double down[3]) {
  down[0] = 2.0 * (q[0] * q[2] - q[3] * q[1]);
  down[1] = 2.0 * (q[1] * q[2] + q[3] * q[0]);
  down[2] = q[3] * q[3] + q[2] * q[2] - q[0] * q[0] - q[1] * q[1];
}

/* The rate of the state, (1). */
static void Rate(const HandModel* model,
                 const double inverse[6][6],
                 const double tau[6],
                 const HandState* at,
                 double rotation[3][3],
                 HandState* rate) {
  const double *nu = at->x, *q = at->x + 6;
  double *rate_nu = rate->x, *turn = rate->x + 6, *speed = rate->x + 10;
  double momentum[6], coriolis[6], force[6], down[3];
  Rotation(q, rotation);
  Down(q, down);
  Times(model->inertia, nu, momentum);
  Coriolis(momentum, nu, coriolis);
  for (int i = 0; i < 6; ++i) {
    force[i] = tau[i] - model->offset[i] - coriolis[i];
    for (int j = 0; j < 6; ++j) {
      force[i] -=
          (model->linear_damping[i][j] + model->quadratic_damping[i][j] * fabs(nu[j])) * nu[j];
    }
  }
  for (int i = 0; i < 3; ++i) force[i] -= model->net_buoyancy * down[i];
  force[3] -= model->righting_roll * down[1];
  force[4] += model->righting_pitch * down[0];
  Times(inverse, force, rate_nu);
  const double p = nu[3], s = nu[4], r = nu[5];
  turn[0] = 0.5 * (q[3] * p + q[1] * r - q[2] * s);
  turn[1] = 0.5 * (q[3] * s + q[2] * p - q[0] * r);
  turn[2] = 0.5 * (q[3] * r + q[0] * s - q[1] * p);
  turn[3] = -0.5 * (q[0] * p + q[1] * s + q[2] * r);
  for (int i = 0; i < 3; ++i) {
    speed[i] = rotation[i][0] * nu[0] + rotation[i][1] * nu[1] + rotation[i][2] * nu[2];
  }
}

/* The force of docs/coupled.md (5) by nu. */
static void ByVelocity(const HandModel* model, const double nu[6], double by[6][6]) {
  double momentum[6];
  Times(model->inertia, nu, momentum);
  for (int j = 0; j < 6; ++j) {
    double unit[6] = {0}, column[6], a[6], b[6];
    unit[j] = 1.0;
    for (int i = 0; i < 6; ++i) column[i] = model->inertia[i][j];
    Coriolis(momentum, unit, a);
    Coriolis(column, nu, b);
    for (int i = 0; i < 6; ++i) {
      by[i][j] = -a[i] - b[i] - model->linear_damping[i][j] -
                 2.0 * model->quadratic_damping[i][j] * fabs(nu[j]);
    }
  }
}

/* What an entry of 1 more adds to the force. */
static void AddEntry(const HandEntry* entry,
                     const HandState* at,
                     const HandState* rate,
                     const double down[3],
                     int k,
                     double force[6][HAND_COLUMNS]) {
  const double *nu = at->x, *rate_nu = rate->x;
  const int i = entry->row, j = entry->column;
  switch (entry->kind) {
    case HAND_INERTIA: {
      double momentum[6] = {0}, coriolis[6];
      force[i][k] -= rate_nu[j];
      momentum[i] = nu[j];
      if (i != j) {
        force[j][k] -= rate_nu[i];
        momentum[j] = nu[i];
      }
      Coriolis(momentum, nu, coriolis);
      for (int l = 0; l < 6; ++l) force[l][k] -= coriolis[l];
      break;
    }
    case HAND_LINEAR_DAMPING:
      force[i][k] -= nu[j];
      break;
    case HAND_QUADRATIC_DAMPING:
      force[i][k] -= fabs(nu[j]) * nu[j];
      break;
    case HAND_OFFSET:
      force[i][k] -= 1.0;
      break;
    case HAND_NET_BUOYANCY:
      for (int l = 0; l < 3; ++l) force[l][k] -= down[l];
      break;
    case HAND_RIGHTING_ROLL:
      force[3][k] -= down[1];
      break;
    case HAND_RIGHTING_PITCH:
      force[4][k] += down[0];
      break;
  }
}

/* y = S(x): S(x) b = x x b. */
static void CrossMatrix(const double x[3], double y[3][3]) {
  const double s[3][3] = {{0.0, -x[2], x[1]}, {x[2], 0.0, -x[0]}, {-x[1], x[0], 0.0}};
  memcpy(y, s, sizeof s);
}

/* to += factor * from, over all columns. */
static void AddRow(double factor, const double* from, double* to) {
  for (int c = 0; c < HAND_COLUMNS; ++c) to[c] += factor * from[c];
}

static void TangentRate(const HandModel* model,
                        const double inverse[6][6],
                        const HandEntry* entries,
                        const HandState* at,
                        const HandState* rate,
                        double rotation[3][3],
                        const HandTangent* x,
                        HandTangent* out) {
  double by[6][6], by_turn[6][3] = {{0}}, turned[3][3], of_rates[3][3], of_speeds[3][3];
  double force[6][HAND_COLUMNS];
  double down[3];
  Down(at->x + 6, down);
  ByVelocity(model, at->x, by);
  CrossMatrix(down, turned);
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) by_turn[i][j] = -model->net_buoyancy * turned[i][j];
    by_turn[3][j] = -model->righting_roll * turned[1][j];
    by_turn[4][j] = model->righting_pitch * turned[0][j];
  }
  memset(force, 0, sizeof force);
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) AddRow(by[i][j], x->row[j], force[i]);
    for (int j = 0; j < 3; ++j) AddRow(by_turn[i][j], x->row[6 + j], force[i]);
  }
  for (int k = 0; k < HAND_ENTRIES; ++k) AddEntry(&entries[k], at, rate, down, k, force);
  memset(out, 0, sizeof *out);
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) AddRow(inverse[i][j], force[j], out->row[i]);
  }
  CrossMatrix(at->x + 3, of_rates);
  CrossMatrix(at->x, of_speeds);
  for (int i = 0; i < 3; ++i) {
    memcpy(out->row[6 + i], x->row[3 + i], sizeof out->row[0]);
    for (int j = 0; j < 3; ++j) {
      const double by_speeds = rotation[i][0] * of_speeds[0][j] + rotation[i][1] * of_speeds[1][j] +
                               rotation[i][2] * of_speeds[2][j];
      AddRow(-of_rates[i][j], x->row[6 + j], out->row[6 + i]);
      AddRow(rotation[i][j], x->row[j], out->row[9 + i]);
      AddRow(-by_speeds, x->row[6 + j], out->row[9 + i]);
    }
  }
}

/* to = from + h * rate. */
static void Move(const HandSample* from, double h, const HandSample* rate, HandSample* to) {
  for (int i = 0; i < 13; ++i) to->state.x[i] = from->state.x[i] + h * rate->state.x[i];
  for (int i = 0; i < 12; ++i) {
    for (int c = 0; c < HAND_COLUMNS; ++c) {
      to->tangent.row[i][c] = from->tangent.row[i][c] + h * rate->tangent.row[i][c];
    }
  }
}

/* x += h / 6 (k1 + 2 k2 + 2 k3 + k4). */
static void Sum(const HandSample k[4], double h, HandSample* x) {
  for (int i = 0; i < 13; ++i) {
    x->state.x[i] += h / 6.0 * (k[0].state.x[i] + k[3].state.x[i]) +
                     h / 3.0 * (k[1].state.x[i] + k[2].state.x[i]);
  }
  for (int i = 0; i < 12; ++i) {
    const double *a = k[0].tangent.row[i], *b = k[1].tangent.row[i];
    const double *c = k[2].tangent.row[i], *d = k[3].tangent.row[i];
    double* row = x->tangent.row[i];
    for (int j = 0; j < HAND_COLUMNS; ++j) {
      row[j] += h / 6.0 * (a[j] + d[j]) + h / 3.0 * (b[j] + c[j]);
    }
  }
}

int HandSimulate(const HandModel* model,
                 const HandEntry entries[HAND_ENTRIES],
                 const double (*force)[6],
                 int num_samples,
                 double step,
                 HandSample* samples) {
  static const double shares[4] = {0.0, 0.5, 0.5, 1.0};
  double inverse[6][6];
  HandSample x, stage, rates[4];
  if (!Invert(model->inertia, inverse)) return 0;
  memset(&x, 0, sizeof x);
  x.state.x[9] = 1.0;
  for (int i = 0; i < 9; ++i) x.tangent.row[i][HAND_ENTRIES + i] = 1.0;
  for (int n = 0; n < num_samples; ++n) {
    samples[n] = x;
    for (int k = 0; k < 4; ++k) {
      double rotation[3][3];
      if (k > 0) Move(&x, shares[k] * step, &rates[k - 1], &stage);
      const HandSample* at = k > 0 ? &stage : &x;
      HandState* rate = &rates[k].state;
      HandTangent* tangent_rate = &rates[k].tangent;
      Rate(model, inverse, force[n], &at->state, rotation, rate);
      TangentRate(model, inverse, entries, &at->state, rate, rotation, &at->tangent, tangent_rate);
    }
    Sum(rates, step, &x);
    double square = 0.0;
    for (int i = 6; i < 10; ++i) square += x.state.x[i] * x.state.x[i];
    for (int i = 6; i < 10; ++i) x.state.x[i] /= sqrt(square);
  }
  return 1;
}
