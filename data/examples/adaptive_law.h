/* SPDX-FileCopyrightText: 2026 The Fathom authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * The adaptive law on the vehicle's own computer: plain C99, this file alone, no library, no memory
 * but the struct. It gives the estimates of fathom_follow (docs/adaptive.md):
 *
 *   dv_hat/dt = a_m dv + Phi' f,   dv = v_hat - v                                            (1)
 *   dPhi/dt   = -Lambda dv f,      f = (tau, v_hat|v_hat|, v_hat, 1)                         (2)
 *
 * of the parameters of  m dv/dt + d_Q v|v| + d_L v + b = tau  along one degree of freedom.
 *
 *   fathom_adaptive_law law;
 *   fathom_adaptive_start(&law, a_m, lambda, FATHOM_ADAPTIVE_RUNGE_KUTTA);
 *   ... with each sample:
 *   if (fathom_adaptive_add(&law, t, tau, v) == FATHOM_ADAPTIVE_OK) {
 *     double parameters[4];
 *     fathom_adaptive_estimate(&law, parameters);
 *   }
 *
 * What it does not hold: the scatter of the estimates, and whether they mean anything. Take
 * fathom_follow for these.
 */
#ifndef FATHOM_ADAPTIVE_LAW_H
#define FATHOM_ADAPTIVE_LAW_H

/* A longer silence between two samples starts v_hat anew [s]; the parameters stay. */
#define FATHOM_ADAPTIVE_LONGEST_GAP 30.0

/* The least alpha that the parameters are made of [1/kg] or [1/(kg m^2)]. */
#define FATHOM_ADAPTIVE_SMALLEST_ALPHA 1e-5

enum fathom_adaptive_integrator {
  FATHOM_ADAPTIVE_EULER,      /* as in the paper; v_hat starts at 0 */
  FATHOM_ADAPTIVE_RUNGE_KUTTA /* order four; v_hat starts at the first v, which is then linear */
};

enum fathom_adaptive_result {
  FATHOM_ADAPTIVE_OK,
  FATHOM_ADAPTIVE_BAD_SAMPLE, /* not finite, or a stamp that does not rise; it was not taken */
  FATHOM_ADAPTIVE_DIVERGED    /* the step is too long for the gains: start anew */
};

typedef struct fathom_adaptive_law {
  double a_m;       /* [1/s], below 0 */
  double lambda[4]; /* of alpha, beta, mu and nu, above 0 */
  enum fathom_adaptive_integrator integrator;
  double state[5];  /* v_hat [m/s] or [rad/s], then Phi: alpha, beta, mu, nu */
  double t;         /* of the last sample [s] */
  double force;     /* of the last sample [N] or [N m], held until the next one */
  double velocity;  /* measured, of the last sample [m/s] or [rad/s] */
  long num_samples; /* so far */
  int has_diverged;
} fathom_adaptive_law;

static inline void fathom_adaptive_start(fathom_adaptive_law* law,
                                         double a_m,
                                         const double lambda[4],
                                         enum fathom_adaptive_integrator integrator) {
  int k;
  law->a_m = a_m;
  for (k = 0; k < 4; ++k) law->lambda[k] = lambda[k];
  law->integrator = integrator;
  for (k = 0; k < 5; ++k) law->state[k] = 0.0;
  law->t = law->force = law->velocity = 0.0;
  law->num_samples = 0;
  law->has_diverged = 0;
}

static inline int fathom_adaptive_is_finite(double x) { return x - x == 0.0; }

/* (1) and (2) at a state under the force of the last sample, with the measured velocity v. */
static inline void fathom_adaptive_derivative(const fathom_adaptive_law* law,
                                              const double state[5],
                                              double v,
                                              double derivative[5]) {
  const double tau = law->force;
  const double v_hat = state[0];
  const double drag = v_hat * (v_hat < 0.0 ? -v_hat : v_hat);
  const double dv = v_hat - v;
  derivative[0] = law->a_m * dv + state[1] * tau + state[2] * drag + state[3] * v_hat + state[4];
  derivative[1] = -law->lambda[0] * dv * tau;
  derivative[2] = -law->lambda[1] * dv * drag;
  derivative[3] = -law->lambda[2] * dv * v_hat;
  derivative[4] = -law->lambda[3] * dv;
}

