/* SPDX-FileCopyrightText: 2026 The Fathom authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * The adaptive law in C: lines t,tau,v on stdin, the estimates on stdout.
 *
 *   cc -std=c99 -O2 -o adaptive_law adaptive_law.c
 *   ./adaptive_law -0.1 1.1e-5 20 0.7 0.015 < run.csv       (euler behind them: as in the paper)
 */
#include "adaptive_law.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(int argc, char** argv) {
  fathom_adaptive_law law;
  enum fathom_adaptive_integrator integrator = FATHOM_ADAPTIVE_RUNGE_KUTTA;
  double lambda[4], t, tau, v, estimate[4];
  int k;
  if (argc < 6) {
    fprintf(stderr, "adaptive_law: has %d gains, expected a_m l1 l2 l3 l4.\n", argc - 1);
    return 1;
  }
  for (k = 0; k < 4; ++k) lambda[k] = atof(argv[2 + k]);
  if (argc > 6 && strcmp(argv[6], "euler") == 0) integrator = FATHOM_ADAPTIVE_EULER;
  fathom_adaptive_start(&law, atof(argv[1]), lambda, integrator);
  while (scanf("%lf,%lf,%lf", &t, &tau, &v) == 3) {
    const enum fathom_adaptive_result result = fathom_adaptive_add(&law, t, tau, v);
    if (result != FATHOM_ADAPTIVE_OK) {
      fprintf(stderr,
              "adaptive_law: %s at t = %.17g.\n",
              result == FATHOM_ADAPTIVE_DIVERGED ? "the law diverged" : "a sample cannot be used",
              t);
      return 1;
    }
    fathom_adaptive_estimate(&law, estimate);
    printf(
        "%.17g,%.17g,%.17g,%.17g,%.17g\n", t, estimate[0], estimate[1], estimate[2], estimate[3]);
    fflush(stdout);
  }
  if (feof(stdin)) return 0;
  fprintf(stderr, "adaptive_law: a line is not t,tau,v. Leave the names of columns out.\n");
  return 1;
}
