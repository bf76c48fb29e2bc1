// SPDX-License-Identifier: MIT
// trig.h -- computes sine, cosine and arc tangent on the host, only with + - * /, for equal bits on every machine.
#ifndef TRIG_H
#define TRIG_H
#include "platform/exact_floats.h"

#define PI 3.14159265358979323846

// Computes sine and cosine of an angle, in radians, with an error below 1e-12. Both are NaN if the angle is not finite.
void sine_cosine(float angle, double* sine, double* cosine);

// Returns the angle of (x, y) in [-pi, pi], with an error below 1e-10; 0 for (0, 0).
double arc_tangent(double y, double x);

#endif