/* moved = state + h derivative. */
static inline void fathom_adaptive_move(const double state[5],
                                        double h,
                                        const double derivative[5],
                                        double moved[5]) {
  int k;
  for (k = 0; k < 5; ++k) moved[k] = state[k] + h * derivative[k];
}

static inline void fathom_adaptive_euler(fathom_adaptive_law* law, double h) {
  double k1[5];
  fathom_adaptive_derivative(law, law->state, law->velocity, k1);
  fathom_adaptive_move(law->state, h, k1, law->state);
}

/* The measured velocity goes on a straight line to v. */
static inline void fathom_adaptive_runge_kutta(fathom_adaptive_law* law, double h, double v) {
  const double middle = 0.5 * (law->velocity + v);
  double k1[5], k2[5], k3[5], k4[5], at[5];
  int k;
  fathom_adaptive_derivative(law, law->state, law->velocity, k1);
  fathom_adaptive_move(law->state, 0.5 * h, k1, at);
  fathom_adaptive_derivative(law, at, middle, k2);
  fathom_adaptive_move(law->state, 0.5 * h, k2, at);
  fathom_adaptive_derivative(law, at, middle, k3);
  fathom_adaptive_move(law->state, h, k3, at);
  fathom_adaptive_derivative(law, at, v, k4);
  for (k = 0; k < 5; ++k) {
    law->state[k] += h / 6.0 * (k1[k] + 2.0 * (k2[k] + k3[k]) + k4[k]);
  }
}

/* One sample: stamp [s], force [N] or [N m] that holds from it on, measured velocity [m/s] or
 * [rad/s]. */
static inline enum fathom_adaptive_result fathom_adaptive_add(fathom_adaptive_law* law,
                                                              double t,
                                                              double force,
                                                              double velocity) {
  const double h = t - law->t;
  const int is_first = law->num_samples == 0;
  int k;
  if (law->has_diverged) return FATHOM_ADAPTIVE_DIVERGED;
  if (!fathom_adaptive_is_finite(t) || !fathom_adaptive_is_finite(force) ||
      !fathom_adaptive_is_finite(velocity) || (!is_first && !(h > 0.0))) {
    return FATHOM_ADAPTIVE_BAD_SAMPLE;
  }
  if (is_first || h > FATHOM_ADAPTIVE_LONGEST_GAP) {
    law->state[0] = law->integrator == FATHOM_ADAPTIVE_EULER ? 0.0 : velocity;
  } else if (law->integrator == FATHOM_ADAPTIVE_EULER) {
    fathom_adaptive_euler(law, h);
  } else {
    fathom_adaptive_runge_kutta(law, h, velocity);
  }
  law->t = t;
  law->force = force;
  law->velocity = velocity;
  ++law->num_samples;
  for (k = 0; k < 5; ++k) {
    if (!fathom_adaptive_is_finite(law->state[k])) law->has_diverged = 1;
  }
  return law->has_diverged ? FATHOM_ADAPTIVE_DIVERGED : FATHOM_ADAPTIVE_OK;
}

/* Inertia [kg] or [kg m^2], quadratic damping [kg/m] or [kg m^2], linear damping [kg/s] or
 * [kg m^2/s], buoyancy [N] or [N m], in this order. They mean nothing before a sample was taken, or
 * while the inertia is 1e5: alpha is then at its least. */
static inline void fathom_adaptive_estimate(const fathom_adaptive_law* law, double parameters[4]) {
  const double alpha = law->state[1] > FATHOM_ADAPTIVE_SMALLEST_ALPHA
                           ? law->state[1]
                           : FATHOM_ADAPTIVE_SMALLEST_ALPHA;
  parameters[0] = 1.0 / alpha;
  parameters[1] = -law->state[2] / alpha;
  parameters[2] = -law->state[3] / alpha;
  parameters[3] = -law->state[4] / alpha;
}

#endif
